// SPDX-License-Identifier: MIT
// What a NAO's body felt lately, as the engine takes it: between two measurements it is interpolated.
#pragma once

#include <array>
#include <cstddef>
#include <optional>

#include "geometry/pose2.h"
#include "robots/nao/lola/measurement.h"
#include "robots/robot.h"

namespace reorient::nao {

class BodyHistory {
 public:
  struct Moment {
    BodySample body;
    Pose2 odometry;  ///< steps as a walk says, if there is one; turns from the inertial unit
  };

  /// In the order of their times; one that is not later than the last is left out. Times on any clock, s. What is not
  /// fresh is as it was.
  void add(const Measurement& measurement);

  /// Nothing: the body was not felt at that time or less than kGap before it.
  std::optional<Moment> at(double time) const;
  /// Returns nothing if none exists.
  std::optional<Moment> newest() const;

  static constexpr double kGap = 0.1;  // s

 private:
  void turn(const BodySample& body, double step);
  void walk(const Measurement& measurement);

  static constexpr std::size_t kKept = 64;  // three quarters of a second
  const Moment& from_end(std::size_t back) const { return moments_[(count_ - 1 - back) % kKept]; }

  std::array<Moment, kKept> moments_;
  std::size_t count_ = 0;
  Eigen::Vector2d position_ = Eigen::Vector2d::Zero();  // m
  std::optional<Pose2> walked_;                         // what the walk said last
  double yaw_ = 0.0;                                    // rad
  double bias_ = 0.0;                                   // rad/s, of the gyroscope about the vertical
  double still_for_ = 0.0;                              // s
};

}  // namespace reorient::nao
