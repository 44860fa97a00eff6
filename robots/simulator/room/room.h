// SPDX-License-Identifier: MIT
// The room around the field: a box or a cylinder of finite size with a picture on its walls, ceiling and floor.
// Its size is finite because a walking robot sees near walls move against far ones.
#pragma once

#include <cstdint>
#include <string>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"
#include "robots/simulator/room/texture.h"

namespace reorient {

enum class RoomForm { box, cylinder };

/// Whether a room looks the same after a rotation by 180 or by 90 degrees. Such a room cannot show the orientation.
enum class RoomSymmetry { none, two_fold, four_fold };

/// The room's center is the field's center; its floor is the field's plane.
struct RoomShape {
  RoomForm form = RoomForm::box;
  double length = 16.8;           ///< m along x; a cylinder's diameter
  double width = 12.8;            ///< m along y; not used for a cylinder
  double height = 7.0;            ///< m
  double viewpoint_height = 1.3;  ///< m above the floor, at which a panorama was taken
  double turn = 0.0;              ///< rad to the left, by which a panorama is rotated about the field's center
  RoomSymmetry symmetry = RoomSymmetry::none;
  /// Weight of the repeated pictures in a symmetric room. They are blended in linear light with the pictures that they
  /// replace. At 1 the room is exactly symmetric; at 0 walls, ceiling and floor are as without symmetry. People, lamps,
  /// furniture and changed walls are repeated at any strength, so that only the pictures can break the symmetry.
  double symmetry_strength = 1.0;
  double mark = 0.0;   ///< m, width of the banner on one side wall of the hall, which no symmetry repeats; 0: no banner
  double color = 1.0;  ///< factor on the saturation of its colors; 0: gray
};

inline constexpr double kWidestMark = 10.0;  // m

template <typename Visit>
void describe(RoomShape& shape, Visit&& visit) {
  visit("form", shape.form, {"box", "cylinder"}, "form of the room: box has four walls, cylinder one round wall");
  visit("length", shape.length, 4.0, 200.0, "m", "size of the room along the field; diameter of a cylinder");
  visit("width", shape.width, 4.0, 200.0, "m", "size of the room across the field; not used for a cylinder");
  visit("height", shape.height, 2.5, 30.0, "m", "height of the ceiling above the floor");
  visit("viewpoint_height", shape.viewpoint_height, 0.3, 2.4, "m", "height at which the panorama was taken");
  visit("turn", shape.turn, -3.1416, 3.1416, "rad", "rotation of the panorama to the left about the field's center");
  visit("symmetry", shape.symmetry, {"none", "two_fold", "four_fold"},
        "symmetry of the room; two_fold: opposite walls are the same; four_fold: all walls are the same, stretched to "
        "their widths");
  visit("symmetry_strength", shape.symmetry_strength, 0.0, 1.0, "",
        "weight of the repeated half of walls, ceiling and floor in a symmetric room; 1: exactly symmetric, 0: walls, "
        "ceiling and floor as without symmetry, while people, lamps and furniture stay repeated");
  visit("mark", shape.mark, 0.0, kWidestMark, "m",
        "width of a banner on one side wall of the built-in hall only, also in a symmetric hall; 0: no banner");
  visit("color", shape.color, 0.0, 1.0, "", "factor on the saturation of the room's colors; 0: a gray room");
}

/// The default room, larger by as much as the field is larger than the default field.
RoomShape room_shape_for(const FieldDimensions& field);

/// A room for the renderer. Immutable; copies share their memory.
struct Room {
  std::string name;  ///< a file or "hall"
  RoomShape shape;
  Texture walls;                            ///< u: wall_coordinate, v: height above the floor
  Texture ceiling;                          ///< u: x + length / 2, v: y + width / 2
  Texture floor;                            ///< the same
  LinearColor light = LinearColor::Ones();  ///< light that white paper on the field reflects
};

/// The room from an equirectangular panorama file (.hdr, .png, .jpg; assets/rooms/README.md).
/// Throws std::runtime_error with one line that names the file, the problem and its fix.
Room load_room(const std::string& path, const RoomShape& shape);

/// The same from the panorama itself. Throws std::runtime_error with one line if `shape` has a mark, too: only the
/// built-in hall has one.
Room room_from(LinearImage panorama, const std::string& name, const RoomShape& shape);

/// The built-in room: a sports hall on a tournament day, a different one for each seed. Its four walls differ, so that
/// the room always shows a rotation by 180 degrees.
Room procedural_hall(std::uint64_t seed, const RoomShape& shape);

/// Total length of the walls, m.
double wall_perimeter(const RoomShape& shape);

/// Wall coordinate (m) at which wall `side` begins; side 4 is the end of the perimeter. The four walls are numbered
/// counterclockwise, starting with the one behind the goal at +x. A cylinder is divided into four arcs.
double wall_begin(const RoomShape& shape, int side);

/// The point of the floor plan at a wall coordinate: meters along the walls, counterclockwise seen from above, from the
/// corner (+length / 2, -width / 2) or, in a cylinder, from the azimuth of -45 degrees.
Eigen::Vector2d wall_point(const RoomShape& shape, double wall_coordinate);

/// Throws std::runtime_error if a value is outside of its range.
void check(const RoomShape& shape);

/// Size of the ceiling and floor textures, m.
Eigen::Vector2d floor_extent(const RoomShape& shape);

}  // namespace reorient
