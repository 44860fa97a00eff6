// SPDX-License-Identifier: MIT
// `reorient new behavior NAME`: writes a small working script with a test that passes, to start from.
#include <memory>
#include <ostream>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "engine/parameters/utf8.h"
#include "program/commands/script_templates.h"
#include "program/help.h"
#include "program/options.h"
#include "program/program.h"
#include "program/script_names.h"
#include "program/shell_word.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

struct NewOptions {
  std::string kind;
  std::string name;
  std::filesystem::path scripts;
};

std::string named(std::string text, const std::string& name) {
  const std::string blank = "NAME";
  for (std::size_t at = text.find(blank); at != std::string::npos; at = text.find(blank, at + name.size()))
    text.replace(at, blank.size(), name);
  return text;
}

int make(const NewOptions& options, std::ostream& out) {
  require_script_name(options.name);
  const bool is_behavior = options.kind == "behavior";
  const std::filesystem::path root = scripts_root(options.scripts, Scripts::may_come);
  const std::filesystem::path script = root / (is_behavior ? "behaviors" : "scenarios") / (options.name + ".lua");
  const std::filesystem::path test = root / "tests" / (options.name + "_test.lua");
  for (const std::filesystem::path& file : {script, test}) {
    if (std::filesystem::exists(file))
      throw std::runtime_error(file.string() + ": expected a new file, found an existing one; choose another name");
  }
  for (const std::filesystem::path& file : {script, test}) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error)
      throw std::runtime_error("cannot create the folder " + file.parent_path().string() + ": " + error.message());
  }
  const std::string where = options.scripts.empty() ? "" : " --scripts " + shell_word(options.scripts.string());
  write_whole_file(script, named(script_template(options.kind), options.name));
  write_whole_file(test, named(script_template(options.kind + "_test"), options.name));
  out << as_line(script.string()) << "\n"
      << as_line(test.string()) << "\nNext: reorient check" << where << ", then reorient test "
      << shell_word(test.string()) << where << "\n";
  return kSuccess;
}

}  // namespace

Subcommand add_new(CLI::App& program) {
  const auto options = std::make_shared<NewOptions>();
  CLI::App* const parser =
      program.add_subcommand("new", "write a small working script with its test, to start from")->fallthrough();
  set_examples(*parser, {{"reorient new behavior ball_search", "a behavior and its test"},
                         {"reorient new scenario two_robots", "a scenario and its test"}});
  parser->add_option("kind", options->kind, "type of script: behavior or scenario")
      ->type_name("KIND")
      ->check(CLI::IsMember({"behavior", "scenario"}))
      ->required();
  parser->add_option("name", options->name, "name of the script: a-z, 0-9 and _")->type_name("NAME")->required();
  add_scripts_option(*parser, options->scripts, kPlainGroup);
  return {parser, [options](std::ostream& out, std::ostream&) { return make(*options, out); }};
}

}  // namespace reorient
