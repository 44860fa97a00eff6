// SPDX-License-Identifier: MIT
// A parameter: name, description, range, value and origin.
#pragma once

#include <concepts>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

namespace reorient {

enum class ParameterKind { real, integer, boolean, choice };
constexpr int enum_count(ParameterKind) { return 4; }

/// In the order of ParameterKind; a choice is its name.
using ParameterValue = std::variant<double, int, bool, std::string>;

/// Origin of a value. A later origin has precedence: a file never replaces a value of the command line.
enum class ParameterOrigin { default_value, file, command_line, live };
constexpr int enum_count(ParameterOrigin) { return 4; }

std::string_view to_string(ParameterOrigin origin);

struct ParameterDeclaration {
  std::string name;  ///< "module.name" or "behavior.name"
  ParameterKind kind = ParameterKind::real;
  ParameterValue default_value = 0.0;  ///< the default
  double minimum = 0.0;                ///< of real and whole ones, both ends included
  double maximum = 0.0;
  std::string unit;
  std::string description;           ///< quantity and effect
  std::vector<std::string> choices;  ///< of a choice
};

template <typename Visit, typename T>
requires std::same_as<std::remove_const_t<T>, ParameterDeclaration>
void fields(Visit&& visit, T& declaration) {
  visit(declaration.name, declaration.kind, declaration.default_value, declaration.minimum, declaration.maximum,
        declaration.unit, declaration.description, declaration.choices);
}

struct Parameter : ParameterDeclaration {
  ParameterValue value = 0.0;
  ParameterOrigin origin = ParameterOrigin::default_value;
};
template <typename Visit, typename T>
requires std::same_as<std::remove_const_t<T>, Parameter>
void fields(Visit&& visit, T& parameter) {
  std::conditional_t<std::is_const_v<T>, const ParameterDeclaration, ParameterDeclaration>& declaration = parameter;
  fields(visit, declaration);
  visit(parameter.value, parameter.origin);
}

/// A request to set a value.
struct ParameterChange {
  std::string name;
  std::string value;  ///< as text
  ParameterOrigin origin = ParameterOrigin::live;
  std::string source;  ///< position for messages: "team.toml:12"; may be empty
};
template <typename Visit, typename T>
requires std::same_as<std::remove_const_t<T>, ParameterChange>
void fields(Visit&& visit, T& change) { visit(change.name, change.value, change.origin, change.source); }

/// Result of such a change.
struct ParameterOutcome {
  std::string name;
  std::string value;    ///< the current value; empty for an unknown parameter
  std::string refusal;  ///< empty: the change was accepted
};
template <typename Visit, typename T>
requires std::same_as<std::remove_const_t<T>, ParameterOutcome>
void fields(Visit&& visit, T& outcome) { visit(outcome.name, outcome.value, outcome.refusal); }

/// The value as text that parse_parameter() reads back without loss.
std::string to_text(const ParameterValue& value);

/// Throws std::runtime_error with one line when `text` is not of the parameter's type or outside of its range.
ParameterValue parse_parameter(const ParameterDeclaration& parameter, std::string_view text);

/// The nearest valid value; the default if `text` is not of the parameter's type.
ParameterValue clamp_parameter(const ParameterDeclaration& parameter, std::string_view text);

/// "0 to 10 s", "true or false", "hellinger, ssd3".
std::string range_text(const ParameterDeclaration& parameter);

}  // namespace reorient
