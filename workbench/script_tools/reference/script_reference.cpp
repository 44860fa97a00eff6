// SPDX-License-Identifier: MIT
#include "workbench/script_tools/reference/script_reference.h"

#include <algorithm>
#include <map>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "engine/script/language/behavior_language.h"
#include "engine/script/sandbox/metatables.h"
#include "workbench/scenario/scenario_language.h"
#include "workbench/script_tools/reference/library_reference.h"
#include "workbench/script_tools/reference/signature.h"
#include "workbench/script_tools/reference/vocabulary.h"

namespace reorient {
namespace {

std::string signature(const ScriptFunction& function) {
  std::string text = function.full_name() + "(";
  for (std::size_t i = 0; i < function.arguments.size(); ++i) {
    const bool optional = function.arguments[i].type.ends_with('?');
    text += (i > 0 ? ", " : "") + function.arguments[i].name + (optional ? "?" : "");
  }
  return text + ")";
}

const ScenarioLanguage& scenarios() {
  static const ScenarioLanguage language;
  return language;
}

const BehaviorLanguage& behaviors() {
  static const BehaviorLanguage language;
  return language;
}

bool is_for_scenarios(std::string_view table) {
  const std::span<const WorldTable> all = behaviors().tables();
  return std::none_of(all.begin(), all.end(), [&](const WorldTable& row) { return row.name == table; });
}

/// The functions of both languages, each once, those of behaviors first.
std::vector<const ScriptFunction*> all_functions() {
  std::vector<const ScriptFunction*> all;
  for (const ScriptFunction& function : behaviors().functions()) all.push_back(&function);
  for (const ScriptFunction& function : scenarios().functions()) {
    const auto same = [&](const ScriptFunction* other) { return other->full_name() == function.full_name(); };
    if (std::none_of(all.begin(), all.end(), same)) all.push_back(&function);
  }
  return all;
}

void write_words(std::ostream& out, std::span<const ScriptWord> words) {
  for (const ScriptWord& word : words) {
    out << "### `" << word.name() << "`\n```lua\n" << word.usage << "\n```\n" << word.description << "\n\n";
  }
}

void write_annotations(std::ostream& out, std::span<const ScriptWord> words, std::span<const LibraryModule> libraries) {
  for (const ScriptWord& word : words) {
    out << "---" << word.description << "\n";
    if (word.name() == "require") write_require_overloads(out, libraries);
    out << (word.annotation.empty() ? to_annotation(read_signature(word.signature)) : std::string(word.annotation))
        << "\n\n";
  }
}

void write_world(std::ostream& out) {
  out << "## The world\nRead-only tables, updated before each frame. Reading an unknown name is an error.\n\n";
  for (const WorldTable& table : scenarios().tables()) {
    out << "### `" << table.name << "`" << (is_for_scenarios(table.name) ? " (scenarios only)" : "") << "\n"
        << table.description << "\n\n| field | type | unit | what it is |\n|---|---|---|---|\n";
    for (const WorldField& field : scenarios().world()) {
      if (field.table != table.name) continue;
      out << "| `" << field.full_name() << "` | " << field.type_name() << " | " << field.unit << " | "
          << field.description;
      const char* before = "; one of ";
      for (const std::string_view name : field.names) out << std::exchange(before, ", ") << "`" << name << "`";
      out << " |\n";
    }
    out << "\n";
  }
}

/// The names of the functions without the name of the table.
std::vector<std::string> names_in(const LibraryRow& row) {
  std::vector<std::string> names;
  for (std::string_view signature : row.signatures) {
    if (!row.table.empty()) signature.remove_prefix(row.table.size() + 1);
    names.emplace_back(signature.substr(0, signature.find_first_of("(:")));
  }
  return names;
}

void write_functions(std::ostream& out, const ScriptLanguage& language) {
  out << "| function | what it does |\n|---|---|\n";
  for (const ScriptFunction& function : language.functions()) {
    out << "| `" << signature(function) << "`" << (function.result.empty() ? "" : ": " + function.result) << " | "
        << function.description << " |\n";
  }
  out << "\n";
}

/// "\"abs\", \"acos\""
std::string quoted_list(std::span<const std::string> names, std::string_view separator = ", ") {
  std::string list;
  for (const std::string& name : names) list.append(list.empty() ? "" : separator).append("\"" + name + "\"");
  return list;
}

/// The globals of these words: "expect.state" belongs to the table expect.
std::set<std::string> first_names(std::span<const ScriptWord> words) {
  std::set<std::string> names;
  for (const ScriptWord& word : words) names.insert(std::string(word.name().substr(0, word.name().find('.'))));
  return names;
}

}  // namespace

std::string script_reference(std::span<const LibraryModule> libraries) {
  std::ostringstream out;
  out << "# Script reference\n"
         "Generated from the declarations that make the bindings, and from the libraries' doc comments; do not edit.\n"
         "`REORIENT_REGENERATE=1 ./test` regenerates it; `./reorient reference` writes one with your own libraries.\n\n"
         "A behavior is a file below `scripts/behaviors/`, a scenario is a file below `scripts/scenarios/`. Code for "
         "several scripts is in\n`scripts/lib/`. Lengths are in meters, angles in radians, times in seconds; x points "
         "forward, y left.\n\n## Words\n";
  write_words(out, language_words());
  out << "### A transition\n```lua\n{ \"target\", when = f, lasting = 0.5, after = \"settle\", because = \"the "
         "reason\" }\n```\n"
         "Leads to the state `target`. The name is searched among the inner states of the state, then among its "
         "siblings, then further out;\n`\"outer/inner\"` is a path from the top. The transition is taken if `when` "
         "returns true and has returned true for the time `lasting`\nwithout interruption, and if the state was "
         "entered at least the time `after` ago. Both times are a number of seconds, the name of a\nparam, or a "
         "function that returns seconds. `because` is the reason in the record. A machine takes at most one transition "
         "in a\nframe. Transitions of outer states come first, and within a state the `common` ones.\n\n";
  write_world(out);
  out << "## Functions\nFunctions have an effect, so call them in `enter`, `update` and `exit`, not in conditions.\n\n";
  out << "### In behaviors\n";
  write_functions(out, behaviors());
  out << "### In scenarios\n";
  write_functions(out, scenarios());
  out << "## Libraries\nThe values that `require` returns, from the doc comments in `scripts/lib/`.\n\n";
  write_libraries(out, libraries);
  out << "## From Lua's own library\n";
  for (const LibraryRow& row : library_rows()) {
    out << "- `" << (row.table.empty() ? "base" : row.table) << "`:";
    for (const std::string& name : names_in(row)) out << " " << name;
    out << "\n";
  }
  out << "\n`pairs` returns numbers and then names in ascending order, so that each run is the same. It rejects keys "
         "that are not numbers, texts\nor booleans. `next` follows the same order, but reads all keys in each call. A "
         "text in arithmetic is an error, even \"10\" + 1:\nwrite `tonumber(text)`. Table functions accept only tables "
         "without a metatable. Global "
         "variables are not possible: write `local`, or `keep` for\nvalues that survive a reload. A script may have at "
         "most "
      << Metatables::kMost
      << " metatables, so let tables of the same type share one.\n\n"
         "## Words of tests\n"
         "Files `scripts/tests/*_test.lua`, run by `reorient test`. A test cannot `require` a library: it loads a "
         "behavior or scenario\nthat uses the library.\n\n";
  write_words(out, test_words());
  std::string text = out.str();
  text.pop_back();  // the last blank line
  return text;
}

std::string script_annotations(std::span<const LibraryModule> libraries) {
  std::ostringstream out;
  out << "---@meta\n-- Functions and fields of scripts, for the Lua language server. Generated from the declarations "
         "that "
         "make the\n"
         "-- bindings, and from the libraries' doc comments; do not edit. `REORIENT_REGENERATE=1 ./test` regenerates "
         "it.\n\n";
  out << "---@class reorient.State\n---@field priority? number|table\n---@field initial? string\n---@field history? "
         "boolean\n---@field publishes? string\n---@field ends? \"done\"|\"failed\"\n"
         "---@field common? table[]\n---@field behaviors? string[]\n---@field room? string\n"
         "---@field hall_seed? integer\n---@field field? string\n---@field interface? string\n---@field enter? "
         "fun()\n---@field update? fun()\n"
         "---@field exit? fun()\n---@field [integer] table\n\n";
  for (const WorldTable& table : scenarios().tables()) {
    out << "---" << table.description << "\n---@class reorient." << table.name << "\n";
    for (const WorldField& field : scenarios().world()) {
      if (field.table != table.name) continue;
      std::string type(field.names.empty() ? field.type_name() : "");
      for (const std::string_view name : field.names) type += (type.empty() ? "\"" : "|\"") + std::string(name) + "\"";
      out << "---@field " << field.name << " " << type << " "
          << (field.unit.empty() ? "" : std::string(field.unit) + ", ") << field.description << "\n";
    }
    out << table.name << " = {}\n\n";
  }
  std::set<std::string> tables;
  for (const ScriptFunction* one : all_functions()) {
    const ScriptFunction& function = *one;
    // A class, so that an editor warns of functions that the table does not have.
    if (!function.table.empty() && tables.insert(function.table).second)
      out << "---@class reorient." << function.table << "\n" << function.table << " = {}\n\n";
    out << "---" << function.description << "\n"
        << to_annotation({function.table, function.name, function.arguments, function.result}) << "\n\n";
  }
  for (const FormerTable& former : scenarios().former_tables())
    out << "---@deprecated\n---@type reorient." << former.replacement << "\n"
        << former.name << " = " << former.replacement << "\n\n";
  write_library_annotations(out, libraries);
  write_annotations(out, language_words(), libraries);
  for (const NameType& type : name_types()) {
    const std::string names = quoted_list(type.names, "|");
    out << "---@alias " << type.type << " " << (names.empty() ? "string" : names) << "\n";
  }
  out << "---@alias reorient.InputValues table<string, any>\n";
  out << "\n---@class " << kWorldType << "\n";
  for (const WorldTable& table : scenarios().tables())
    out << "---@field " << table.name << "? table<string, number|boolean|string>\n";
  out << "\n---@class reorient.expect\nexpect = {}\n\n";
  write_annotations(out, test_words(), libraries);
  std::string text = out.str();
  text.pop_back();
  return text;
}

std::string script_luacheck() {
  std::map<std::string, std::string> tables;  // of the world and the functions, with their fields
  std::set<std::string> globals = first_names(language_words());
  const auto add = [&tables](std::string_view table, std::string_view name) {
    std::string& list = tables[std::string(table)];
    list.append(list.empty() ? "\"" : ", \"").append(name).append(1, '"');
  };
  for (const WorldField& field : scenarios().world()) add(field.table, field.name);
  for (const ScriptFunction* one : all_functions()) {
    const ScriptFunction& function = *one;
    if (function.table.empty()) {
      globals.insert(function.name);
    } else {
      add(function.table, function.name);
    }
  }
  for (const FormerTable& former : scenarios().former_tables())
    tables[std::string(former.name)] = tables[std::string(former.replacement)];
  std::ostringstream out;
  out << "-- For luacheck. Generated from the declarations that make the bindings; do not edit.\n"
         "-- `REORIENT_REGENERATE=1 ./test` regenerates it.\nlocal function fields(...)\n  local known = {}\n"
         "  for _, name in ipairs { ... } do known[name] = {} end\n  return { fields = known }\nend\n\n"
         "stds.reorient = { read_globals = {\n";
  for (const LibraryRow& row : library_rows()) {
    if (row.table.empty()) {
      out << "  " << quoted_list(names_in(row)) << ",\n";
    } else {
      out << "  " << row.table << " = fields(" << quoted_list(names_in(row)) << "),\n";
    }
  }
  const std::set<std::string> open{"action", "behaviors", "called", "input", "published"};
  for (const std::string& name : globals) {
    out << "  " << name << (open.contains(name) ? " = { other_fields = true },\n" : " = {},\n");
  }
  for (const auto& [table, names] : tables) out << "  " << table << " = fields(" << names << "),\n";
  out << "} }\nstds.reorient_test = { read_globals = {\n  expect = { other_fields = true },\n";
  for (const std::string& name : first_names(test_words())) {
    if (name != "expect") out << "  " << name << " = {},\n";
  }
  out << "} }\n\nstd = \"reorient\"\nfiles[\"**/*_test.lua\"].std = \"reorient+reorient_test\"\n"
         "exclude_files = { \"annotations\", \"**/annotations\" }\nmax_line_length = 140\n";
  return out.str();
}

}  // namespace reorient
