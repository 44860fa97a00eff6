// SPDX-License-Identifier: MIT
// Parses a table with one row for each image of the footage: image, time, poses of the robot and its camera. It reads
// only the text of the table, not the images.
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

/// The columns with numbers. A header is the name with a unit: time_s, x_m, rotation_deg.
enum class FrameColumn {
  time,  ///< s, ms, us, ns
  x,     ///< m, cm, mm: of the robot in the field
  y,
  rotation,    ///< rad, deg: to the left
  odometry_x,  ///< the same by dead reckoning, from any start
  odometry_y,
  odometry_rotation,
  camera_height,  ///< m, cm, mm: above the ground
  roll,           ///< rad, deg: of the camera, its left side up
  pitch,          ///< rad, deg: of the camera, downwards
  camera_yaw      ///< rad, deg: of the camera relative to the robot, to the left
};
inline constexpr std::size_t kFrameColumns = 11;

struct FrameRow {
  int line = 0;                                ///< of the file, starting with 1
  std::string image;                           ///< empty: the table has no column with images
  std::array<double, kFrameColumns> values{};  ///< m, rad, s; NaN: unknown

  std::optional<double> value(FrameColumn column) const {
    const double value = values[static_cast<std::size_t>(column)];
    return value == value ? std::optional(value) : std::nullopt;
  }
  std::optional<Pose2> pose() const;
  std::optional<Pose2> odometry() const;
  std::optional<double> heading() const;  ///< only if the row has no pose
  /// `usual_height`: height if the table has none, m.
  Isometry3 robot_from_camera(double usual_height) const;
};

/// Maps columns to headers that differ from the usual ones: "rotation" to "yaw" or "yaw:deg", "image" to "file". If a
/// header ends with a unit, the unit is used. An empty header means that the column is not used.
using ColumnHeaders = std::map<std::string, std::string>;

/// The names of all columns, including "image".
std::vector<std::string> frame_column_names();

/// Unused and missing headers of a table.
struct TableHeaders {
  std::vector<std::string> unused;   ///< headers that belong to no column
  std::vector<std::string> missing;  ///< usual headers of the missing columns, with each unit
};

/// Reads only the headers of a table, which parse_frames() may still refuse. Throws BadFootage.
TableHeaders read_headers(std::string_view text, const std::string& name, const ColumnHeaders& headers = {});

/// Parses a table. Its first line shows whether commas, semicolons or tabs separate the cells. Numbers may have a
/// decimal comma. Columns of other names are not used. Times, if any, must increase from row to row. `name`: of the
/// file, for messages. Throws BadFootage with one line: file, line, what was expected, what was found.
std::vector<FrameRow> parse_frames(std::string_view text, const std::string& name, const ColumnHeaders& headers = {});

}  // namespace reorient
