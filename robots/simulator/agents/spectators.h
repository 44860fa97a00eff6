// SPDX-License-Identifier: MIT
// The people around the field. They shift their weight, a few stroll up and down, and all of them are in the way of the
// walls behind them, as at a tournament. In a room that looks the same after half a turn they do, too.
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

  /// Each one leaves with this probability, and somebody else comes to another place.
  void exchange(double probability);

  /// Adds everybody as they stand at a time (s).
  void add_to(Scene& scene, double time) const;

 private:
  struct Spectator {
    Eigen::Vector2d place;
    Eigen::Vector2d stroll;  // m, the farthest way from the place; zero for most
    double height;           // m
    double phase;            // rad
    double pace;             // rad/s
    double restless;         // m, how far the head moves to the sides
    PersonLook look;
  };

  /// Nobody, where the place that was drawn is too narrow.
  std::optional<Spectator> somebody(Random& random) const;

  RoomShape room_;
  FieldDimensions field_;
  LinearColor light_;
  Random comers_;  // those who come later
  std::vector<Spectator> spectators_;
};

}  // namespace reorient
