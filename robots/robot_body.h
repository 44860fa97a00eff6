// SPDX-License-Identifier: MIT
// Which robot it is, as its data file says (assets/robots/): what of it the engine, behaviours and the simulator have
// to know. The defaults are the NAO v6.
#pragma once

#include <optional>
#include <string>

#include "geometry/angle.h"
#include "geometry/camera.h"
#include "geometry/const_or.h"
#include "geometry/head.h"

namespace reorient {

/// One of its cameras: a lens with a little barrel distortion, unless it has another one.
struct CameraOptics : Lens {
  CameraOptics() { k1 = 0.03; }

  int width = 640;   ///< pixels
  int height = 480;  ///< pixels
  /// rad, through the image center: without the distortion of a pinhole, with that of a fisheye
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

/// Its model for images of this size.
CameraModel camera_model(const CameraOptics& optics, int width, int height);

/// How it walks.
struct Gait {
  double forward = 0.25;        ///< m/s, at most, and backward
  double left = 0.15;           ///< m/s, at most, to either side
  double turn = 0.8;            ///< rad/s, at most
  double cruise = 0.2;          ///< m/s, at which it goes far
  double step_frequency = 1.9;  ///< Hz, double steps
  double sway_roll = 0.035;     ///< rad, amplitude of the torso's roll at full speed
  double sway_pitch = 0.015;    ///< rad
  double sway_height = 0.006;   ///< m, of the torso's height
};
template <typename Visit, ConstOr<Gait> T>
void fields(Visit&& visit, T& gait) {
  visit(gait.forward, gait.left, gait.turn, gait.cruise, gait.step_frequency, gait.sway_roll, gait.sway_pitch,
        gait.sway_height);
}

struct RobotBody {
  std::string name = "NAO v6";
  std::string field = "spl";  ///< on which it plays: the name of a shipped one
  RobotDimensions dimensions;
  double lying_height = 0.09;  ///< m, of the torso's origin
  NeckReach neck;
  double head_speed = 8.0;    ///< rad/s, at most
  CameraOptics upper_camera;  ///< the only one, where it has one
  std::optional<CameraOptics> lower_camera{CameraOptics()};
  std::optional<double> standing_load{5.3};  ///< kg on both feet of a standing robot; none: they feel nothing
  std::optional<Gait> gait{Gait()};          ///< none: it does not walk
  std::optional<double> get_up_time{6.0};    ///< s; none: it stays where it fell
};
template <typename Visit, ConstOr<RobotBody> T>
void fields(Visit&& visit, T& body) {
  visit(body.name, body.field, body.dimensions, body.lying_height, body.neck, body.head_speed, body.upper_camera,
        body.lower_camera, body.standing_load, body.gait, body.get_up_time);
}

/// Equal for equal bodies, and hardly ever for others.
std::uint64_t digest_of(const RobotBody& body);

/// Of the upper camera above the ground, m: the robot stands and looks straight ahead.
double standing_camera_height(const RobotBody& body);

}  // namespace reorient
