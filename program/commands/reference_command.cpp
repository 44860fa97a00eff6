// SPDX-License-Identifier: MIT
// `reorient reference`: functions and fields of scripts, and the libraries below the scripts' root; or the values and
// actions of an application's interface.
#include <memory>
#include <ostream>

#include <CLI/CLI.hpp>

#include "program/help.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/program.h"
#include "program/run/venue.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/script_files.h"
#include "workbench/script_tools/reference/interface_reference.h"
#include "workbench/script_tools/reference/script_reference.h"

namespace reorient {
namespace {

struct ReferenceOptions {
  std::filesystem::path scripts;
  std::string format = "markdown";
  std::filesystem::path interface;
  std::filesystem::path out;
};

std::string text_of(const ReferenceOptions& options, const std::filesystem::path& root) {
  const bool is_page = options.format == "markdown";
  if (!options.interface.empty()) {
    const ApplicationInterface declared = interface_named(options.interface);
    return is_page ? interface_reference(declared) : interface_annotations(declared);
  }
  const std::vector<LibraryModule> libraries = library_modules(read_scripts(root));
  return is_page ? script_reference(libraries) : script_annotations(libraries);
}

int reference(const ReferenceOptions& options, std::ostream& out) {
  const std::filesystem::path root = scripts_root(options.scripts);
  require_writable_output(options.out, "--out", root);
  const std::string text = text_of(options, root);
  if (options.out.empty()) {
    out << text;
  } else {
    write_whole_file(options.out, text);
  }
  return kSuccess;
}

}  // namespace

Subcommand add_reference(CLI::App& program) {
  const auto options = std::make_shared<ReferenceOptions>();
  CLI::App* const parser =
      program.add_subcommand("reference", "print the functions and fields for scripts, your libraries included")
          ->fallthrough();
  set_examples(*parser, {{"reorient reference --out reference.md", "as a Markdown page"},
                         {"reorient reference --format annotations --out reorient.lua", "for an editor"},
                         {"reorient reference --interface ball", "values and actions of an application"}});
  parser->add_option("--format", options->format, "format: markdown or annotations (for the Lua language server)")
      ->type_name("FORMAT")
      ->check(CLI::IsMember({"markdown", "annotations"}))
      ->capture_default_str();
  parser
      ->add_option("--interface", options->interface,
                   "print the values and actions of an application instead: a file, or a name in assets/interfaces")
      ->type_name("INTERFACE");
  parser->add_option("--out", options->out, "file to write (default: the standard output)")->type_name("FILE");
  add_scripts_option(*parser, options->scripts, kPlainGroup);
  return {parser, [options](std::ostream& out, std::ostream&) { return reference(*options, out); }};
}

}  // namespace reorient
