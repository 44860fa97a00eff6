// SPDX-License-Identifier: MIT
// Elementary functions that give the same bits on every processor. Those of the C library choose their code by what the
// processor offers, and differ in the last bit with and without fused multiply-add. Everything that enters a record
// comes from here; what IEEE 754 defines exactly (+ - * /, sqrt, fmod, remainder, floor, nearbyint) needs no pinning,
// as long as nothing is contracted (-ffp-contract=off).
//
// The functions are SLEEF's consistent ones without fused multiply-add: within one unit in the last place (u10).
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

/// Exact but for two roundings; overflows where a square does.
inline double hypot(double x, double y) { return std::sqrt(x * x + y * y); }

// Of many at once: the same bits as one by one, at a third of the time. Outputs are as long as the inputs.
void exp(std::span<double> values);  ///< in place
void exp(std::span<float> values);   ///< in place
void sincos(std::span<const double> angles, std::span<double> sines, std::span<double> cosines);
void atan2(std::span<const double> y, std::span<const double> x, std::span<double> angles);
void atan2(std::span<const float> y, std::span<const float> x, std::span<float> angles);

}  // namespace reorient::pinned
