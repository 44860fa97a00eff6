// From a camera pose and a scene to linear light, depth and labels: no GL, one ray a pixel from a table.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "geometry/transform.h"
#include "robots/simulator/render/framebuffer.h"
#include "robots/simulator/render/scene/scene.h"
#include "robots/simulator/render/surfaces.h"

namespace reorient {

class Renderer {
 public:
  Renderer(const CameraModel& camera, const FieldDimensions& field, const Room& room, bool with_labels);

  /// The result is valid until the next call. The camera is kept inside of the room and above its floor.
  const Frame& render(const Isometry3& field_from_camera, const Scene& scene);

  const RayTable& rays() const { return rays_; }
  const Frame& frame() const { return frame_; }

 private:
  struct Drawn {
    float distance;
    int index;  // of a capsule, or of a net where negative: -1 is the first one
  };

  RayTable rays_;
  Surfaces background_;
  Frame frame_;
  std::vector<Drawn> order_;
};

}  // namespace reorient
