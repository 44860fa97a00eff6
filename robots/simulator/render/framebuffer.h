// SPDX-License-Identifier: MIT
// The renderer's output for each pixel, which is the sensor's input.
#pragma once

#include <cstdint>
#include <vector>

#include <Eigen/Geometry>

#include "geometry/camera.h"

namespace reorient {

/// What most of a pixel shows.
enum class Label : std::uint8_t { floor, carpet, line, goal, ball, robot, wall, ceiling, person };

/// Linear light and depth of every pixel, row by row.
struct Frame {
  int width = 0;
  int height = 0;
  std::vector<float> red, green, blue;
  std::vector<float> depth;   ///< m along the optical axis; for a lens that is not perspective, along the pixel's ray
  std::vector<Label> labels;  ///< empty unless requested

  Frame(int columns, int rows, bool with_labels)
      : width(columns),
        height(rows),
        red(size()),
        green(size()),
        blue(size()),
        depth(size()),
        labels(with_labels ? size() : 0) {}

  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t row(int y) const { return static_cast<std::size_t>(y) * static_cast<std::size_t>(width); }
};

/// Angle between two vectors of any length, rad.
float angle_between(const Eigen::Vector3f& a, const Eigen::Vector3f& b);

/// A square of pixels (limits are inclusive) and the cone that contains their rays.
struct RayBlock {
  int left, top, right, bottom;
  Eigen::Vector3f axis;  ///< unit vector in the camera frame
  float half_angle;      ///< rad
  float cosine, sine;    ///< of half_angle
};

/// The directions of the pixels' rays in the camera frame: with x = 1 for a perspective lens, else of unit length. The
/// image must be at least 8 pixels wide.
struct RayTable {
  explicit RayTable(const CameraModel& model);

  CameraModel camera;
  std::vector<float> forward;   ///< x of the direction; empty for a perspective lens, where x is 1
  std::vector<float> left, up;  ///< y and z of the direction
  std::vector<float> length;    ///< of the direction
  float most_left = 0.0f, most_right = 0.0f, most_up = 0.0f, most_down = 0.0f;  ///< steepest directions of all pixels
  float pixel_angle = 0.0f;      ///< rad that a pixel spans at the image's center
  float slack = 0.0f;            ///< pixels by which a ray may deviate from the camera model
  float angle_slack = 0.0f;      ///< the same in rad
  std::vector<RayBlock> blocks;  ///< cover the image; empty for a simple pinhole
  float most_off_axis = 0.0f;    ///< rad, largest angle of all pixels to the optical axis; only with blocks

  bool is_perspective() const { return forward.empty(); }
  Eigen::Vector3f direction(std::size_t pixel) const {
    return {forward.empty() ? 1.0f : forward[pixel], left[pixel], up[pixel]};
  }

  /// The rays of a camera that turns at `angular_velocity` (rad/s, in its own frame) while its rows are read one by one
  /// within `readout_time` (s). Their frame is the camera's at the time at which the middle row is read.
  void turn_while_read(const RayTable& at_rest, const Eigen::Vector3d& angular_velocity, double readout_time);

 private:
  void make_blocks();
};

}  // namespace reorient
