// A tunable number: its name, what it means, what it may be, and who set it.
#pragma once

#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace reorient {

enum class ParameterKind { real, integer, boolean, choice };

/// In the order of ParameterKind; a choice is its name.
using ParameterValue = std::variant<double, int, bool, std::string>;

/// Who set a value. A later one outranks an earlier one: a file never undoes what the command line says.
enum class ParameterOrigin { default_value, file, command_line, live };

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

struct Parameter : ParameterDeclaration {
  ParameterValue value = 0.0;
  ParameterOrigin origin = ParameterOrigin::default_value;
};

/// As a person writes it, and as parse_parameter() reads it back without loss.
std::string to_text(const ParameterValue& value);

/// Throws std::runtime_error with one line when `text` is not of the parameter's type or outside of its range.
ParameterValue parse_parameter(const ParameterDeclaration& parameter, std::string_view text);

/// The nearest value that the parameter may have; its default where `text` is not even of its type.
ParameterValue clamp_parameter(const ParameterDeclaration& parameter, std::string_view text);

/// "0 to 10 s", "true or false", "hellinger, ssd3".
std::string range_text(const ParameterDeclaration& parameter);

}  // namespace reorient
