// SPDX-License-Identifier: MIT
#include "program/look/look_json.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include <nlohmann/json.hpp>

#include "engine/parameters/utf8.h"
#include "geometry/angle.h"
#include "geometry/camera_attitude.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

/// Rounds to the digits that are significant.
ordered_json number(double value, int digits) {
  const double units = std::pow(10.0, digits);
  return std::isfinite(value) ? ordered_json(std::round(value * units) / units) : ordered_json();
}
ordered_json point(const Eigen::Vector2d& position, int digits) {
  return {number(position.x(), digits), number(position.y(), digits)};
}
ordered_json meters(const Eigen::Vector2d& position) { return point(position, 3); }
ordered_json pixel(const Eigen::Vector2f& place) { return point(place.cast<double>(), 1); }
ordered_json degrees(double angle) { return number(to_degrees(angle), 2); }

ordered_json pitch_as_json(const SeenImage& seen) {
  ordered_json json{{"source", to_string(seen.pitch_source)},
                    {"known", seen.pitch_is_known()},
                    {"degrees", seen.pitch_is_known() ? degrees(pitch_of(seen.robot_from_camera)) : ordered_json()},
                    {"used_degrees", degrees(pitch_of(seen.robot_from_camera))}};
  if (seen.pitch_source != PitchSource::searched) return json;
  json["search"] = {{"most_likely_degrees", degrees(seen.searched.pitch)},
                    {"deviation_degrees", degrees(seen.searched.deviation)},
                    {"certainty", number(seen.searched.certainty, 3)},
                    {"stripe_points", seen.searched.stripes},
                    {"as_wide_as_a_line", seen.searched.fitting}};
  return json;
}

ordered_json line_points_as_json(const FieldPercept& percept) {
  ordered_json json = ordered_json::array();
  for (const LinePoint& one : percept.line_points)
    json.push_back(
        {{"pixel", pixel(one.pixel)}, {"position_m", meters(one.position)}, {"normal_degrees", degrees(one.normal)}});
  return json;
}

ordered_json goal_posts_as_json(const FieldPercept& percept) {
  ordered_json json = ordered_json::array();
  for (const GoalPost& post : percept.goal_posts)
    json.push_back({{"base_pixel", pixel(post.base)},
                    {"top_pixel", pixel(post.top)},
                    {"base_visible", post.base_visible},
                    {"position_m", meters(post.position)}});
  return json;
}

ordered_json obstacles_as_json(const FieldPercept& percept) {
  ordered_json json = ordered_json::array();
  for (const Obstacle& obstacle : percept.obstacles)
    json.push_back({{"left", obstacle.left},
                    {"right", obstacle.right},
                    {"top", obstacle.top},
                    {"bottom", obstacle.bottom},
                    {"position_m", meters(obstacle.position)}});
  return json;
}

ordered_json deviations(const Eigen::Matrix2d& covariance) {
  return {number(std::sqrt(covariance(0, 0)), 3), number(std::sqrt(covariance(1, 1)), 3)};
}

ordered_json intersections_as_json(const FieldPercept& percept) {
  ordered_json json = ordered_json::array();
  for (const Intersection& one : percept.intersections)
    json.push_back({{"kind", name_of(one.kind)},
                    {"pixel", pixel(one.pixel)},
                    {"position_m", meters(one.position)},
                    {"deviation_m", deviations(one.covariance)},
                    {"direction_degrees", degrees(one.direction)},
                    {"corner_arc", one.corner_arc}});
  return json;
}

ordered_json penalty_marks_as_json(const FieldPercept& percept) {
  ordered_json json = ordered_json::array();
  for (const PenaltyMark& mark : percept.penalty_marks)
    json.push_back({{"pixel", pixel(mark.pixel)},
                    {"position_m", meters(mark.position)},
                    {"deviation_m", deviations(mark.covariance)}});
  return json;
}

ordered_json center_circle_as_json(const FieldPercept& percept) {
  if (!percept.center_circle) return {};
  const CenterCircle& circle = *percept.center_circle;
  return {{"position_m", meters(circle.center)},
          {"deviation_m", deviations(circle.covariance)},
          {"halfway_degrees", circle.halfway_direction ? degrees(*circle.halfway_direction) : ordered_json()}};
}

