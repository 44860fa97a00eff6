// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/pose_table.h"

#include <algorithm>
#include <ostream>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "geometry/angle.h"
#include "program/experiment/outputs/text_table.h"

namespace reorient {
namespace {

std::vector<std::string> line_of(const CellResults& cell) {
  const PoseRow row = cell.row.pose.value_or(PoseRow());
  std::vector<std::string> line;
  for (const std::string& choice : cell.choices) line.push_back(as_line(choice));
  line.push_back(std::to_string(cell.row.trials));
  line.push_back(fmt::format("{:.3f}, {:.3f}", row.position, row.worst_position));
  line.push_back(fmt::format("{:.1f}, {:.1f}", to_degrees(row.rotation), to_degrees(row.worst_rotation)));
  line.push_back(fmt::format("{:.2f}", row.normalized));
  line.push_back(fmt::format("{:.0f} %", 100.0 * row.within));
  line.push_back(fmt::format("{:.1f} %", 100.0 * row.mirrored));
  line.push_back(fmt::format("{} of {}", row.located_in_time, cell.row.trials));
  line.push_back(one_decimal(row.first_located_p90));
  line.push_back(std::to_string(row.falls));
  line.push_back(fmt::format("{}, {}", one_decimal(row.right_p90), one_decimal(row.located_p90)));
  return line;
}

}  // namespace

bool have_pose_errors(const std::vector<CellResults>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](const CellResults& cell) { return cell.row.pose.has_value(); });
}

void print_pose_errors(const Experiment& experiment, const std::vector<CellResults>& cells, std::ostream& out) {
  TextTable lines(1);
  for (const Axis& axis : experiment.axes) lines[0].push_back(as_line(axis.name));
  for (const std::string& title :
       {std::string("trials"), std::string("RMSE, worst, m"), std::string("degrees"), std::string("NEES / 3"),
        std::string("within 95 %"), std::string("mirrored"), fmt::format("located in {:.0f} s", PoseRow::kInTime),
        std::string("p90, s"), std::string("falls"), std::string("p90 until right, located, s")})
    lines[0].push_back(title);
  for (const CellResults& cell : cells) lines.push_back(line_of(cell));
  for (const CellResults& row : pooled_over_rooms(experiment, cells)) lines.push_back(line_of(row));
  print_table(lines, experiment.axes.size(), out);
}

void add_pose_errors(const std::optional<PoseRow>& row, nlohmann::ordered_json& json) {
  if (!row) return;
  const auto or_null = [](const std::optional<double>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json();
  };
  json["rmse_m"] = row->position;
  json["worst_rmse_m"] = row->worst_position;
  json["rmse_degrees"] = to_degrees(row->rotation);
  json["worst_rmse_degrees"] = to_degrees(row->worst_rotation);
  json["normalized_error"] = row->normalized;
  json["within_95"] = row->within;
  json["mirrored"] = row->mirrored;
  json["located_in_time"] = row->located_in_time;
  json["located_p90_s"] = or_null(row->first_located_p90);
  json["falls"] = row->falls;
  json["fall_right_p90_s"] = or_null(row->right_p90);
  json["fall_located_p90_s"] = or_null(row->located_p90);
}

}  // namespace reorient
