// SPDX-License-Identifier: MIT
// How well a number separates two classes.
#pragma once

#include <cstdint>
#include <vector>

#include "workbench/experiments/statistics/interval.h"

namespace reorient {

struct RocPoint {
  double false_positives = 0.0;  ///< share of the negative cases at or above a threshold
  double true_positives = 0.0;   ///< share of the positive ones
};
/// From (0, 0) to (1, 1), a point for each threshold; empty where one of the two has no cases.
std::vector<RocPoint> roc_curve(std::vector<double> positives, std::vector<double> negatives);

/// The area below: how often a positive case has the larger number, equal ones half. NaN where there is no curve.
double area_below(const std::vector<RocPoint>& curve);

/// The share of errors at the threshold at which as many negative cases are taken for positive ones as the other way
/// round, between two points of the curve on a straight line. NaN where there is no curve.
double equal_error_rate(const std::vector<RocPoint>& curve);

/// Cases that depend on each other, as those of one trial do.
struct ScoredGroup {
  std::vector<double> positives;
  std::vector<double> negatives;
};
/// Of the area, by the percentiles of 2000 resamples of whole groups (Efron 1979); one seed, one interval. Around NaN
/// where there are no cases.
Interval bootstrap_area_interval(const std::vector<ScoredGroup>& groups, std::uint64_t seed = 1);

}  // namespace reorient
