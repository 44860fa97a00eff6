// SPDX-License-Identifier: MIT
#include "workbench/script_tools/check/type_symbols.h"

#include <utility>

namespace reorient {
namespace {

/// "{ from: string, file: string? }": a table with only these fields, each optional and of its type.
Symbol record(std::string_view type, const NamedTypes& named) {
  auto table = std::make_shared<TableSymbol>();
  table->missing = "unknown field '";
  for (const std::string_view field : split_type(type.substr(1, type.size() - 2), ',')) {
    const std::size_t colon = field.find(':');
    if (colon == std::string_view::npos) return {kTable};  // {} and the like
    table->fields[std::string(field.substr(0, colon))] = symbol_of_type(field.substr(colon + 1), named);
  }
  return {kTable, std::move(table)};
}

ValueTypes plain_type(std::string_view type) {
  constexpr std::pair<std::string_view, ValueTypes> kTypes[] = {
      {"number", kNumber}, {"integer", kNumber}, {"string", kString},     {"boolean", kBoolean},
      {"nil", kNil},       {"table", kTable},    {"function", kFunction}, {"fun", kFunction}};
  for (const auto& [name, types] : kTypes) {
    if (name == type) return types;
  }
  return kAnything;
}

}  // namespace

Symbol symbol_of_type(std::string_view type, const NamedTypes& named) {
  while (type.starts_with(' ')) type.remove_prefix(1);
  if (type.ends_with('?')) {
    Symbol symbol = symbol_of_type(type.substr(0, type.size() - 1), named);
    symbol.types |= kNil;
    return symbol;
  }
  if (const std::vector<std::string_view> parts = split_type(type, '|'); parts.size() > 1) {
    Symbol all{0};
    for (const std::string_view part : parts) all.types |= symbol_of_type(part, named).types;
    return all;
  }
  if (type.ends_with("[]")) return {kTable};
  if (type.starts_with('{') && type.ends_with('}')) return record(type, named);
  const std::string_view name = type.substr(0, type.find_first_of(" (<"));  // also "boolean is_correct"
  if (const auto found = named.find(name); found != named.end()) return found->second;
  return {plain_type(name)};
}

FunctionSymbol symbol_of_function(const Signature& signature, const NamedTypes& named) {
  FunctionSymbol function;
  for (const ArgumentDoc& argument : signature.arguments) {
    ArgumentSymbol symbol{argument.name, symbol_of_type(argument.type, named), argument.type.ends_with('?'),
                          argument.type == "reorient.StatePath"};
    if (argument.name == "...") {
      function.more = std::move(symbol);
    } else {
      function.arguments.push_back(std::move(symbol));
    }
  }
  const std::vector<std::string_view> results = split_type(signature.result, ',');
  function.result = results.empty() ? kNil : symbol_of_type(results.front(), named).types;
  function.most_results = !results.empty() && results.back() == "..." ? kMany : results.size();
  return function;
}

}  // namespace reorient
