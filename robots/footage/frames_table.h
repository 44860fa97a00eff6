// SPDX-License-Identifier: MIT
// A table with one row for each image of a footage: which image, when, where the robot and its camera were. Text only;
// the images are somebody else's.
#pragma once

#include <array>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robots/footage/footage.h"

namespace reorient {

/// The columns with numbers. Headers are the name with a unit: time_s, x_m, rotation_deg.
enum class FrameColumn {
  time,  ///< s, ms, us, ns
  x,     ///< m, cm, mm: of the robot in the field
  y,
  rotation,    ///< rad, deg: to the left
  odometry_x,  ///< the same by dead reckoning, since any start
  odometry_y,
  odometry_rotation,
  camera_height,  ///< m, cm, mm: above the ground
  roll,           ///< rad, deg: of the camera, its left side up
  pitch,          ///< rad, deg: of the camera, downwards
  camera_yaw      ///< rad, deg: of the camera against the robot, to the left
};
inline constexpr std::size_t kFrameColumns = 11;

struct FrameRow {
  int line = 0;                                ///< of the file, from 1 on
  std::string image;                           ///< empty: the table does not say
  std::array<double, kFrameColumns> values{};  ///< m, rad, s; NaN: unknown

  std::optional<double> value(FrameColumn column) const {
    const double value = values[static_cast<std::size_t>(column)];
    return value == value ? std::optional(value) : std::nullopt;
  }
  std::optional<Pose2> pose() const;
  std::optional<Pose2> odometry() const;
  std::optional<double> heading() const;  ///< where there is no pose
  /// `usual_height`: m, where the table does not say.
  Isometry3 robot_from_camera(double usual_height) const;
};

/// "rotation" -> "yaw" or "yaw:deg": the header of a column, where it is not the usual one; "image" -> "file". Where a
/// header ends with a unit, that is its unit. An empty header: the column is not used.
using ColumnHeaders = std::map<std::string, std::string>;

/// The columns' names, "image" among them.
std::vector<std::string> frame_column_names();

/// What the first line of a table does not say.
struct TableHeaders {
  std::vector<std::string> unused;   ///< headers that are no column's
  std::vector<std::string> missing;  ///< usual headers of the columns that are not there, with each unit
};

/// Of a table that parse_frames() may still refuse. Throws BadFootage.
TableHeaders read_headers(std::string_view text, const std::string& name, const ColumnHeaders& headers = {});

/// Cells are separated by commas, semicolons or tabs, as the first line says; numbers may have a decimal comma. Columns
/// of other names are not used. `name`: of the file, for messages. Throws BadFootage with one line: file, line,
/// what was expected, what was found. Times increase from row to row, if there are any.
std::vector<FrameRow> parse_frames(std::string_view text, const std::string& name, const ColumnHeaders& headers = {});

}  // namespace reorient
