// SPDX-License-Identifier: MIT
// ROC analysis: how well a number separates two classes.
#pragma once

#include <cstdint>
#include <vector>

#include "workbench/experiments/statistics/interval.h"

namespace reorient {

struct RocPoint {
  double false_positives = 0.0;  ///< fraction of the negative cases at or above a threshold
  double true_positives = 0.0;   ///< fraction of the positive cases
};
/// From (0, 0) to (1, 1), a point for each threshold; empty if one of the classes has no cases.
std::vector<RocPoint> roc_curve(std::vector<double> positives, std::vector<double> negatives);

/// Area below the curve: probability that a positive case has the larger number; equal numbers count half. NaN without
/// a curve.
double area_below(const std::vector<RocPoint>& curve);

/// The equal error rate: fraction of errors at the threshold with the same rate of false alarms and misses, by linear
/// interpolation between points of the curve. NaN without a curve.
double equal_error_rate(const std::vector<RocPoint>& curve);

/// Cases that depend on each other, as those of one trial do.
struct ScoredGroup {
  std::vector<double> positives;
  std::vector<double> negatives;
};
/// Interval of the area, by the percentiles of 2000 resamples of whole groups (Efron 1979); deterministic for a seed.
/// NaN without cases.
Interval bootstrap_area_interval(const std::vector<ScoredGroup>& groups, std::uint64_t seed = 1);

}  // namespace reorient
