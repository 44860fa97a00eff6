// SPDX-License-Identifier: MIT
// Renders a scene from a camera pose to linear light, depth and labels. It uses no OpenGL, but one ray per pixel from a
// table.
#pragma once

#include <optional>
#include <vector>

#include <Eigen/Geometry>

#include "geometry/transform.h"
#include "robots/simulator/render/framebuffer.h"
#include "robots/simulator/render/scene/scene.h"
#include "robots/simulator/render/surfaces.h"

namespace reorient {

class Renderer {
 public:
  Renderer(const CameraModel& camera, const FieldDimensions& field, const Room& room, bool with_labels,
           double worn_lines = 0.0);

  /// The result is valid until the next call. The camera is moved into the room and above its floor if necessary. If it
  /// turns (rad/s, in its own frame) while its rows are read within `readout_time` (s), the picture is skewed.
  const Frame& render(const Isometry3& field_from_camera, const Scene& scene,
                      const Eigen::Vector3d& angular_velocity = Eigen::Vector3d::Zero(), double readout_time = 0.0);

  const RayTable& rays() const { return rays_; }
  const Frame& frame() const { return frame_; }

 private:
  struct Drawn {
    float distance;
    int index;  // of a panel or a capsule; negative: of a net, -1 is the first one
  };

  const RayTable& rays_of_frame(const Eigen::Vector3d& angular_velocity, double readout_time);
  void light(const Scene& scene);
  void draw_panels(const Scene& scene, const RayTable& rays, const Eigen::Isometry3f& camera_from_field,
                   const Eigen::Vector3f& eye);
  void sort_far_first();

  RayTable rays_;
  std::optional<RayTable> turned_rays_;  // of a camera that turned
  Surfaces background_;
  Frame frame_;
  std::vector<Drawn> order_;
  std::vector<Capsule> capsules_;  // with colors in the scene's light
};

}  // namespace reorient
