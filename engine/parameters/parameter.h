// SPDX-License-Identifier: MIT
// A tunable number: its name, what it means, what it may be, and who set it.
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

/// Who set a value. A later one outranks an earlier one: a file never undoes what the command line says.
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
  std::string description;           ///< what it is
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

/// Somebody wants a value.
struct ParameterChange {
  std::string name;
  std::string value;  ///< as a person writes it
  ParameterOrigin origin = ParameterOrigin::live;
  std::string source;  ///< where it was written, for messages: "team.toml:12"; may be empty
};
template <typename Visit, typename T>
requires std::same_as<std::remove_const_t<T>, ParameterChange>
void fields(Visit&& visit, T& change) { visit(change.name, change.value, change.origin, change.source); }

/// What became of such a change.
struct ParameterOutcome {
  std::string name;
  std::string value;    ///< as it is now; empty where there is no such parameter
  std::string refusal;  ///< empty: it was taken
};
template <typename Visit, typename T>
requires std::same_as<std::remove_const_t<T>, ParameterOutcome>
void fields(Visit&& visit, T& outcome) { visit(outcome.name, outcome.value, outcome.refusal); }

/// As a person writes it, and as parse_parameter() reads it back without loss.
std::string to_text(const ParameterValue& value);

/// Throws std::runtime_error with one line when `text` is not of the parameter's type or outside of its range.
ParameterValue parse_parameter(const ParameterDeclaration& parameter, std::string_view text);

/// The nearest value that the parameter may have; its default where `text` is not even of its type.
ParameterValue clamp_parameter(const ParameterDeclaration& parameter, std::string_view text);

/// "0 to 10 s", "true or false", "hellinger, ssd3".
std::string range_text(const ParameterDeclaration& parameter);

}  // namespace reorient
