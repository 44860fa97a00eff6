// SPDX-License-Identifier: MIT
// A round hall with painted panels, and a robot in it that scans with its head: a closed loop for tests.
#pragma once

#include <vector>

#include "geometry/head.h"
#include "geometry/random.h"
#include "geometry/transform.h"
#include "perception/room/room_awareness.h"

namespace reorient::test {

/// Effect of the hall's light and the camera's settings on a color.
struct Exposure {
  double gain = 1.0;
  double cb_shift = 0.0;
  double cr_shift = 0.0;
};

class PaintedRoom {
 public:
  static PaintedRoom colorful(std::uint64_t seed);
  static PaintedRoom symmetric(std::uint64_t seed);  ///< the same after a rotation by 180 degrees
  static PaintedRoom plain();                        ///< white all around

  Image render(const CameraModel& camera, const Isometry3& field_from_camera, const Exposure& exposure,
               Random& noise) const;

  double radius = 8.0;

 private:
  static constexpr int kColumns = 24;
  static constexpr int kRows = 3;
  Ycbcr color(const Eigen::Vector3d& eye, const Eigen::Vector3d& direction) const;

  std::vector<Ycbcr> panels_;
};

/// The published method: the values of assets/parameters/paper.toml that belong to the room.
inline RoomParameters paper_recipe() {
  RoomParameters paper;
  paper.perception.min_coverage = 0.6;
  paper.light.enabled = false;
  paper.color.blur = 0.05;
  paper.distance.measure = Distance::ssd3;
  paper.distance.cap = 2.0;
  paper.background.time_constant = 100.0 / 30.0;
  paper.background.true_mean_start = false;
  paper.background.prior_deviation = 0.0;
  paper.background.trusted_after = 0.0;
  paper.view_filter.method = ViewMethod::particles;
  paper.view_filter.sharpness = 150.0;
  paper.view_filter.clear_lead = 0.0;
  paper.confidence.time_constant = 60.5 / 30.0;
  paper.confidence.true_mean_start = false;
  paper.confidence.restart_on_purge = true;
  return paper;
}

inline CameraModel small_camera() {
  return CameraModel::from_fields_of_view(160, 120, from_degrees(56.3), from_degrees(43.7));
}

/// The camera of a robot that stands upright.
inline Isometry3 standing_camera(double yaw, double pitch = 0.0) {
  const RobotDimensions dimensions;
  return robot_from_camera(dimensions, {yaw, pitch}, {}, dimensions.torso_height);
}

/// A robot that stands in the room and scans with its head, with a belief that may be wrong.
class ScanningRobot {
 public:
  ScanningRobot(const PaintedRoom& where, const RoomParameters& parameters, std::uint64_t seed)
      : room(where), awareness(parameters, seed), noise_(seed, 7) {}

  /// Scans for some seconds; frames at 15 Hz.
  void run(double seconds);
  /// The current frame of the robot. The image is valid until the next call.
  RoomObservation look();

  PaintedRoom room;
  RoomAwareness awareness;
  Pose2 truth{-3.2, -3.5, kPi / 2};
  Pose2 belief = truth;
  Exposure exposure;
  bool train = true;
  bool evaluate = true;
  double time = 0.0;

 private:
  Random noise_;
  Image image_;
};

}  // namespace reorient::test
