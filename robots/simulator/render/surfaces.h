// SPDX-License-Identifier: MIT
// The surfaces that fill the picture: carpet with its lines, floor, walls and ceiling of the room.
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
  /// `worn_lines`: share of the lines that is gone.
  Surfaces(const FieldDimensions& field, Room room, int image_width, double worn_lines);

  /// What has changed since the room was made.
  struct Changes {
    const Illumination& illumination;
    const WallPatches& patches;
  };

  /// Fills in every pixel of `frame`. The camera must be inside of the room and above its floor.
  void render(const RayTable& rays, const Eigen::Isometry3f& field_from_camera, const Changes& changes, Frame& frame);

  const Room& room() const { return room_; }

 private:
  enum Surface { kWall, kCeiling, kFloor, kCarpet, kSurfaces };

  /// One image row's worth of where the rays end. Structure of arrays, for SIMD.
  struct Hits {
    explicit Hits(int width);
    std::vector<float> x, y;            // m, on the ground
    std::vector<float> half_x, half_y;  // m, half the ground that a pixel covers; filled in for carpet alone
    std::vector<float> u, v;            // m, in the surface's texture
    std::vector<float> azimuth;         // rad, seen from the middle of a round room
    std::vector<float> footprint;       // m, on the surface
    std::vector<float> coverage;        // share of line
    std::vector<float> on_wall;         // 1 or 0; filled in where walls are changed
    std::vector<float> gain;            // on the light; filled in where it is changed
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
