// SPDX-License-Identifier: MIT
// How long something takes, where some trials end before it has happened.
#pragma once

#include <cstdint>
#include <vector>

#include "workbench/experiments/statistics/interval.h"

namespace reorient {

/// Of one trial.
struct CensoredTime {
  double seconds = 0.0;
  bool happened = true;  ///< false: it had not happened when the trial ended
};

/// One step of a curve: from `seconds` on, this share of the trials is to be expected without the event.
struct SurvivalStep {
  double seconds = 0.0;
  double share = 1.0;
  int at_risk = 0;  ///< trials that had lasted so long without it
  Interval band;    ///< of the share, point by point (Kalbfleisch and Prentice 1980: log-log, Greenwood's variance)
};
/// The product-limit estimate (Kaplan and Meier 1958): a step at each time at which it happened, in their order. A
/// trial that ends at the moment of an event was still at risk. Where the share becomes 0, the band's upper bound stays
/// as it was before: the formula knows none.
std::vector<SurvivalStep> kaplan_meier(std::vector<CensoredTime> times);

/// The time by which this share of the trials has seen the event; NaN: the curve does not come so far.
double time_by_which(const std::vector<SurvivalStep>& curve, double share);

/// NaN where there are none.
double mean(const std::vector<double>& values);
/// With linear interpolation between ranks (type 7 of Hyndman and Fan 1996). `share` in [0, 1]; NaN where there are
/// none.
double quantile(std::vector<double> values, double share);

/// Of the mean, by the percentiles of 2000 resamples (Efron 1979); one seed, one interval. Around NaN where there are
/// no values.
Interval bootstrap_interval(const std::vector<double>& values, std::uint64_t seed = 1);
/// The same of the median.
Interval bootstrap_median_interval(const std::vector<double>& values, std::uint64_t seed = 1);

}  // namespace reorient
