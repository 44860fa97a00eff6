// SPDX-License-Identifier: MIT
// The other robots on the field. They walk to random goals in straight lines and wait while something is in the way.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "geometry/random.h"
#include "robots/simulator/body/barrier.h"

namespace reorient {

struct Player {
  Pose2 pose;
  Eigen::Vector2d goal = Eigen::Vector2d::Zero();  ///< m
  double stride = 0.0;                             ///< rad, phase of its steps
  double wait = 0.0;                               ///< s until it walks again
  int team = 0;                                    ///< 0 or 1
  bool is_lying = false;                           ///< on the ground, on its back
};

class Players {
 public:
  Players(int count, const FieldDimensions& field, const Eigen::Vector2d& keep_clear_of, std::uint64_t seed);

  /// Advances by `time_step` seconds. No player walks into `robot` (m) or into the barriers.
  void advance(double time_step, const Eigen::Vector2d& robot, std::span<const Barrier> barriers);

  /// Replaces all players, which another owner moves.
  void place(const std::vector<Player>& players) { players_ = players; }

  const std::vector<Player>& all() const { return players_; }

  static constexpr double kRadius = 0.16;  ///< m, for collisions

 private:
  Eigen::Vector2d random_position();
  bool barred(const Player& player, const Eigen::Vector2d& next, const Eigen::Vector2d& robot,
              std::span<const Barrier> barriers) const;

  FieldDimensions field_;
  Random random_;
  std::vector<Player> players_;
};

}  // namespace reorient
