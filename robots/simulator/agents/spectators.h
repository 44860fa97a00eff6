// SPDX-License-Identifier: MIT
// The people around the field. They sway, a few walk up and down, and all of them hide parts of the walls behind them.
// In a symmetric room each person has a twin on the other side.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "geometry/field_dimensions.h"
#include "geometry/random.h"
#include "robots/simulator/render/scene/scene.h"
#include "robots/simulator/room/room.h"

namespace reorient {

class Spectators {
 public:
  Spectators(int count, const RoomShape& room, const FieldDimensions& field, const LinearColor& light,
             std::uint64_t seed);

  /// Replaces each person with this probability by a new person at another position.
  void exchange(double probability);

  /// Adds all people in their positions at a time (s).
  void add_to(Scene& scene, double time) const;

 private:
  struct Spectator {
    Eigen::Vector2d position;
    Eigen::Vector2d stroll;  // m, farthest offset from `position`; zero for most
    double height;           // m
    double phase;            // rad
    double pace;             // rad/s
    double restless;         // m, amplitude of the head's motion to the sides
    PersonLook look;
  };

  /// Empty if there is too little space at the position that was drawn.
  std::optional<Spectator> draw_spectator(Random& random) const;

  RoomShape room_;
  FieldDimensions field_;
  LinearColor light_;
  Random newcomers_;  // for new people in exchange()
  std::vector<Spectator> spectators_;
};

}  // namespace reorient
