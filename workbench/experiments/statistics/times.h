// SPDX-License-Identifier: MIT
// Statistics of times, with trials that end before the event (censored).
#pragma once

#include <cstdint>
#include <vector>

#include "workbench/experiments/statistics/interval.h"

namespace reorient {

/// The time of one trial.
struct CensoredTime {
  double seconds = 0.0;
  bool happened = true;  ///< false: it had not happened when the trial ended
};

/// One step of a curve: after `seconds`, this fraction of the trials is expected without the event.
struct SurvivalStep {
  double seconds = 0.0;
  double share = 1.0;
  int at_risk = 0;  ///< trials that lasted until then without the event
  Interval band;    ///< of the fraction, point by point (Kalbfleisch and Prentice 1980: log-log, Greenwood's variance)
};
/// The product-limit estimate (Kaplan and Meier 1958): a step at each time at which it happened, in their order. A
/// trial that ends at the time of an event was still at risk. If the fraction becomes 0, the band's upper bound keeps
/// its last value, because the formula has none.
std::vector<SurvivalStep> kaplan_meier(std::vector<CensoredTime> times);

/// The time by which the event has happened in this fraction of the trials; NaN: the curve does not reach it.
double time_by_which(const std::vector<SurvivalStep>& curve, double share);

/// NaN without values.
double mean(const std::vector<double>& values);
/// With linear interpolation between ranks (type 7 of Hyndman and Fan 1996). `share` in [0, 1]; NaN without
/// values.
double quantile(std::vector<double> values, double share);

/// Interval of the mean, by the percentiles of 2000 resamples (Efron 1979); deterministic for a seed. NaN without
/// values.
Interval bootstrap_interval(const std::vector<double>& values, std::uint64_t seed = 1);
/// The same of the median.
Interval bootstrap_median_interval(const std::vector<double>& values, std::uint64_t seed = 1);

}  // namespace reorient
