// SPDX-License-Identifier: MIT
#include "robots/simulator/agents/players.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/transform.h"

namespace reorient {

Players::Players(int count, const FieldDimensions& field, const Eigen::Vector2d& keep_clear_of, std::uint64_t seed)
    : field_(field), random_(seed, 0x91a7e5) {
  constexpr double kApart = 0.7;  // m
  constexpr int kTries = 200;
  for (int i = 0; i < count; ++i) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      const Eigen::Vector2d position = random_position();
      const bool free = (position - keep_clear_of).norm() > kApart &&
                        std::all_of(players_.begin(), players_.end(), [&](const Player& other) {
                          return (other.pose.position - position).norm() > kApart;
                        });
      if (!free) continue;
      Player player;
      player.pose = Pose2(position, random_.uniform(-kPi, kPi));
      player.goal = random_position();
      player.stride = random_.uniform(0.0, 2.0 * kPi);
      player.team = i % 2;
      players_.push_back(player);
      break;
    }
  }
}

Eigen::Vector2d Players::random_position() {
  constexpr double kInside = 0.6;  // m from the lines, clear of the goals
  const double x = 0.5 * field_.length - kInside;
  const double y = 0.5 * field_.width - kInside;
  return {random_.uniform(-x, x), random_.uniform(-y, y)};
}

bool Players::barred(const Player& player, const Eigen::Vector2d& next, const Eigen::Vector2d& robot,
                     std::span<const Barrier> barriers) const {
  constexpr double kPersonalSpace = 0.45;  // m between the centers of two robots
  const auto closing = [&](const Eigen::Vector2d& other) {
    const double now = (player.pose.position - other).norm();
    const double then = (next - other).norm();
    return then < kPersonalSpace && then < now;
  };
  if (closing(robot)) return true;
  for (const Player& other : players_) {
    if (&other != &player && closing(other.pose.position)) return true;
  }
  return std::any_of(barriers.begin(), barriers.end(),
                     [&](const Barrier& barrier) { return clearance(barrier, next).distance < kRadius; });
}

void Players::advance(double time_step, const Eigen::Vector2d& robot, std::span<const Barrier> barriers) {
  constexpr double kSpeed = 0.12;     // m/s
  constexpr double kTurnSpeed = 0.5;  // rad/s
  constexpr double kStride = 10.0;    // rad/s
  for (Player& player : players_) {
    if (player.wait > 0.0) {
      player.wait -= time_step;
      continue;
    }
    const Eigen::Vector2d path = player.goal - player.pose.position;
    if (path.norm() < 0.1) {
      player.goal = random_position();
      player.wait = random_.uniform(0.5, 6.0);
      continue;
    }
    const double off = angle_difference(direction_of(path), player.pose.rotation);
    const double most = kTurnSpeed * time_step;
    player.pose.rotation = normalize_angle(player.pose.rotation + std::clamp(off, -most, most));
    player.stride = std::fmod(player.stride + kStride * time_step, 2.0 * kPi);
    if (std::abs(off) > 0.6) continue;
    const Eigen::Vector2d next = player.pose * Eigen::Vector2d(kSpeed * time_step, 0.0);
    if (barred(player, next, robot, barriers)) {
      player.goal = random_position();
      player.wait = random_.uniform(0.5, 2.0);
    } else {
      player.pose.position = next;
    }
  }
}

}  // namespace reorient
