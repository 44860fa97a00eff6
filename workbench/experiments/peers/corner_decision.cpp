// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/corner_decision.h"

#include <algorithm>

namespace reorient {

void CornerDecision::restart() {
  ratio_ = 0.0;
  held_ = 0;
}

void CornerDecision::update(const CornerFit& believed, const CornerFit& mirrored, double coverage) {
  const auto limited = [](double value, double limit) { return std::clamp(value, -limit, limit); };
  const double of_frame = limited(believed.log_likelihood - mirrored.log_likelihood, parameters_.frame_limit);
  ratio_ = limited(parameters_.forgetting * ratio_ + of_frame, parameters_.total_limit);
  const bool may_flip = ratio_ <= parameters_.flip_at && mirrored.matches >= parameters_.least_matches &&
                        mirrored.matches >= parameters_.least_ratio * believed.matches &&
                        coverage >= parameters_.least_coverage;
  held_ = may_flip ? std::min(held_ + 1, parameters_.hold) : 0;
}

}  // namespace reorient
