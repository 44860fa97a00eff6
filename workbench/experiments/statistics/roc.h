// How well a number tells one case from the other.
#pragma once

#include <vector>

namespace reorient {

struct RocPoint {
  double false_positives = 0.0;  ///< share of the negative cases at or above a threshold
  double true_positives = 0.0;   ///< share of the positive ones
};
/// From (0, 0) to (1, 1), a point for each threshold; empty where one of the two has no cases.
std::vector<RocPoint> roc_curve(std::vector<double> positives, std::vector<double> negatives);

/// The area below: how often a positive case has the larger number, equal ones half. NaN where there is no curve.
double area_below(const std::vector<RocPoint>& curve);

}  // namespace reorient
