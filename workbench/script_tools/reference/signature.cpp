// SPDX-License-Identifier: MIT
#include "workbench/script_tools/reference/signature.h"

#include <algorithm>
#include <stdexcept>

namespace reorient {
namespace {

std::string_view without_spaces(std::string_view text) {
  while (text.starts_with(' ')) text.remove_prefix(1);
  while (text.ends_with(' ')) text.remove_suffix(1);
  return text;
}

ArgumentDoc read_argument(std::string_view text, std::string_view signature) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos || colon == 0)
    throw std::invalid_argument("signature: expected an argument 'name: type', found '" + std::string(text) + "' in " +
                                std::string(signature));
  std::string_view name = without_spaces(text.substr(0, colon));
  const bool may_be_left_out = name.ends_with('?');
  if (may_be_left_out) name.remove_suffix(1);
  return {std::string(name), std::string(without_spaces(text.substr(colon + 1))) + (may_be_left_out ? "?" : "")};
}

/// Position of the bracket that closes the one at `open`.
std::size_t closing(std::string_view text, std::size_t open) {
  int depth = 0;
  for (std::size_t i = open; i < text.size(); ++i) {
    if (text[i] == '(') ++depth;
    if (text[i] == ')' && --depth == 0) return i;
  }
  throw std::invalid_argument("signature: missing closing bracket in " + std::string(text));
}

}  // namespace

std::vector<std::string_view> split_type(std::string_view text, char separator) {
  std::vector<std::string_view> parts;
  int depth = 0;
  bool is_quoted = false;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (c == '"') is_quoted = !is_quoted;
    if (c == '(' || c == '{' || c == '<') ++depth;
    if (c == ')' || c == '}' || c == '>') --depth;
    if (c != separator || depth > 0 || is_quoted) continue;
    parts.push_back(without_spaces(text.substr(begin, i - begin)));
    begin = i + 1;
  }
  if (!without_spaces(text.substr(begin)).empty()) parts.push_back(without_spaces(text.substr(begin)));
  return parts;
}

Signature read_signature(std::string_view text) {
  const std::size_t open = text.find('(');
  if (open == std::string_view::npos)
    throw std::invalid_argument("signature: missing brackets in " + std::string(text));
  const std::size_t close = closing(text, open);
  Signature signature;
  const std::string_view name = text.substr(0, open);
  const std::size_t dot = name.find('.');
  if (dot != std::string_view::npos) signature.table = name.substr(0, dot);
  signature.name = dot == std::string_view::npos ? name : name.substr(dot + 1);
  for (const std::string_view argument : split_type(text.substr(open + 1, close - open - 1), ','))
    signature.arguments.push_back(read_argument(argument, text));
  const std::string_view rest = without_spaces(text.substr(close + 1));
  if (rest.starts_with(':')) signature.result = without_spaces(rest.substr(1));
  return signature;
}

std::string to_annotation(const Signature& signature) {
  std::string text;
  std::string arguments;
  for (const ArgumentDoc& argument : signature.arguments) {
    const bool optional = argument.type.ends_with('?');
    const std::string type = optional ? argument.type.substr(0, argument.type.size() - 1) : argument.type;
    text += "---@param " + argument.name + (optional ? "? " : " ") + type + "\n";
    arguments += (arguments.empty() ? "" : ", ") + argument.name;
  }
  if (!signature.result.empty()) text += "---@return " + signature.result + "\n";
  return text + "function " + signature.full_name() + "(" + arguments + ") end";
}

}  // namespace reorient
