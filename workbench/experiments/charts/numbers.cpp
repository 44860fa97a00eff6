// SPDX-License-Identifier: MIT
#include "workbench/experiments/charts/numbers.h"

#include <array>
#include <charconv>
#include <cmath>

namespace reorient {
namespace {

constexpr const char* kUnknownNumber = "\u2013";

}  // namespace

std::string fixed(double value, int digits) {
  if (!std::isfinite(value)) return kUnknownNumber;
  std::array<char, 400> text{};  // the largest number has 309 digits
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits).ptr;
  std::string number(text.data(), end);
  if (number.find_first_not_of("-0.") == std::string::npos && number.starts_with('-')) number.erase(0, 1);
  return number;
}

std::string fixed(const std::optional<double>& value, int digits) {
  return value ? fixed(*value, digits) : kUnknownNumber;
}

std::string with_sign(double value, int digits) {
  const std::string number = fixed(value, digits);
  if (number.starts_with('-')) return "\u2212" + number.substr(1);
  return std::isfinite(value) && number.find_first_not_of("0.") != std::string::npos ? "+" + number : number;
}

std::string fixed(const Interval& interval, int digits) {
  return "[" + fixed(interval.low, digits) + ", " + fixed(interval.high, digits) + "]";
}

std::string percent(double share) { return fixed(100.0 * share, 0) + " %"; }

std::string p_value(double p) { return p < 0.001 ? "< 0.001" : fixed(p, 3); }

}  // namespace reorient
