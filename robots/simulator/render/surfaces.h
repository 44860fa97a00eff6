// SPDX-License-Identifier: MIT
// The background of the picture: the carpet with its lines, and floor, walls and ceiling of the room.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "geometry/field_dimensions.h"
#include "robots/simulator/render/framebuffer.h"
#include "robots/simulator/render/light/illumination.h"
#include "robots/simulator/render/light/wall_patches.h"
#include "robots/simulator/render/scene/field_lines.h"
#include "robots/simulator/room/room.h"

namespace reorient {

class Surfaces {
 public:
  /// `worn_lines`: fraction of the lines that is missing.
  Surfaces(const FieldDimensions& field, Room room, int image_width, double worn_lines);

  /// Changes of the room's light and walls.
  struct Changes {
    const Illumination& illumination;
    const WallPatches& patches;
  };

  /// Sets each pixel of `frame`. The camera must be inside the room and above its floor.
  void render(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, const Changes& changes, Frame& frame);

  const Room& room() const { return room_; }

 private:
  enum Surface { kWall, kCeiling, kFloor, kCarpet, kSurfaces };

  /// The points that the rays of one image row hit. Structure of arrays, for SIMD.
  struct Hits {
    explicit Hits(int width);
    std::vector<float> x, y;            // m, on the ground
    std::vector<float> half_x, half_y;  // m, half sizes of the ground that a pixel covers; only set for carpet
    std::vector<float> u, v;            // m, in the surface's texture
    std::vector<float> azimuth;         // rad, seen from the center of a round room
    std::vector<float> footprint;       // m, on the surface
    std::vector<float> coverage;        // fraction that lines cover
    std::vector<float> on_wall;         // 1 or 0; only set if walls are changed
    std::vector<float> gain;            // factor on the light; only set if the light is changed
    std::vector<int> surface;
    std::vector<int> level;  // of the surface's texture
  };

  struct Columns {
    int first, end;
  };

  void intersect(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row, Frame& frame);
  template <bool round, bool perspective>
  [[gnu::always_inline]] void intersect_with(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                             Frame& frame);
  void intersect_box(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row, Frame& frame);
  void intersect_round(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row, Frame& frame);
  void intersect_box_through_any_lens(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                      Frame& frame);
  void intersect_round_through_any_lens(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                        Frame& frame);
  template <bool perspective>
  [[gnu::always_inline]] void spread_with(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                                          const Columns& columns, const Frame& frame);
  void spread(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row, const Columns& columns,
              const Frame& frame);
  void spread_through_any_lens(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row,
                               const Columns& columns, const Frame& frame);
  void shade(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, int row, Frame& frame);
  void patch(int row, const WallPatches& patches, Frame& frame);
  void relight(int row, const Illumination& illumination, Frame& frame);
  void label(int row, Frame& frame);

  Room room_;
  FieldLines lines_;
  Texture carpet_;
  float carpet_half_length_;
  float carpet_half_width_;
  Hits hits_;
};

}  // namespace reorient
