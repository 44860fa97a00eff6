// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/parameter.h"
#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

template <typename Number>
std::optional<Number> read_number(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// The number in `text`, whether or not it is in range.
std::optional<double> read_any(const ParameterDeclaration& parameter, std::string_view text) {
  const std::optional<double> number = read_number<double>(text);
  if (!number || !std::isfinite(*number)) return std::nullopt;
  if (parameter.kind == ParameterKind::integer && *number != std::round(*number)) return std::nullopt;
  return number;
}

ParameterValue as_value(const ParameterDeclaration& parameter, double number) {
  if (parameter.kind == ParameterKind::integer) return static_cast<int>(number);
  return number + 0.0;  // -0 becomes 0, as in TOML
}

std::optional<bool> read_boolean(std::string_view text) {
  if (text == "true" || text == "yes" || text == "on" || text == "1") return true;
  if (text == "false" || text == "no" || text == "off" || text == "0") return false;
  return std::nullopt;
}

std::runtime_error refusal(const ParameterDeclaration& parameter, std::string_view text, const std::string& expected,
                           const std::string& hint = "") {
  return std::runtime_error("parameter " + as_line(parameter.name) + ": invalid value '" + as_line(text.substr(0, 60)) +
                            "' (" + expected + ")" + hint);
}

}  // namespace

std::string_view to_string(ParameterOrigin origin) {
  switch (origin) {
    case ParameterOrigin::default_value:
      return "default";
    case ParameterOrigin::file:
      return "file";
    case ParameterOrigin::command_line:
      return "command line";
    case ParameterOrigin::live:
      return "live";
  }
  return "";
}

std::string to_text(const ParameterValue& value) {
  if (const auto* real = std::get_if<double>(&value)) {
    if (std::isnan(*real)) return "nan";  // not "-nan": the sign of 0/0 depends on the processor
    char buffer[32];
    const auto [end, error] = std::to_chars(std::begin(buffer), std::end(buffer), *real);
    return {buffer, error == std::errc() ? end : buffer};
  }
  if (const auto* whole = std::get_if<int>(&value)) return std::to_string(*whole);
  if (const auto* yes = std::get_if<bool>(&value)) return *yes ? "true" : "false";
  return std::get<std::string>(value);
}

std::string range_text(const ParameterDeclaration& parameter) {
  if (parameter.kind == ParameterKind::boolean) return "true or false";
  if (parameter.kind == ParameterKind::choice) {
    std::string list;
    for (const std::string& choice : parameter.choices) list += (list.empty() ? "" : ", ") + choice;
    return list;
  }
  const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
  return to_text(as_value(parameter, parameter.minimum)) + " to " + to_text(as_value(parameter, parameter.maximum)) +
         unit;
}

ParameterValue parse_parameter(const ParameterDeclaration& parameter, std::string_view text) {
  if (parameter.kind == ParameterKind::boolean) {
    if (const std::optional<bool> yes = read_boolean(text)) return *yes;
    throw refusal(parameter, text, "expected true or false");
  }
  if (parameter.kind == ParameterKind::choice) {
    const auto found = std::find(parameter.choices.begin(), parameter.choices.end(), text);
    if (found != parameter.choices.end()) return *found;
    throw refusal(parameter, text, "expected one of " + range_text(parameter), did_you_mean(text, parameter.choices));
  }
  const std::optional<double> number = read_any(parameter, text);
  const char* kind = parameter.kind == ParameterKind::integer ? "a whole number" : "a number";
  if (!number) throw refusal(parameter, text, std::string("expected ") + kind + " from " + range_text(parameter));
  if (*number < parameter.minimum || *number > parameter.maximum) {
    throw refusal(parameter, text, "expected " + range_text(parameter));
  }
  return as_value(parameter, *number);
}

ParameterValue clamp_parameter(const ParameterDeclaration& parameter, std::string_view text) {
  try {
    return parse_parameter(parameter, text);
  } catch (const std::runtime_error&) {
    const bool numeric = parameter.kind == ParameterKind::real || parameter.kind == ParameterKind::integer;
    const std::optional<double> number = numeric ? read_any(parameter, text) : std::nullopt;
    if (!number) return parameter.default_value;
    return as_value(parameter, std::clamp(*number, parameter.minimum, parameter.maximum));
  }
}

}  // namespace reorient
