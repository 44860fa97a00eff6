// SPDX-License-Identifier: MIT
#include "workbench/experiments/charts/scale.h"

#include <algorithm>
#include <cmath>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr double kSlack = 1e-9;  // of a step: bounds that are ticks except for rounding

double inverse_sinh(double value) {
  const double size = std::abs(value);
  return std::copysign(pinned::log(size + std::sqrt(size * size + 1.0)), value);
}

double step_of(double span, int wanted) {
  const double rough = span / std::max(1, wanted);
  const double power = pinned::pow(10.0, std::floor(pinned::log10(rough)));
  for (const double step : {1.0, 2.0, 5.0}) {
    if (step * power >= rough * (1.0 - kSlack)) return step * power;
  }
  return 10.0 * power;
}

}  // namespace

double Scale::operator()(double number) const {
  const auto bent = [this](double value) { return linear > 0.0 ? inverse_sinh(value / linear) : value; };
  const double share = logarithmic ? pinned::log(number / low) / pinned::log(high / low)
                                   : (bent(number) - bent(low)) / (bent(high) - bent(low));
  return begin + share * (end - begin);
}

std::vector<double> ticks(double low, double high, int wanted) {
  const double step = step_of(high - low, wanted);
  const double first = std::ceil(low / step - kSlack), last = std::floor(high / step + kSlack);
  std::vector<double> all;
  for (int i = 0; i <= static_cast<int>(last - first); ++i) all.push_back((first + i) * step);
  return all;
}

std::vector<double> logarithmic_ticks(double low, double high) {
  // Over more than three decades, labels between the powers of ten would overlap.
  const bool is_long = high > 1000.0 * low;
  std::vector<double> all;
  for (double power = pinned::pow(10.0, std::floor(pinned::log10(low))); power <= high; power *= 10.0) {
    for (const double step : {1.0, 2.0, 5.0}) {
      if (is_long && step > 1.0) break;
      const double tick = step * power;
      if (tick >= low * (1.0 - kSlack) && tick <= high * (1.0 + kSlack)) all.push_back(tick);
    }
  }
  return all;
}

std::vector<double> signed_ticks(double low, double high) {
  std::vector<double> all{0.0};
  for (double power = 10.0; power <= std::max(-low, high); power *= 10.0) {
    if (power <= high) all.push_back(power);
    if (-power >= low) all.insert(all.begin(), -power);
  }
  return all;
}

int tick_digits(const std::vector<double>& ticks) {
  constexpr int kMostDigits = 6;
  double scale = 1.0;
  for (int digits = 0; digits < kMostDigits; ++digits, scale *= 10.0) {
    if (std::all_of(ticks.begin(), ticks.end(),
                    [&](double tick) { return std::abs(tick * scale - std::round(tick * scale)) < 1e-6; }))
      return digits;
  }
  return kMostDigits;
}

double round_up_to_tick(double high, int wanted) {
  const double step = step_of(high, wanted);
  return step * std::ceil(high / step - kSlack);
}

}  // namespace reorient
