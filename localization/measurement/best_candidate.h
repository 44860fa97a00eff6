// SPDX-License-Identifier: MIT
// Of some poses that are drawn at random, the one that fits the observations best.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "localization/measurement/measurement_model.h"
#include "localization/particles/particle_set.h"

namespace reorient {

/// Keeps its memory from one choice to the next.
class BestCandidate {
 public:
  struct Choice {
    Pose2 pose;
    float cost = 0.0f;  ///< MeasurementModel::costs()
  };

  /// Calls draw() `wanted` times; each call gives a pose (std::optional<Pose2>) or nothing. Nothing: all calls did.
  template <typename Draw>
  std::optional<Choice> choose(std::size_t wanted, const MeasurementModel& observed, const Draw& draw) {
    if (candidates_.size() != wanted) candidates_ = ParticleSet(wanted);
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < wanted; ++i) {
      if (const std::optional<Pose2> candidate = draw()) candidates_.set_pose(drawn++, *candidate);
    }
    if (drawn == 0) return std::nullopt;
    observed.costs(candidates_, costs_);
    const auto best = std::min_element(costs_.begin(), costs_.begin() + static_cast<std::ptrdiff_t>(drawn));
    return Choice{candidates_.pose(static_cast<std::size_t>(best - costs_.begin())), *best};
  }

 private:
  ParticleSet candidates_;
  std::vector<float> costs_;
};

}  // namespace reorient
