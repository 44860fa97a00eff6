// SPDX-License-Identifier: MIT
#include "program/commands/tables_command.h"

#include <memory>
#include <ostream>
#include <stdexcept>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>

#include "engine/parameters/utf8.h"
#include "program/experiment/outputs/page_tables.h"
#include "program/help.h"
#include "program/options.h"
#include "program/program.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/input_file.h"

namespace reorient {
namespace {

std::string text_of(const std::filesystem::path& file) { return read_named_input(file, "a text"); }

/// The results that a page names are relative to its folder.
std::string filled(const std::filesystem::path& page, const std::string& text) {
  try {
    return with_tables(text, [&page](const std::filesystem::path& named) {
      const std::filesystem::path file = page.parent_path() / named;
      std::error_code error;
      const bool is_note = named.string().ends_with(".run.json");
      return is_note && !std::filesystem::exists(file, error) ? std::string() : text_of(file);
    });
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(as_line(page.string() + ": " + error.what()));
  }
}

/// Writes nothing if one of the pages has a mistake.
void fill(const std::vector<std::filesystem::path>& pages) {
  std::vector<std::pair<std::filesystem::path, std::string>> changed;
  bool is_any_with_tables = false;
  for (const std::filesystem::path& page : pages) {
    const std::string before = text_of(page);
    if (!has_tables(before)) continue;
    is_any_with_tables = true;
    if (std::string after = filled(page, before); after != before) changed.emplace_back(page, std::move(after));
  }
  if (!is_any_with_tables)
    throw std::runtime_error(as_line(pages.front().string()) +
                             ": expected a comment <!-- rows … --> (docs/experiments.md), found none");
  for (const auto& [page, text] : changed) write_whole_file(page, text);
}

}  // namespace

Subcommand add_tables(CLI::App& experiment) {
  const auto pages = std::make_shared<std::vector<std::filesystem::path>>();
  CLI::App* const parser = experiment.add_subcommand("tables", "fill the tables of Markdown pages from results");
  set_examples(*parser, {{"reorient experiment tables docs/evidence/*.md", "update the tables of several pages"},
                         {"reorient experiment tables report.md", "fill a page of yours"}});
  parser
      ->add_option("pages", *pages,
                   "Markdown pages with comments that name the rows (docs/experiments.md); others are skipped")
      ->type_name("PAGE")
      ->check(check_not_empty)
      ->required();
  return {parser, [pages](std::ostream&, std::ostream&) {
            fill(*pages);
            return kSuccess;
          }};
}

}  // namespace reorient
