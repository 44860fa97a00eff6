// SPDX-License-Identifier: MIT
// The things on the field and around it, built from shapes.
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
  std::vector<Panel> panels;  ///< show parts of the room's walls
  std::vector<Net> nets;
  std::vector<Shadow> shadows;
  Illumination illumination;
  WallPatches patches;

  /// Removes all things; light and walls remain.
  void clear();
};

/// Adds both goals: posts, crossbar, net and its frame.
void add_goals(Scene& scene, const FieldDimensions& field, const LinearColor& light);

/// Adds the sides and the top of a box. `perimeter`: of the room's walls, m.
void add_furniture(Scene& scene, const FurniturePiece& piece, double perimeter);

/// Adds a robot with the shape of a NAO, `size` times as large. `stride` (rad) is the phase of legs and arms. If
/// `is_lying`, it lies on its back with the head ahead of its feet.
void add_robot(Scene& scene, const Pose2& pose, double stride, double size, const LinearColor& jersey,
               const LinearColor& light, bool is_lying = false);

void add_ball(Scene& scene, const Eigen::Vector2d& position, double diameter, const LinearColor& light);

struct PersonLook {
  LinearColor shirt, trousers, skin, hair;
};

/// Adds a person who stands at `where` and faces the field's center. `height` in m; `lean`: m to the side.
void add_person(Scene& scene, const Eigen::Vector2d& where, double height, double lean, const PersonLook& look);

}  // namespace reorient
