// SPDX-License-Identifier: MIT
// The recent measurements of a NAO's body, interpolated at any time between two measurements for the engine.
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
    Pose2 odometry;  ///< translation from the walk, if one runs; rotation from the inertial unit
  };

  /// Adds a measurement. Ignores it if it is not later than the last one. Times are in s, on any clock. Values that are
  /// not fresh are unchanged.
  void add(const Measurement& measurement);

  /// Returns nothing if no measurement exists at that time or within kGap before it.
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
  std::optional<Pose2> walked_;                         // last odometry of the walk
  double yaw_ = 0.0;                                    // rad
  double bias_ = 0.0;                                   // rad/s, of the gyroscope about the vertical
  double still_for_ = 0.0;                              // s
};

}  // namespace reorient::nao
