// SPDX-License-Identifier: MIT
// The things in front of the background: capsules (limbs, posts, people, the ball), panels (furniture), nets
// and shadows on the ground. Each is drawn into the box of pixels that it can touch, with soft edges and against the
// depth of what is there.
#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "robots/simulator/render/framebuffer.h"
#include "robots/simulator/room/texture.h"

namespace reorient {

/// Everything within `radius` of a straight line. Metres, field frame.
struct Capsule {
  Eigen::Vector3f from = Eigen::Vector3f::Zero();
  Eigen::Vector3f to = Eigen::Vector3f::Zero();
  float radius = 0.05f;
  LinearColor color = LinearColor::Ones();  ///< as lit from above
  Label label = Label::robot;
  bool flat_ends = false;  ///< a cylinder: ends at `from` and `to`
  bool football = false;   ///< black patches on it
};

/// A parallelogram of string.
struct Net {
  Eigen::Vector3f corner = Eigen::Vector3f::Zero();
  Eigen::Vector3f along = Eigen::Vector3f::UnitX();  ///< one side, m
  Eigen::Vector3f up = Eigen::Vector3f::UnitZ();     ///< the other side, m
  LinearColor color = LinearColor::Ones();
};

/// A parallelogram that is seen from one side only, from where `up` lies to the left of `along`. It shows a part of a
/// texture: from (u, v) on, as many metres as its sides are long.
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
  float darkness = 0.5f;  ///< in its middle, in [0, 1]
};

/// What the camera sees of the room, as far as it can be told without looking at pixels.
class Frustum {
 public:
  Frustum(const RayTable& rays, const Eigen::Isometry3f& camera_from_field);

  /// False: draw() would not touch a pixel.
  bool may_show(const Capsule& capsule) const;

 private:
  struct Side {
    float across, up, ahead;  // the outward normal, of unit length
  };
  Eigen::Isometry3f camera_from_field_;
  std::array<Side, 4> sides_;
  std::optional<float> most_off_axis_;  // rad; of a lens that is not plain, whose view is no pyramid
};

void draw(const Capsule& capsule, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame);
/// `gain`: on the light.
void draw(const Panel& panel, const Texture& texture, float gain, const RayTable& rays,
          const Eigen::Isometry3f& camera_from_field, Frame& frame);
void draw(const Net& net, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame);
void draw(const Shadow& shadow, const RayTable& rays, const Eigen::Isometry3f& camera_from_field, Frame& frame);

}  // namespace reorient
