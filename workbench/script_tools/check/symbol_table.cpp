#include "workbench/script_tools/check/symbol_table.h"

#include <sstream>

#include "engine/script/language/behavior_language.h"
#include "workbench/scenario/scenario_language.h"
#include "workbench/script_tools/reference/vocabulary.h"

namespace reorient {
namespace {

void add_library(SymbolTable& known) {
  for (const LibraryRow& row : library_rows()) {
    std::istringstream names{std::string(row.names)};
    for (std::string name; names >> name;) {
      if (row.table.empty()) {
        known.globals.insert(name);
      } else {
        known.globals.insert(std::string(row.table));
        known.tables[std::string(row.table)].fields.insert(name);
      }
    }
  }
}

void add_words(std::span<const ScriptWord> words, SymbolTable& known) {
  for (const ScriptWord& word : words) {
    const std::string name(word.name);
    const std::size_t dot = name.find('.');
    known.globals.insert(name.substr(0, dot));
    if (dot != std::string::npos) known.tables[name.substr(0, dot)].fields.insert(name.substr(dot + 1));
  }
}

/// Which of the functions act, so that a condition must not call them: what gives nothing back is called for its
/// effect.
void add_language(const ScriptLanguage& language, SymbolTable& known) {
  for (const WorldField& field : language.world()) {
    known.globals.insert(std::string(field.table));
    known.tables[std::string(field.table)].fields.insert(std::string(field.name));
    if (field.type == WorldField::Type::name) known.names[field.full_name()] = {field.names.begin(), field.names.end()};
  }
  for (const ScriptFunction& function : language.functions()) {
    FunctionSymbol signature{{}, function.result.empty()};
    for (const ArgumentDoc& argument : function.arguments) signature.argument_types.push_back(argument.type);
    if (function.table.empty()) {
      known.globals.insert(function.name);
      known.functions[function.name] = std::move(signature);
    } else {
      known.globals.insert(function.table);
      known.tables[function.table].fields.insert(function.name);
      known.tables[function.table].functions[function.name] = std::move(signature);
    }
  }
}

}  // namespace

SymbolTable symbol_table(ScriptRole role) {
  SymbolTable known;
  add_library(known);
  if (role == ScriptRole::test) {
    add_words(test_words(), known);
    return known;
  }
  add_words(language_words(), known);
  if (role == ScriptRole::behavior) known.globals.erase("scenario");
  if (role == ScriptRole::scenario) known.globals.erase("behavior");
  // A library serves both: what only one of them has is known there too.
  if (role != ScriptRole::scenario) add_language(BehaviorLanguage(), known);
  if (role != ScriptRole::behavior) add_language(ScenarioLanguage(), known);
  return known;
}

}  // namespace reorient
