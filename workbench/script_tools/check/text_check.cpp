// SPDX-License-Identifier: MIT
#include "workbench/script_tools/check/text_check.h"

#include "workbench/script_tools/check/script_reading.h"

namespace reorient {
namespace {

/// Signatures of a module's functions, from its text.
std::map<std::string, FunctionSymbol> returned_functions(const ScriptFacts& facts) {
  std::map<std::string, FunctionSymbol> functions;
  const auto table = facts.tables.find(facts.returned);
  if (table == facts.tables.end()) return functions;
  for (const auto& [name, field] : table->second.fields) {
    const auto function = facts.functions.find(field.function);
    if (field.writes == 1 && function != facts.functions.end()) functions[name] = function->second;
  }
  return functions;
}

}  // namespace

/// The first reading finds the locals that are assigned several times. The second finds all other types without any
/// assumption. The third refines them with the results of the second, and the fourth reports the findings.
TextCheck check_text(std::string_view text, const SymbolTable& known) {
  const syntax::Script script = syntax::read_script(text);
  ScriptFacts facts;
  const auto learn = [&] {
    ScriptReading reading(script, known, facts);
    reading.read();
    facts = std::move(reading.learned);
  };
  learn();
  facts.tables.clear();
  facts.functions.clear();
  for (auto& local : facts.assigned) local.second = kAnything;
  learn();
  learn();
  ScriptReading last(script, known, facts);
  last.read();
  return {std::move(last.findings), returned_functions(facts)};
}

}  // namespace reorient
