// SPDX-License-Identifier: MIT
// Elementary functions with the same bits on every processor. The C library selects its code by the processor's
// features, and its results differ in the last bit with and without fused multiply-add. Everything that enters a record
// uses these functions. What IEEE 754 defines exactly (+ - * /, sqrt, fmod, remainder, floor, nearbyint) needs no
// replacement, as long as the compiler contracts nothing (-ffp-contract=off).
//
// The functions are SLEEF's consistent ones without fused multiply-add. Their error is within one unit in the last
// place (u10).
#pragma once

#include <cmath>
#include <span>

namespace reorient::pinned {

struct SinCos {
  double sin = 0.0;
  double cos = 1.0;
};

SinCos sincos(double angle);
double sin(double angle);
double cos(double angle);
double tan(double angle);
double asin(double value);
double acos(double value);
double atan(double value);
double atan2(double y, double x);
double sinh(double value);
double cosh(double value);
double tanh(double value);
double exp(double value);
double exp2(double value);
double expm1(double value);
double log(double value);
double log2(double value);
double log10(double value);
double pow(double base, double exponent);

/// Exact except for two roundings. Overflows if a square does.
inline double hypot(double x, double y) { return std::sqrt(x * x + y * y); }

// For many numbers at once: the same bits as one by one, at a third of the time. Outputs have the length of the inputs.
void exp(std::span<double> values);  ///< in place
void exp(std::span<float> values);   ///< in place
void sincos(std::span<const double> angles, std::span<double> sines, std::span<double> cosines);
void atan2(std::span<const double> y, std::span<const double> x, std::span<double> angles);
void atan2(std::span<const float> y, std::span<const float> x, std::span<float> angles);

}  // namespace reorient::pinned
