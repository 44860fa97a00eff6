// SPDX-License-Identifier: MIT
#include "engine/script/language/script_arguments.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace reorient {
namespace {

std::string_view kind_text(const ParameterDeclaration& argument) {
  switch (argument.kind) {
    case ParameterKind::real:
      return "a number";
    case ParameterKind::integer:
      return "a whole number";
    case ParameterKind::boolean:
      return "true or false";
    case ParameterKind::choice:
      return "a string";
  }
  return "";
}

[[noreturn]] void refuse(const ParameterDeclaration& argument, const std::string& expected,
                         const ParameterValue& value) {
  const std::string name = argument.name.substr(argument.name.rfind('.') + 1);
  throw std::runtime_error(name + ": expected " + expected + ", found " + to_text(value));
}

double number_of(const ParameterValue& value) {
  if (const auto* const whole = std::get_if<int>(&value)) return *whole;
  const auto* const real = std::get_if<double>(&value);
  return real != nullptr ? *real : std::numeric_limits<double>::quiet_NaN();
}

ParameterValue fitted_number(const ParameterDeclaration& argument, const ParameterValue& value, OutOfRange policy) {
  const double given = number_of(value);
  const bool is_whole = argument.kind == ParameterKind::integer;
  if (!std::isfinite(given) || (is_whole && given != std::floor(given)))
    refuse(argument, std::string(kind_text(argument)), value);
  const double number = std::clamp(given, argument.minimum, argument.maximum);
  if (policy == OutOfRange::refuse && number != given) refuse(argument, range_text(argument), value);
  return is_whole ? ParameterValue(static_cast<int>(number)) : ParameterValue(number);
}

}  // namespace

std::optional<ParameterValue> parameter_value(lua_State* L, int index) {
  switch (lua_type(L, index)) {
    case LUA_TNUMBER:
      return lua_tonumber(L, index);
    case LUA_TBOOLEAN:
      return lua_toboolean(L, index) != 0;
    case LUA_TSTRING: {
      std::size_t length = 0;
      const char* const text = lua_tolstring(L, index, &length);
      return std::string(text, length);
    }
    default:
      return std::nullopt;
  }
}

ParameterValue fitted_argument(const ParameterDeclaration& argument, const ParameterValue& value, OutOfRange policy) {
  if (argument.kind == ParameterKind::real || argument.kind == ParameterKind::integer)
    return fitted_number(argument, value, policy);
  if (value.index() != argument.default_value.index()) refuse(argument, std::string(kind_text(argument)), value);
  if (argument.kind == ParameterKind::choice) {
    const auto& choices = argument.choices;
    if (std::find(choices.begin(), choices.end(), std::get<std::string>(value)) == choices.end())
      refuse(argument, range_text(argument), value);
  }
  return value;
}

}  // namespace reorient
