// SPDX-License-Identifier: MIT
#include "robots/simulator/room/room.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <stdexcept>

#include "geometry/angle.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

// Azimuth at which a cylinder's wall coordinate begins: the direction of the corner at which that of a square box does.
constexpr double kCylinderStart = -kPi / 4.0;

void check_range(const char* name, double value, double greatest) {
  if (value >= 0.0 && value <= greatest) return;
  std::ostringstream message;
  message << "room_shape." << name << " is " << value << " (expected 0 to " << greatest << ")";
  throw std::runtime_error(message.str());
}

}  // namespace

double wall_perimeter(const RoomShape& shape) {
  return shape.form == RoomForm::box ? 2.0 * (shape.length + shape.width) : kPi * shape.length;
}

double wall_begin(const RoomShape& shape, int side) {
  if (shape.form == RoomForm::cylinder) return wall_perimeter(shape) * side / 4.0;
  const double lengths[] = {shape.width, shape.length, shape.width, shape.length};
  double begin = 0.0;
  for (int i = 0; i < side; ++i) begin += lengths[i];
  return begin;
}

Eigen::Vector2d wall_point(const RoomShape& shape, double wall_coordinate) {
  const double along = wall_coordinate - wall_perimeter(shape) * std::floor(wall_coordinate / wall_perimeter(shape));
  if (shape.form == RoomForm::cylinder) {
    const double azimuth = kCylinderStart + 2.0 * along / shape.length;
    return 0.5 * shape.length * unit_vector(azimuth);
  }
  const double half_length = 0.5 * shape.length;
  const double half_width = 0.5 * shape.width;
  if (along < wall_begin(shape, 1)) return {half_length, along - half_width};
  if (along < wall_begin(shape, 2)) return {half_length - (along - wall_begin(shape, 1)), half_width};
  if (along < wall_begin(shape, 3)) return {-half_length, half_width - (along - wall_begin(shape, 2))};
  return {along - wall_begin(shape, 3) - half_length, -half_width};
}

Eigen::Vector2d floor_extent(const RoomShape& shape) {
  return {shape.length, shape.form == RoomForm::box ? shape.width : shape.length};
}

RoomShape room_shape_for(const FieldDimensions& field) {
  const FieldDimensions usual;
  RoomShape shape;
  shape.length = field.length + (shape.length - usual.length);
  shape.width = field.width + (shape.width - usual.width);
  return shape;
}

void check(const RoomShape& shape) {
  const Eigen::Vector2d extent = floor_extent(shape);
  constexpr double kLeast = 4.0, kGreatest = 200.0;
  const bool sound = (extent.array() >= kLeast).all() && (extent.array() <= kGreatest).all() && shape.height >= 2.5 &&
                     shape.height <= 30.0 && shape.viewpoint_height >= 0.3 &&
                     shape.viewpoint_height <= 0.96 * shape.height && std::isfinite(shape.turn);
  if (!sound) {
    std::ostringstream message;
    message << "room_shape: expected 4 to 200 x 4 to 200 x 2.5 to 30 m and a viewpoint from 0.3 m to just below the "
               "ceiling, found "
            << extent.x() << " x " << extent.y() << " x " << shape.height << " m and a viewpoint at "
            << shape.viewpoint_height << " m";
    throw std::runtime_error(message.str());
  }
  check_range("symmetry_strength", shape.symmetry_strength, 1.0);
  check_range("mark", shape.mark, kWidestMark);
}

}  // namespace reorient
