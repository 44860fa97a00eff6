// SPDX-License-Identifier: MIT
// The room around the field: a box or a cylinder of finite size with a picture on its walls, ceiling and floor.
// Finite, because a robot that walks sees near walls shift against far ones.
#pragma once

#include <cstdint>
#include <string>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"
#include "robots/simulator/room/texture.h"

namespace reorient {

enum class RoomForm { box, cylinder };

/// What a room looks like after half a turn, or a quarter: the hardest rooms are those that cannot tell.
enum class RoomSymmetry { none, two_fold, four_fold };

/// The room's centre is the field's centre; its floor is the field's plane.
struct RoomShape {
  RoomForm form = RoomForm::box;
  double length = 16.8;           ///< m along x; a cylinder's diameter
  double width = 12.8;            ///< m along y; a cylinder has none
  double height = 7.0;            ///< m
  double viewpoint_height = 1.3;  ///< m above the floor, where a panorama was taken
  double turn = 0.0;              ///< rad to the left, by which a panorama is turned about the field's centre
  RoomSymmetry symmetry = RoomSymmetry::none;
  /// Weight of the repeated pictures in a room with a symmetry. They are blended in linear light with the pictures that
  /// they replace. At 1 the room is exactly symmetric, at 0 walls, ceiling and floor are as without symmetry. People,
  /// lamps, furniture and changed walls are repeated at any strength, so that only the pictures can break the symmetry.
  double symmetry_strength = 1.0;
  double mark = 0.0;   ///< m, width of the banner on one side wall of the hall, which no symmetry repeats; 0: no banner
  double color = 1.0;  ///< share of its colours that is left; 0: grey
};

inline constexpr double kWidestMark = 10.0;  // m

template <typename Visit>
void describe(RoomShape& shape, Visit&& visit) {
  visit("form", shape.form, {"box", "cylinder"}, "whether the room has four walls or one round wall");
  visit("length", shape.length, 4.0, 200.0, "m", "the room's size along the field; a cylinder's diameter");
  visit("width", shape.width, 4.0, 200.0, "m", "the room's size across the field; a cylinder has none");
  visit("height", shape.height, 2.5, 30.0, "m", "from the floor to the ceiling");
  visit("viewpoint_height", shape.viewpoint_height, 0.3, 2.4, "m", "height at which the panorama was taken");
  visit("turn", shape.turn, -3.1416, 3.1416, "rad", "turns the panorama to the left about the field's centre");
  visit("symmetry", shape.symmetry, {"none", "two_fold", "four_fold"},
        "two_fold: opposite walls are the same; four_fold: all of them are, stretched to their width");
  visit("symmetry_strength", shape.symmetry_strength, 0.0, 1.0, "",
        "weight of the repeated half of walls, ceiling and floor in a symmetric room; 1: exactly symmetric, 0: walls, "
        "ceiling and floor as without symmetry, while people, lamps and furniture stay repeated");
  visit("mark", shape.mark, 0.0, kWidestMark, "m",
        "width of a banner on one side wall of the built-in hall only, also in a symmetric hall; 0: no banner");
  visit("color", shape.color, 0.0, 1.0, "", "share of the room's colours that is left; 0: a grey room");
}

/// As much larger than the default one as the field is larger than the default one.
RoomShape room_shape_for(const FieldDimensions& field);

/// A room that is ready to be rendered. Immutable; copies share their memory.
struct Room {
  std::string name;  ///< a file or "hall"
  RoomShape shape;
  Texture walls;                            ///< u: wall_coordinate, v: height above the floor
  Texture ceiling;                          ///< u: x + length / 2, v: y + width / 2
  Texture floor;                            ///< the same
  LinearColor light = LinearColor::Ones();  ///< what white paper on the field reflects
};

/// The room from an equirectangular panorama file (.hdr, .png, .jpg; assets/rooms/README.md).
/// Throws std::runtime_error with one line that names the file and what to do about it.
Room load_room(const std::string& path, const RoomShape& shape);

/// The same from the panorama itself. Panoramas take no mark: throws std::runtime_error with one line.
Room room_from(LinearImage panorama, const std::string& name, const RoomShape& shape);

/// The room that the program ships: a sports hall on a tournament day, another one for every seed. Its four walls
/// differ from each other, so that half a turn can always be told.
Room procedural_hall(std::uint64_t seed, const RoomShape& shape);

/// Length of the walls, once around, in metres.
double wall_perimeter(const RoomShape& shape);

/// The four walls, counter-clockwise from the one behind the goal at +x; a cylinder is cut into four arcs.
/// Where wall `side` begins, in metres of the wall coordinate; side 4 is the end of the perimeter.
double wall_begin(const RoomShape& shape, int side);

/// The point of the floor plan at a wall coordinate: metres along the walls, counter-clockwise seen from above,
/// from the corner (+length / 2, -width / 2) or, in a cylinder, from the azimuth of -45 degrees.
Eigen::Vector2d wall_point(const RoomShape& shape, double wall_coordinate);

/// Throws std::runtime_error where the shape cannot hold a field, or a value is outside of its range.
void check(const RoomShape& shape);

/// The extent in metres of ceiling and floor textures.
Eigen::Vector2d floor_extent(const RoomShape& shape);

}  // namespace reorient
