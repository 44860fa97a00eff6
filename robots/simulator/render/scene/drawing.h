// SPDX-License-Identifier: MIT
// Helpers for drawing capsules, nets and shadows: the box of pixels that they can touch, and loops over its pixels.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"
#include "robots/simulator/render/framebuffer.h"
#include "robots/simulator/room/texture.h"

namespace reorient {

inline constexpr float kNearest = 0.02f;  // m in front of the camera

/// Limits in pixels, inclusive.
struct Box {
  int left, top, right, bottom;
};

/// The pixels that the convex hull of balls (camera frame) can touch, for a simple pinhole.
class Bounds {
 public:
  explicit Bounds(const RayTable& rays) : rays_(rays), camera_(rays.camera) {}

  void add(const Eigen::Vector3f& center, float radius) {
    // Beyond one side of the view pyramid? The side's normal (1, steepest) has not unit length, so scale the radius.
    const auto beyond = [&](float off_axis, float steepest) {
      return off_axis - steepest * center.x() > radius * std::sqrt(1.0f + steepest * steepest);
    };
    beyond_left_ = beyond_left_ && beyond(center.y(), rays_.most_left);
    beyond_right_ = beyond_right_ && beyond(-center.y(), rays_.most_right);
    beyond_top_ = beyond_top_ && beyond(center.z(), rays_.most_up);
    beyond_bottom_ = beyond_bottom_ && beyond(-center.z(), rays_.most_down);
    balls_[static_cast<std::size_t>(count_++)] = {center, radius};
  }

  Box box() {
    if (beyond_left_ || beyond_right_ || beyond_top_ || beyond_bottom_) return {0, 0, -1, -1};
    for (int i = 0; i < count_; ++i) {
      const auto& [center, radius] = balls_[static_cast<std::size_t>(i)];
      const float nearest = std::max(center.x() - radius, kNearest);
      for (const float side : {-radius, radius}) {
        for (const float depth : {nearest, center.x() + radius}) {
          add_pixel({depth, center.y() + side, center.z() + side});
        }
      }
    }
    // A distorted straight line leaves the box of its ends.
    const double bend = std::min(0.25, 0.5 * std::abs(camera_.k1) + 0.5 * std::abs(camera_.k2));
    const double margin = 1.0 + bend * (right_ - left_ + bottom_ - top_) + static_cast<double>(rays_.slack);
    const auto pixel = [](double value, int count) {
      return static_cast<int>(std::clamp(std::floor(value), -1.0, static_cast<double>(count)));
    };
    return {std::max(0, pixel(left_ - margin, camera_.width)), std::max(0, pixel(top_ - margin, camera_.height)),
            std::min(camera_.width - 1, pixel(right_ + margin + 1.0, camera_.width)),
            std::min(camera_.height - 1, pixel(bottom_ + margin + 1.0, camera_.height))};
  }

 private:
  void add_pixel(const Eigen::Vector3f& point) {
    const Eigen::Vector3d exact = point.cast<double>();
    const auto projected = camera_.project(exact);
    // A point where the distortion folds back is far outside of the image, and so is its undistorted pixel.
    const Eigen::Vector2d pixel = projected
                                      ? *projected
                                      : Eigen::Vector2d(camera_.center.x() - camera_.focal.x() * exact.y() / exact.x(),
                                                        camera_.center.y() - camera_.focal.y() * exact.z() / exact.x());
    left_ = std::min(left_, pixel.x());
    right_ = std::max(right_, pixel.x());
    top_ = std::min(top_, pixel.y());
    bottom_ = std::max(bottom_, pixel.y());
  }

  struct Ball {
    Eigen::Vector3f center;
    float radius;
  };
  static constexpr std::size_t kMost = 8;  // for a net: both ends of each side

  const RayTable& rays_;
  const CameraModel& camera_;
  std::array<Ball, kMost> balls_;
  int count_ = 0;
  bool beyond_left_ = true;
  bool beyond_right_ = true;
  bool beyond_top_ = true;
  bool beyond_bottom_ = true;
  double left_ = 1e9;
  double right_ = -1e9;
  double top_ = 1e9;
  double bottom_ = -1e9;
};

/// The pixels that balls (camera frame) can touch, for any lens: each ball fills a cone of directions.
class Cones {
 public:
  explicit Cones(const RayTable& rays) : rays_(rays) {}

