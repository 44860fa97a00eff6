// SPDX-License-Identifier: MIT
// What stands on the field and around it, and how it is put together from shapes.
#pragma once

#include <vector>

#include <Eigen/Geometry>

#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "robots/simulator/render/light/illumination.h"
#include "robots/simulator/render/light/wall_patches.h"
#include "robots/simulator/render/scene/shapes.h"
#include "robots/simulator/room/furniture.h"

namespace reorient {

struct Scene {
  std::vector<Capsule> capsules;
  std::vector<Panel> panels;  ///< that show the room's walls
  std::vector<Net> nets;
  std::vector<Shadow> shadows;
  Illumination illumination;
  WallPatches patches;

  /// Nothing stands there any more; light and walls remain.
  void clear();
};

/// Both goals: posts, crossbar, net and the frame that holds it.
void add_goals(Scene& scene, const FieldDimensions& field, const LinearColor& light);

/// The sides and the top of a box. `perimeter`: of the room's walls, m.
void add_furniture(Scene& scene, const FurniturePiece& piece, double perimeter);

/// Of a NAO's shape and `size` times as large; `stride` in radians moves its legs and arms.
void add_robot(Scene& scene, const Pose2& pose, double stride, double size, const LinearColor& jersey,
               const LinearColor& light);

void add_ball(Scene& scene, const Eigen::Vector2d& position, double diameter, const LinearColor& light);

struct PersonLook {
  LinearColor shirt, trousers, skin, hair;
};

/// Somebody who stands at a place and looks to the field's centre; `height` in metres, `lean` in metres sideways.
void add_person(Scene& scene, const Eigen::Vector2d& where, double height, double lean, const PersonLook& look);

}  // namespace reorient
