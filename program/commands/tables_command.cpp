// SPDX-License-Identifier: MIT
#include "program/commands/tables_command.h"

#include <memory>
#include <ostream>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "engine/parameters/utf8.h"
#include "program/experiment/outputs/page_tables.h"
#include "program/options.h"
#include "program/program.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

std::string text_of(const std::filesystem::path& file) {
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) throw std::runtime_error(as_line(file.string()) + " cannot be read");
  return *text;
}

void fill(const std::filesystem::path& page) {
  const std::string before = text_of(page);
  std::string after;
  try {
    after = with_tables(before, [&page](const std::filesystem::path& named) {
      const std::filesystem::path file = page.parent_path() / named;
      std::error_code error;
      const bool is_note = named.string().ends_with(".run.json");
      return is_note && !std::filesystem::exists(file, error) ? std::string() : text_of(file);
    });
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(as_line(page.string() + ": " + error.what()));
  }
  if (after != before) write_whole_file(page, after);
}

}  // namespace

Subcommand add_tables(CLI::App& experiment) {
  const auto page = std::make_shared<std::filesystem::path>();
  CLI::App* const parser = experiment.add_subcommand("tables", "make the tables of a Markdown page from results");
  parser->add_option("page", *page, "a page with comments that ask for rows (docs/experiments.md)")
      ->check(check_not_empty)
      ->required();
  return {parser, [page](std::ostream&, std::ostream&) {
            fill(*page);
            return kSuccess;
          }};
}

}  // namespace reorient
