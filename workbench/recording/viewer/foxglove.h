// The messages of Foxglove that its viewer, Lichtblick and others draw without being told how, of the schemas in
// foxglove_schemas.h. Frames: x forward, y left, z up, m, rad.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "geometry/pose2.h"
#include "geometry/transform.h"
#include "workbench/recording/viewer/foxglove_schemas.h"

namespace reorient::foxglove {

struct Color {
  double r = 1.0, g = 1.0, b = 1.0, a = 1.0;  ///< 0 to 1
};

Json time(double seconds);
Json point(const Eigen::Vector3d& point);
Json pose(const Pose2& pose);
Json color(const Color& color);

/// From the one frame to the other.
Json transform(double seconds, std::string_view parent, std::string_view child, const Isometry3& motion);
Isometry3 on_the_ground(const Pose2& pose);
/// What Foxglove calls a camera's frame, x right, y down, z ahead, in ours, x ahead, y left, z up.
Isometry3 camera_from_optical();

Json pose_in_frame(double seconds, std::string_view frame, const Pose2& where);
Json poses_in_frame(double seconds, std::string_view frame, std::span<const Pose2> poses);
Json camera_calibration(double seconds, std::string_view frame, const CameraModel& camera);
/// `data`: a JPEG.
Json compressed_image(double seconds, std::string_view frame, std::span<const std::byte> data);

enum class Level { debug = 1, info, warning, error };
Json log(double seconds, Level level, std::string_view name, std::string_view message, std::string_view file = "",
         int line = 0);

/// Something to be drawn in three dimensions. It stays until another of the same name comes.
class Entity {
 public:
  Entity(double seconds, std::string_view frame, std::string_view id);

  void lines(const std::vector<Eigen::Vector3d>& points, bool closed, double thickness, const Color& of);
  /// Pairs of points.
  void segments(const std::vector<Eigen::Vector3d>& points, double thickness, const Color& of);
  /// Its corners lie one after the other along its border.
  using Quad = std::array<Eigen::Vector3d, 4>;
  /// As many colours as there are.
  void quads(std::span<const Quad> quads, std::span<const Color> colors);
  void cylinder(const Eigen::Vector3d& foot, double height, double diameter, const Color& of);
  void text(const Eigen::Vector3d& where, std::string_view text, double size, const Color& of);

  /// A message of it alone.
  Json update() &&;

 private:
  Json json_;
};

/// Drawn on an image; pixels.
class Annotations {
 public:
  explicit Annotations(double seconds);

  void points(const std::vector<Eigen::Vector2d>& all, double size, const Color& color);
  void line(const std::vector<Eigen::Vector2d>& all, bool closed, double thickness, const Color& color);

  Json json() && { return std::move(json_); }

 private:
  void add(int type, const std::vector<Eigen::Vector2d>& all, double thickness, const Color& of);

  Json time_, json_;
};

}  // namespace reorient::foxglove