  void add(const Eigen::Vector3f& center, float radius) {
    const float distance = center.norm();
    if (distance <= radius + kNearest) {
      everywhere_ = true;
      return;
    }
    const double half_angle = pinned::asin(radius / distance) + static_cast<double>(rays_.angle_slack);
    const auto [sine, cosine] = pinned::sincos(half_angle);
    const Eigen::Vector3f axis = center / distance;
    for (const RayBlock& block : rays_.blocks) {
      const double sum = half_angle + static_cast<double>(block.half_angle);
      const float closest = sum < kPi
                                ? static_cast<float>(cosine) * block.cosine - static_cast<float>(sine) * block.sine
                                : -1.0f;  // cosine of the sum
      if (axis.dot(block.axis) < closest - kRounding) continue;
      box_.left = std::min(box_.left, block.left);
      box_.top = std::min(box_.top, block.top);
      box_.right = std::max(box_.right, block.right);
      box_.bottom = std::max(box_.bottom, block.bottom);
    }
  }

  /// Adds everything within `radius` of a line, as enough balls that none of them fills a wide cone.
  void add_line(const Eigen::Vector3f& from, const Eigen::Vector3f& to, float radius) {
    constexpr float kWide = 0.1f;  // rad
    constexpr int kMost = 16;
    const float length = (to - from).norm();
    const float distance = std::max(0.5f * (from + to).norm(), kNearest);
    const int count = std::clamp(static_cast<int>(std::ceil(0.5f * length / (kWide * distance))), 1, kMost);
    for (int i = 0; i < count; ++i) {
      const float along = (static_cast<float>(i) + 0.5f) / static_cast<float>(count);
      add(from + along * (to - from), radius + 0.5f * length / static_cast<float>(count));
    }
  }

  Box box() const {
    if (everywhere_) return {0, 0, rays_.camera.width - 1, rays_.camera.height - 1};
    return box_.right < 0 ? Box{0, 0, -1, -1} : box_;
  }

 private:
  static constexpr float kRounding = 1e-5f;

  const RayTable& rays_;
  bool everywhere_ = false;
  Box box_{rays_.camera.width, rays_.camera.height, -1, -1};
};

inline void blend(Frame& frame, std::size_t pixel, float coverage, const LinearColor& color) {
  frame.red[pixel] += coverage * (color.x() - frame.red[pixel]);
  frame.green[pixel] += coverage * (color.y() - frame.green[pixel]);
  frame.blue[pixel] += coverage * (color.z() - frame.blue[pixel]);
}

inline void cover(Frame& frame, std::size_t pixel, float coverage, const LinearColor& color, float depth, Label label) {
  blend(frame, pixel, coverage, color);
  if (coverage <= 0.5f) return;
  frame.depth[pixel] = depth;
  if (!frame.labels.empty()) frame.labels[pixel] = label;
}

/// Clips a line to the part in front of the camera. False: the whole line is behind `nearest`.
inline bool clip(Eigen::Vector3f& from, Eigen::Vector3f& to, float nearest) {
  if (from.x() < nearest && to.x() < nearest) return false;
  if (from.x() < nearest) from += (nearest - from.x()) / (to.x() - from.x()) * (to - from);
  if (to.x() < nearest) to += (nearest - to.x()) / (from.x() - to.x()) * (from - to);
  return true;
}

/// Calls touch(pixel, ray, length of ray) for every pixel in the box.
template <typename Touch>
void for_each(const Box& box, const RayTable& rays, const Frame& frame, Touch&& touch) {
  for (int y = box.top; y <= box.bottom; ++y) {
    for (int x = box.left; x <= box.right; ++x) {
      const std::size_t pixel = frame.row(y) + static_cast<std::size_t>(x);
      touch(pixel, rays.direction(pixel), rays.length[pixel]);
    }
  }
}

}  // namespace reorient
