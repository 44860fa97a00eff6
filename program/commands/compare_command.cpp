// SPDX-License-Identifier: MIT
#include "program/commands/compare_command.h"

#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>

#include "engine/parameters/utf8.h"
#include "program/experiment/outputs/rows_comparison.h"
#include "program/help.h"
#include "program/options.h"
#include "program/program.h"

namespace reorient {
namespace {

struct CompareOptions {
  std::filesystem::path first;
  std::filesystem::path second;  ///< empty: two choices of the first are compared
  std::string axis, from, to;
};

PairedRows paired_rows(const CompareOptions& options) {
  if (options.axis.empty() == options.second.empty())
    throw std::runtime_error("expected two tables, or one with --axis NAME --from CHOICE --to CHOICE");
  if (!options.axis.empty()) return pair_choices(read_rows(options.first), options.axis, options.from, options.to);
  return pair_rows({as_line(options.first.string()), read_rows(options.first)},
                   {as_line(options.second.string()), read_rows(options.second)});
}

}  // namespace

Subcommand add_compare(CLI::App& experiment) {
  const auto options = std::make_shared<CompareOptions>();
  CLI::App* const parser = experiment.add_subcommand("compare", "compare two tables of results, pair by pair");
  set_examples(*parser, {{"reorient experiment compare before.json after.json", "two tables"},
                         {"reorient experiment compare table.json --axis light --from same --to hard",
                          "two choices of an axis"}});
  parser->add_option("first", options->first, "table that 'reorient experiment --json FILE' wrote")
      ->type_name("FIRST")
      ->check(check_not_empty)
      ->required();
  parser->add_option("second", options->second, "second table, without --axis")
      ->type_name("SECOND")
      ->check(check_not_empty);
  CLI::Option* const axis =
      parser->add_option("--axis", options->axis, "axis whose choices are compared within the first table")
          ->type_name("NAME")
          ->check(check_not_empty);
  CLI::Option* const from =
      parser->add_option("--from", options->from, "first choice of --axis")->type_name("CHOICE")->needs(axis);
  CLI::Option* const to =
      parser->add_option("--to", options->to, "second choice of --axis")->type_name("CHOICE")->needs(axis);
  // One option each, because the parser reports the first missing one by its address.
  axis->needs(from);
  from->needs(to);
  return {parser, [options](std::ostream& out, std::ostream&) {
            print_comparison(paired_rows(*options), out);
            return kSuccess;
          }};
}

}  // namespace reorient
