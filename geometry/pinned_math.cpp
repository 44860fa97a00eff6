// SPDX-License-Identifier: MIT
#include "geometry/pinned_math.h"

#include <cstddef>

#include <sleef.h>

namespace reorient::pinned {

// Each build for x86-64 has SSE4.1 (cmake/targets.cmake). SLEEF's functions for two numbers take half of the time of
// those for one, even if only one number is computed.
#ifdef __SSE4_1__

namespace {
double first(__m128d pair) { return _mm_cvtsd_f64(pair); }
__m128d both(double value) { return _mm_set1_pd(value); }
}  // namespace

SinCos sincos(double angle) {
  const Sleef___m128d_2 result = Sleef_cinz_sincosd2_u10sse4(both(angle));
  return {first(result.x), first(result.y)};
}
double tan(double angle) { return first(Sleef_cinz_tand2_u10sse4(both(angle))); }
double asin(double value) { return first(Sleef_cinz_asind2_u10sse4(both(value))); }
double acos(double value) { return first(Sleef_cinz_acosd2_u10sse4(both(value))); }
double atan(double value) { return first(Sleef_cinz_atand2_u10sse4(both(value))); }
double atan2(double y, double x) { return first(Sleef_cinz_atan2d2_u10sse4(both(y), both(x))); }
double sinh(double value) { return first(Sleef_cinz_sinhd2_u10sse4(both(value))); }
double cosh(double value) { return first(Sleef_cinz_coshd2_u10sse4(both(value))); }
double tanh(double value) { return first(Sleef_cinz_tanhd2_u10sse4(both(value))); }
double exp(double value) { return first(Sleef_cinz_expd2_u10sse4(both(value))); }
double exp2(double value) { return first(Sleef_cinz_exp2d2_u10sse4(both(value))); }
double expm1(double value) { return first(Sleef_cinz_expm1d2_u10sse4(both(value))); }
double log(double value) { return first(Sleef_cinz_logd2_u10sse4(both(value))); }
double log2(double value) { return first(Sleef_cinz_log2d2_u10sse4(both(value))); }
double log10(double value) { return first(Sleef_cinz_log10d2_u10sse4(both(value))); }
double pow(double base, double exponent) { return first(Sleef_cinz_powd2_u10sse4(both(base), both(exponent))); }

void exp(std::span<double> values) {
  std::size_t i = 0;
  for (; i + 2 <= values.size(); i += 2) _mm_storeu_pd(&values[i], Sleef_cinz_expd2_u10sse4(_mm_loadu_pd(&values[i])));
  if (i < values.size()) values[i] = exp(values[i]);
}

void exp(std::span<float> values) {
  std::size_t i = 0;
  for (; i + 4 <= values.size(); i += 4) _mm_storeu_ps(&values[i], Sleef_cinz_expf4_u10sse4(_mm_loadu_ps(&values[i])));
  for (; i < values.size(); ++i) values[i] = _mm_cvtss_f32(Sleef_cinz_expf4_u10sse4(_mm_set1_ps(values[i])));
}

void sincos(std::span<const double> angles, std::span<double> sines, std::span<double> cosines) {
  std::size_t i = 0;
  for (; i + 2 <= angles.size(); i += 2) {
    const Sleef___m128d_2 result = Sleef_cinz_sincosd2_u10sse4(_mm_loadu_pd(&angles[i]));
    _mm_storeu_pd(&sines[i], result.x);
    _mm_storeu_pd(&cosines[i], result.y);
  }
  if (i == angles.size()) return;
  const SinCos last = sincos(angles[i]);
  sines[i] = last.sin;
  cosines[i] = last.cos;
}

void atan2(std::span<const double> y, std::span<const double> x, std::span<double> angles) {
  std::size_t i = 0;
  for (; i + 2 <= angles.size(); i += 2)
    _mm_storeu_pd(&angles[i], Sleef_cinz_atan2d2_u10sse4(_mm_loadu_pd(&y[i]), _mm_loadu_pd(&x[i])));
  if (i < angles.size()) angles[i] = atan2(y[i], x[i]);
}

void atan2(std::span<const float> y, std::span<const float> x, std::span<float> angles) {
  std::size_t i = 0;
  for (; i + 4 <= angles.size(); i += 4)
    _mm_storeu_ps(&angles[i], Sleef_cinz_atan2f4_u10sse4(_mm_loadu_ps(&y[i]), _mm_loadu_ps(&x[i])));
  for (; i < angles.size(); ++i)
    angles[i] = _mm_cvtss_f32(Sleef_cinz_atan2f4_u10sse4(_mm_set1_ps(y[i]), _mm_set1_ps(x[i])));
}

#else

SinCos sincos(double angle) {
  const Sleef_double_2 result = Sleef_cinz_sincosd1_u10purec(angle);
  return {result.x, result.y};
}
double tan(double angle) { return Sleef_cinz_tand1_u10purec(angle); }
double asin(double value) { return Sleef_cinz_asind1_u10purec(value); }
double acos(double value) { return Sleef_cinz_acosd1_u10purec(value); }
double atan(double value) { return Sleef_cinz_atand1_u10purec(value); }
double atan2(double y, double x) { return Sleef_cinz_atan2d1_u10purec(y, x); }
double sinh(double value) { return Sleef_cinz_sinhd1_u10purec(value); }
double cosh(double value) { return Sleef_cinz_coshd1_u10purec(value); }
double tanh(double value) { return Sleef_cinz_tanhd1_u10purec(value); }
double exp(double value) { return Sleef_cinz_expd1_u10purec(value); }
double exp2(double value) { return Sleef_cinz_exp2d1_u10purec(value); }
double expm1(double value) { return Sleef_cinz_expm1d1_u10purec(value); }
double log(double value) { return Sleef_cinz_logd1_u10purec(value); }
double log2(double value) { return Sleef_cinz_log2d1_u10purec(value); }
double log10(double value) { return Sleef_cinz_log10d1_u10purec(value); }
double pow(double base, double exponent) { return Sleef_cinz_powd1_u10purec(base, exponent); }

void exp(std::span<double> values) {
  for (double& value : values) value = exp(value);
}

void exp(std::span<float> values) {
  for (float& value : values) value = Sleef_cinz_expf1_u10purec(value);
}

void sincos(std::span<const double> angles, std::span<double> sines, std::span<double> cosines) {
  for (std::size_t i = 0; i < angles.size(); ++i) {
    const SinCos one = sincos(angles[i]);
    sines[i] = one.sin;
    cosines[i] = one.cos;
  }
}

void atan2(std::span<const double> y, std::span<const double> x, std::span<double> angles) {
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = atan2(y[i], x[i]);
}

void atan2(std::span<const float> y, std::span<const float> x, std::span<float> angles) {
  for (std::size_t i = 0; i < angles.size(); ++i) angles[i] = Sleef_cinz_atan2f1_u10purec(y[i], x[i]);
}

#endif

// SLEEF's functions for sine alone and for sine and cosine sometimes differ in the last bit.
double sin(double angle) { return sincos(angle).sin; }
double cos(double angle) { return sincos(angle).cos; }

}  // namespace reorient::pinned
