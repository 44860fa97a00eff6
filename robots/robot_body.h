// SPDX-License-Identifier: MIT
// The body of a robot, read from its data file in assets/robots/: everything about it that the engine, the behaviors
// and the simulator use. The defaults are those of the NAO v6.
#pragma once

#include <optional>
#include <string>

#include "geometry/angle.h"
#include "geometry/camera.h"
#include "geometry/const_or.h"
#include "geometry/head.h"

namespace reorient {

/// One of its cameras. The default lens has a small barrel distortion.
struct CameraOptics : Lens {
  CameraOptics() { k1 = 0.03; }

  int width = 640;   ///< pixels
  int height = 480;  ///< pixels
  /// rad, through the image center: without the distortion for a pinhole lens, with it for a fisheye lens
  double field_of_view_horizontal = from_degrees(56.3);
  double field_of_view_vertical = from_degrees(43.7);
  std::optional<Eigen::Vector2d> center;  ///< principal point, pixels; empty: the image center
  double rate = 30.0;                     ///< images per second

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const bool has_more = archive_width_and_lens(archive, self.width, self, self.is_plain() && !self.center);
    archive(self.height, self.field_of_view_horizontal, self.field_of_view_vertical, self.k1, self.k2, self.rate);
    if (has_more) {
      archive(self.center);
    } else if constexpr (Archive::kReads) {
      self.center.reset();
    }
  }
};

/// Returns the model of this camera for images of this size.
CameraModel camera_model(const CameraOptics& optics, int width, int height);

/// The abilities of its walk.
struct Gait {
  double forward = 0.25;        ///< largest speed forward and backward, m/s
  double left = 0.15;           ///< largest speed to either side, m/s
  double turn = 0.8;            ///< largest rotation, rad/s
  double cruise = 0.2;          ///< walking speed over long distances, m/s
  double step_frequency = 1.9;  ///< Hz, double steps
  double sway_roll = 0.035;     ///< rad, amplitude of the torso's roll at full speed
  double sway_pitch = 0.015;    ///< rad, amplitude of the torso's pitch at full speed
  double sway_height = 0.006;   ///< m, amplitude of the torso's height at full speed
};
template <typename Visit, ConstOr<Gait> T>
void fields(Visit&& visit, T& gait) {
  visit(gait.forward, gait.left, gait.turn, gait.cruise, gait.step_frequency, gait.sway_roll, gait.sway_pitch,
        gait.sway_height);
}

struct RobotBody {
  std::string name = "NAO v6";
  std::string field = "spl";  ///< name of the shipped field on which it plays
  RobotDimensions dimensions;
  double lying_height = 0.09;  ///< m, of the torso's origin
  NeckReach neck;
  double head_speed = 8.0;    ///< largest speed of the head, rad/s
  CameraOptics upper_camera;  ///< or the only camera
  std::optional<CameraOptics> lower_camera{CameraOptics()};
  std::optional<double> standing_load{5.3};  ///< kg on both feet of a standing robot; empty: no load sensors
  std::optional<Gait> gait{Gait()};          ///< empty: the robot cannot walk
  std::optional<double> get_up_time{6.0};    ///< s; empty: the robot cannot get up
};
template <typename Visit, ConstOr<RobotBody> T>
void fields(Visit&& visit, T& body) {
  visit(body.name, body.field, body.dimensions, body.lying_height, body.neck, body.head_speed, body.upper_camera,
        body.lower_camera, body.standing_load, body.gait, body.get_up_time);
}

/// Digest over all values: equal for equal bodies, and almost always different for different bodies.
std::uint64_t digest_of(const RobotBody& body);

/// Height of the upper camera above the ground, m, while the robot stands and looks straight ahead.
double standing_camera_height(const RobotBody& body);

}  // namespace reorient
