// The people around the field. They shift their weight, a few stroll up and down, and all of them are in the way of the
// walls behind them, as at a tournament.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/field_dimensions.h"
#include "robots/simulator/render/scene/scene.h"
#include "robots/simulator/room/room.h"

namespace reorient {

class Spectators {
 public:
  Spectators(int count, const RoomShape& room, const FieldDimensions& field, const LinearColor& light,
             std::uint64_t seed);

  /// Adds everybody as they stand at a time (s). A function of time alone.
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
  std::vector<Spectator> spectators_;
};

}  // namespace reorient
