// SPDX-License-Identifier: MIT
// The mathematics of Lua's `math` and `^`, and numbers as text: CMakeLists.txt in this folder renames the functions
// that the Lua library uses of the C library.
#include <cmath>
#include <cstdarg>
#include <cstddef>
#include <cstdio>
#include <string_view>

#include "geometry/pinned_math.h"

namespace {

/// As vsnprintf, for the formats of Lua, which contain at most one conversion. The sign of 0/0 is negative on x86-64
/// and positive on ARM; a text must not depend on it.
int print_number(char* text, std::size_t size, const char* format, va_list arguments) {
  const std::string_view all = format;
  const std::size_t begin = all.find('%');
  const std::size_t end = begin == all.npos ? begin : all.find_first_not_of("-+ #0123456789.", begin + 1);
  if (end != all.npos && std::string_view("aAeEfFgG").find(all[end]) != all.npos) {
    const double number = va_arg(arguments, double);
    return std::snprintf(text, size, format, std::isnan(number) ? std::fabs(number) : number);
  }
  return std::vsnprintf(text, size, format, arguments);
}

}  // namespace

extern "C" {
double reorient_pinned_sin(double value) { return reorient::pinned::sin(value); }
double reorient_pinned_cos(double value) { return reorient::pinned::cos(value); }
double reorient_pinned_tan(double value) { return reorient::pinned::tan(value); }
double reorient_pinned_asin(double value) { return reorient::pinned::asin(value); }
double reorient_pinned_acos(double value) { return reorient::pinned::acos(value); }
double reorient_pinned_atan2(double y, double x) { return reorient::pinned::atan2(y, x); }
double reorient_pinned_sinh(double value) { return reorient::pinned::sinh(value); }
double reorient_pinned_cosh(double value) { return reorient::pinned::cosh(value); }
double reorient_pinned_tanh(double value) { return reorient::pinned::tanh(value); }
double reorient_pinned_exp(double value) { return reorient::pinned::exp(value); }
double reorient_pinned_log(double value) { return reorient::pinned::log(value); }
double reorient_pinned_log2(double value) { return reorient::pinned::log2(value); }
double reorient_pinned_log10(double value) { return reorient::pinned::log10(value); }
double reorient_pinned_pow(double base, double exponent) { return reorient::pinned::pow(base, exponent); }
int reorient_pinned_snprintf(char* text, std::size_t size, const char* format, ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = print_number(text, size, format, arguments);
  va_end(arguments);
  return length;
}
/// The C library's version with checks: it also gets flags and the size of the array.
int reorient_pinned_snprintf_chk(char* text, std::size_t size, int /*flags*/, std::size_t /*array*/, const char* format,
                                 ...) {
  va_list arguments;
  va_start(arguments, format);
  const int length = print_number(text, size, format, arguments);
  va_end(arguments);
  return length;
}
}
