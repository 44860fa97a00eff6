// SPDX-License-Identifier: MIT
// Shapes in front of the background: capsules (limbs, posts, people, the ball), panels (furniture), nets and shadows on
// the ground. Each is drawn into the box of pixels that it can touch, with soft edges and a test of the depth.
#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "robots/simulator/render/framebuffer.h"
#include "robots/simulator/room/texture.h"

namespace reorient {

/// Everything within `radius` of a line segment. Meters, field frame.
struct Capsule {
  Eigen::Vector3f from = Eigen::Vector3f::Zero();
  Eigen::Vector3f to = Eigen::Vector3f::Zero();
  float radius = 0.05f;
  LinearColor color = LinearColor::Ones();  ///< in light from above
  Label label = Label::robot;
  bool flat_ends = false;  ///< a cylinder: ends at `from` and `to`
  bool football = false;   ///< has black patches
};

/// A parallelogram of strings.
struct Net {
  Eigen::Vector3f corner = Eigen::Vector3f::Zero();
  Eigen::Vector3f along = Eigen::Vector3f::UnitX();  ///< one side, m
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();     ///< the other side, m
  LinearColor color = LinearColor::Ones();
};

/// A parallelogram that is visible only from the side on which `up` lies to the left of `along`. It shows the part of a
/// texture that starts at (u, v) and has its size in meters.
struct Panel {
  Eigen::Vector3f corner = Eigen::Vector3f::Zero();
  Eigen::Vector3f along = Eigen::Vector3f::UnitX();  ///< one side, m
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();     ///< the other side, m
  float u = 0.0f, v = 0.0f;                          ///< m, in the texture

  Eigen::Vector3f middle() const { return corner + 0.5f * (along + up); }
};

/// A soft dark spot on the ground.
struct Shadow {
  Eigen::Vector2f center = Eigen::Vector2f::Zero();
  float radius = 0.1f;
  float darkness = 0.5f;  ///< at its center, in [0, 1]
};

/// The view volume of the camera, for a fast test of shapes before they are drawn.
class Frustum {
 public:
  Frustum(const RayTable& rays, const Eigen::Isometry3f& camera_from_field);

  /// False: draw() would change no pixel.
  bool may_show(const Capsule& capsule) const;

 private:
  struct Side {
    float across, up, ahead;  // the outward normal, of unit length
  };
  Eigen::Isometry3f camera_from_field_;
  std::array<Side, 4> sides_;
  std::optional<float> most_off_axis_;  // rad; for a lens that is not a simple pinhole: its view is not a pyramid
};

void draw(const Capsule& capsule, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame);
/// `gain`: factor on the light.
void draw(const Panel& panel, const Texture& texture, float gain, const RayTable& rays,
          const Eigen::Isometry3f& camera_from_field, Frame& frame);
void draw(const Net& net, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame);
void draw(const Shadow& shadow, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame);

}  // namespace reorient
