// SPDX-License-Identifier: MIT
// Chooses, of some random poses, the one that fits the observations best.
#pragma once

#include <algorithm>
#include <cstddef>
#include <optional>
#include <vector>

#include "localization/measurement/measurement_model.h"
#include "localization/particles/particle_set.h"

namespace reorient {

/// Reuses its memory for all choices.
class BestCandidate {
 public:
  struct Choice {
    Pose2 pose;
    float cost = 0.0f;  ///< MeasurementModel::costs()
  };

  /// Calls draw() `count` times; each call returns a std::optional<Pose2>. Empty if no call returned a pose.
  template <typename Draw>
  std::optional<Choice> choose(std::size_t count, const MeasurementModel& observed, const Draw& draw) {
    if (candidates_.size() != count) candidates_ = ParticleSet(count);
    std::size_t drawn = 0;
    for (std::size_t i = 0; i < count; ++i) {
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
