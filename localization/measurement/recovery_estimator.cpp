// SPDX-License-Identifier: MIT
#include "localization/measurement/recovery_estimator.h"

#include <algorithm>
#include <cmath>

#include "geometry/pinned_math.h"

namespace reorient {

void RecoveryEstimator::update(double fit, double elapsed, double slow_time, double fast_time) {
  age_ += elapsed;
  fast_age_ += elapsed;
  const auto approach = [&](double from, double age, double time) {
    const double fraction = age <= time ? elapsed / age : 1.0 - pinned::exp(-elapsed / time);
    return from + fraction * (fit - from);
  };
  if (fast_age_ <= 0.0) return;
  slow_ = approach(slow_, age_, slow_time);
  fast_ = approach(fast_, fast_age_, fast_time);
}

void RecoveryEstimator::see_nothing(double elapsed, double blind_time) { fast_ *= pinned::exp(-elapsed / blind_time); }

/// Checks the state after reading.
void RecoveryEstimator::complete() const {
  for (const double age : {age_, fast_age_})
    check_bytes(age >= 0.0 && std::isfinite(age), "pose filter: an age of the fit is negative or not finite");
  for (const double fit : {slow_, fast_})
    check_bytes(fit >= 0.0 && fit <= 1.0, "pose filter: the fit is outside of 0 to 1");
}

double RecoveryEstimator::recovery_probability(double margin) const {
  return slow_ > 0.0 ? std::clamp(1.0 - fast_ / (margin * slow_), 0.0, 1.0) : 0.0;
}

}  // namespace reorient
