// SPDX-License-Identifier: MIT
// The mathematics of Lua's `math` and `^`: CMakeLists.txt in this folder renames the functions that the Lua library
// uses of the C library.
#include "geometry/pinned_math.h"

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
}
