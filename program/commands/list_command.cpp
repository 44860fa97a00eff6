// SPDX-License-Identifier: MIT
// `reorient list`: the names that a command line can use.
#include <algorithm>
#include <memory>
#include <ostream>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "program/help.h"
#include "program/options.h"
#include "program/program.h"
#include "program/shell/catalog.h"
#include "program/subcommand.h"

namespace reorient {
namespace {

struct ListOptions {
  std::string kind;
  std::filesystem::path scripts;
  bool names = false;
};

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const CatalogKind& kind : catalog()) names.emplace_back(kind.name);
  return names;
}

void print(const CatalogKind& kind, const std::filesystem::path& scripts, bool only_names, std::ostream& out) {
  constexpr std::size_t kWidestName = 26;
  const std::vector<CatalogEntry> entries = kind.entries(scripts);
  if (!only_names) out << kind.name << ": " << kind.use << "\n";
  std::size_t column = 0;
  for (const CatalogEntry& entry : entries) column = std::max(column, std::min(entry.name.size(), kWidestName) + 4);
  for (const CatalogEntry& entry : entries)
    out << (only_names ? as_line(entry.name) + "\n" : wrapped(as_line(entry.name), as_line(entry.text), column));
}

int list(const ListOptions& options, std::ostream& out) {
  const std::filesystem::path scripts = scripts_root(options.scripts, Scripts::may_come);
  if (!options.kind.empty()) {
    const CatalogKind* const kind = catalog_kind(options.kind);
    const std::vector<std::string> known = kind_names();
    if (kind == nullptr) {
      const std::string hint = did_you_mean(options.kind, known);
      throw std::runtime_error("unknown kind '" + options.kind + "'" +
                               (hint.empty() ? " (expected " + list_of(known) + ")" : hint));
    }
    print(*kind, scripts, options.names, out);
    return kSuccess;
  }
  for (const CatalogKind& kind : catalog()) {
    if (&kind != catalog().data() && !options.names) out << "\n";
    print(kind, scripts, options.names, out);
  }
  return kSuccess;
}

}  // namespace

Subcommand add_list(CLI::App& program) {
  const auto options = std::make_shared<ListOptions>();
  CLI::App* const parser =
      program.add_subcommand("list", "list scenarios, behaviors, experiments and other names")->fallthrough();
  set_examples(*parser, {{"reorient list", "all kinds"},
                         {"reorient list scenarios", "one kind"},
                         {"reorient list behaviors --names", "names only, one in a line, for scripts"}});
  parser->add_option("kind", options->kind, "kind: " + list_of(kind_names()) + " (default: all)")->type_name("KIND");
  parser->add_flag("--names", options->names, "print only the names");
  add_scripts_option(*parser, options->scripts, kPlainGroup);
  return {parser, [options](std::ostream& out, std::ostream&) { return list(*options, out); }};
}

}  // namespace reorient