ordered_json ball_as_json(const FieldPercept& percept) {
  if (!percept.ball) return {};
  const Ball& ball = *percept.ball;
  return {{"pixel", pixel(ball.pixel)},
          {"radius", number(ball.radius, 1)},
          {"position_m", meters(ball.position)},
          {"deviation_m", deviations(ball.covariance)}};
}

/// Rows of the carpet's upper border; null in columns without carpet.
ordered_json boundary_as_json(const SeenImage& seen) {
  ordered_json json = ordered_json::array();
  for (const float row : seen.percept.boundary)
    json.push_back(row < static_cast<float>(seen.camera.height) ? number(row, 1) : ordered_json());
  return json;
}

ordered_json tiles_as_json(const SeenImage& seen) {
  ordered_json json = ordered_json::array();
  for (const PerceivedTile& tile : seen.tiles) {
    ordered_json histogram = ordered_json::array();
    for (const float share : tile.histogram) histogram.push_back(number(share, 4));
    const int column = seen.wall.column_of(tile.tile);
    json.push_back({{"tile", tile.tile},
                    {"row", seen.wall.row_of(tile.tile)},
                    {"column", column},
                    {"azimuth_degrees", degrees((column + 0.5) * seen.wall.column_width())},
                    {"counts", tile.counts},
                    {"coverage", number(tile.coverage(), 3)},
                    {"distance_m", number(tile.distance, 2)},
                    {"histogram", std::move(histogram)}});
  }
  return json;
}

}  // namespace

const char* to_string(PitchSource source) {
  switch (source) {
    case PitchSource::given:
      return "given";
    case PitchSource::recorded:
      return "recorded";
    case PitchSource::searched:
      break;
  }
  return "searched";
}

std::string as_json(const LookImage& image, const SeenImage& seen, const RobotBody& body) {
  const CameraModel& camera = seen.camera;
  const double vertical = 2.0 * std::atan2(0.5 * camera.height, camera.focal.y());
  const auto counting =
      std::count_if(seen.tiles.begin(), seen.tiles.end(), [](const PerceivedTile& tile) { return tile.counts; });
  const ordered_json json{
      {"file", as_utf8(image.file)},
      {"image", as_utf8(image.frame.name)},
      {"time_s", image.frame.time},
      {"camera",
       {{"body", as_utf8(body.name)},
        {"width", camera.width},
        {"height", camera.height},
        {"field_of_view_degrees", {degrees(camera.horizontal_field_of_view()), degrees(vertical)}}}},
      {"camera_height_m", number(seen.height, 4)},
      {"camera_height_is_the_bodys", seen.height_is_body},
      {"pitch", pitch_as_json(seen)},
      {"roll_degrees", degrees(roll_of(seen.robot_from_camera))},
      {"horizon_row", number(seen.horizon, 1)},
      {"pose", {number(seen.pose.position.x(), 3), number(seen.pose.position.y(), 3), degrees(seen.pose.rotation)}},
      {"pose_is_recorded", seen.pose_is_recorded},
      {"counts",
       {{"line_points", seen.percept.line_points.size()},
        {"goal_posts", seen.percept.goal_posts.size()},
        {"obstacles", seen.percept.obstacles.size()},
        {"tiles", seen.tiles.size()},
        {"tiles_that_count", counting}}},
      {"shows_carpet", seen.shows_carpet},
      {"boundary_rows", boundary_as_json(seen)},
      {"line_points", line_points_as_json(seen.percept)},
      {"goal_posts", goal_posts_as_json(seen.percept)},
      {"obstacles", obstacles_as_json(seen.percept)},
      {"center_circle", center_circle_as_json(seen.percept)},
      {"intersections", intersections_as_json(seen.percept)},
      {"penalty_marks", penalty_marks_as_json(seen.percept)},
      {"ball", ball_as_json(seen.percept)},
      {"tiles", tiles_as_json(seen)}};
  return json.dump();
}

JsonList::JsonList(const std::filesystem::path& file) : file_(file), out_(file_.path(), std::ios::binary) {}

void JsonList::add(const std::string& value) {
  out_ << (is_empty_ ? "[\n" : ",\n") << value;
  is_empty_ = false;
}

void JsonList::end() {
  out_ << (is_empty_ ? "[]\n" : "\n]\n");
  out_.close();
  if (!out_) throw std::runtime_error("cannot write " + file_.path().string() + "; check the free space of the disk");
  file_.end();
}

}  // namespace reorient
