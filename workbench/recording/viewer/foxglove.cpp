#include "workbench/recording/viewer/foxglove.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <Eigen/Geometry>

#include "geometry/pinned_math.h"
#include "workbench/recording/viewer/base64.h"

namespace reorient::foxglove {
namespace {

constexpr double kNanosecond = 1e-9;

/// Messages are to be looked at: a tenth of a millimetre will do, and a fifth of what a double takes as text.
double rounded(double number, double steps = 1e4) {
  return std::isfinite(number) ? std::round(steps * number) / steps : 0.0;
}

Json quaternion(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond turn(rotation);
  constexpr double kSteps = 1e6;
  return {{"x", rounded(turn.x(), kSteps)},
          {"y", rounded(turn.y(), kSteps)},
          {"z", rounded(turn.z(), kSteps)},
          {"w", rounded(turn.w(), kSteps)}};
}

Json points_json(const std::vector<Eigen::Vector3d>& points) {
  Json all = Json::array();
  for (const Eigen::Vector3d& each : points) all.push_back(point(each));
  return all;
}

Json pose_at(const Eigen::Vector3d& where) {
  return {{"position", point(where)}, {"orientation", {{"x", 0.0}, {"y", 0.0}, {"z", 0.0}, {"w", 1.0}}}};
}

// Of LinePrimitive and PointsAnnotation.
enum LineType { line_strip, line_loop, line_list };
enum PointsType { points = 1, loop, strip };

Json lines_json(LineType type, const std::vector<Eigen::Vector3d>& points, double thickness, const Color& of) {
  return {{"type", static_cast<int>(type)}, {"pose", pose_at(Eigen::Vector3d::Zero())},
          {"thickness", thickness},         {"scale_invariant", false},
          {"points", points_json(points)},  {"color", color(of)},
          {"colors", Json::array()},        {"indices", Json::array()}};
}

}  // namespace

Json time(double seconds) {
  const double whole = std::floor(seconds);
  const bool is_time = whole >= 0.0 && whole < 4e9;
  if (!is_time) return {{"sec", 0}, {"nsec", 0}};
  const auto nanoseconds = static_cast<std::int64_t>(std::llround((seconds - whole) / kNanosecond));
  constexpr std::int64_t kSecond = 1000000000;
  return {{"sec", static_cast<std::int64_t>(whole) + nanoseconds / kSecond}, {"nsec", nanoseconds % kSecond}};
}

Json point(const Eigen::Vector3d& point) {
  return {{"x", rounded(point.x())}, {"y", rounded(point.y())}, {"z", rounded(point.z())}};
}

Json pose(const Pose2& pose) {
  const Isometry3 motion = on_the_ground(pose);
  return {{"position", point(motion.translation())}, {"orientation", quaternion(motion.linear())}};
}

Json color(const Color& color) { return {{"r", color.r}, {"g", color.g}, {"b", color.b}, {"a", color.a}}; }

Json transform(double seconds, std::string_view parent, std::string_view child, const Isometry3& motion) {
  return {{"timestamp", time(seconds)},
          {"parent_frame_id", parent},
          {"child_frame_id", child},
          {"translation", point(motion.translation())},
          {"rotation", quaternion(motion.linear())}};
}

Isometry3 on_the_ground(const Pose2& pose) {
  Isometry3 motion = Isometry3::Identity();
  const Eigen::Vector2d ahead = unit_vector(pose.rotation);
  motion.linear() << ahead.x(), -ahead.y(), 0.0, ahead.y(), ahead.x(), 0.0, 0.0, 0.0, 1.0;
  motion.translation() << pose.position, 0.0;
  return motion;
}

Isometry3 camera_from_optical() {
  Isometry3 turn = Isometry3::Identity();
  turn.linear() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  return turn;
}

Json pose_in_frame(double seconds, std::string_view frame, const Pose2& where) {
  return {{"timestamp", time(seconds)}, {"frame_id", frame}, {"pose", pose(where)}};
}

Json poses_in_frame(double seconds, std::string_view frame, std::span<const Pose2> poses) {
  Json all = Json::array();
  for (const Pose2& each : poses) all.push_back(pose(each));
  return {{"timestamp", time(seconds)}, {"frame_id", frame}, {"poses", std::move(all)}};
}

Json camera_calibration(double seconds, std::string_view frame, const CameraModel& camera) {
  const double fx = camera.focal.x(), fy = camera.focal.y(), cx = camera.center.x(), cy = camera.center.y();
  // ROS's names of the models; it has none for an equirectangular image.
  const char* model = "plumb_bob";
  Json coefficients = {camera.k1, camera.k2, camera.p1, camera.p2, camera.k3};
  if (camera.projection == CameraProjection::fisheye) {
    model = "equidistant";
    coefficients = {camera.k1, camera.k2, camera.k3, camera.k4};
  } else if (camera.projection == CameraProjection::equirectangular) {
    model = "equirectangular";
    coefficients = Json::array();
  } else if (camera.k4 != 0.0 || camera.k5 != 0.0 || camera.k6 != 0.0) {
    model = "rational_polynomial";
    for (const double more : {camera.k4, camera.k5, camera.k6}) coefficients.push_back(more);
  }
  return {{"timestamp", time(seconds)},
          {"frame_id", frame},
          {"width", camera.width},
          {"height", camera.height},
          {"distortion_model", model},
          {"D", std::move(coefficients)},
          {"K", {fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0}},
          {"R", {1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0}},
          {"P", {fx, 0.0, cx, 0.0, 0.0, fy, cy, 0.0, 0.0, 0.0, 1.0, 0.0}}};
}

Json compressed_image(double seconds, std::string_view frame, std::span<const std::byte> data) {
  return {{"timestamp", time(seconds)}, {"frame_id", frame}, {"data", base64(data)}, {"format", "jpeg"}};
}

Json log(double seconds, Level level, std::string_view name, std::string_view message, std::string_view file,
         int line) {
  return {{"timestamp", time(seconds)},
          {"level", static_cast<int>(level)},
          {"message", message},
          {"name", name},
          {"file", file},
          {"line", std::max(line, 0)}};
}

Entity::Entity(double seconds, std::string_view frame, std::string_view id)
    : json_{{"timestamp", time(seconds)}, {"frame_id", frame},      {"id", id},
            {"lifetime", time(0.0)},      {"frame_locked", true},   {"metadata", Json::array()},
            {"arrows", Json::array()},    {"cubes", Json::array()}, {"spheres", Json::array()},
            {"cylinders", Json::array()}, {"lines", Json::array()}, {"triangles", Json::array()},
            {"texts", Json::array()},     {"models", Json::array()}} {}

void Entity::lines(const std::vector<Eigen::Vector3d>& points, bool closed, double thickness, const Color& of) {
  json_["lines"].push_back(lines_json(closed ? line_loop : line_strip, points, thickness, of));
}

void Entity::segments(const std::vector<Eigen::Vector3d>& points, double thickness, const Color& of) {
  if (!points.empty()) json_["lines"].push_back(lines_json(line_list, points, thickness, of));
}

void Entity::quads(std::span<const Quad> quads, std::span<const Color> colors) {
  if (quads.empty()) return;
  Json points = Json::array(), of_points = Json::array(), indices = Json::array();
  for (std::size_t i = 0; i < quads.size(); ++i) {
    for (const Eigen::Vector3d& corner : quads[i]) {
      points.push_back(point(corner));
      of_points.push_back(color(colors[i]));
    }
    for (const std::size_t corner : {0, 1, 2, 0, 2, 3}) indices.push_back(4 * i + corner);
  }
  json_["triangles"].push_back({{"pose", pose_at(Eigen::Vector3d::Zero())},
                                {"points", std::move(points)},
                                {"color", color({})},
                                {"colors", std::move(of_points)},
                                {"indices", std::move(indices)}});
}

void Entity::cylinder(const Eigen::Vector3d& foot, double height, double diameter, const Color& of) {
  json_["cylinders"].push_back({{"pose", pose_at(foot + Eigen::Vector3d(0.0, 0.0, 0.5 * height))},
                                {"size", point({diameter, diameter, height})},
                                {"bottom_scale", 1.0},
                                {"top_scale", 1.0},
                                {"color", color(of)}});
}

void Entity::text(const Eigen::Vector3d& where, std::string_view text, double size, const Color& of) {
  json_["texts"].push_back({{"pose", pose_at(where)},
                            {"billboard", true},
                            {"font_size", size},
                            {"scale_invariant", false},
                            {"color", color(of)},
                            {"text", text}});
}

Json Entity::update() && {
  Json entities = Json::array();
  entities.push_back(std::move(json_));
  return {{"deletions", Json::array()}, {"entities", std::move(entities)}};
}

Annotations::Annotations(double seconds)
    : time_(time(seconds)),
      json_{{"timestamp", time_}, {"circles", Json::array()}, {"points", Json::array()}, {"texts", Json::array()}} {}

void Annotations::points(const std::vector<Eigen::Vector2d>& all, double size, const Color& color) {
  add(PointsType::points, all, size, color);
}

void Annotations::line(const std::vector<Eigen::Vector2d>& all, bool closed, double thickness, const Color& color) {
  add(closed ? PointsType::loop : PointsType::strip, all, thickness, color);
}

void Annotations::add(int type, const std::vector<Eigen::Vector2d>& all, double thickness, const Color& of) {
  if (all.empty()) return;
  Json pixels = Json::array();
  for (const Eigen::Vector2d& pixel : all) pixels.push_back({{"x", rounded(pixel.x())}, {"y", rounded(pixel.y())}});
  json_["points"].push_back({{"timestamp", time_},
                             {"type", type},
                             {"points", std::move(pixels)},
                             {"outline_color", color(of)},
                             {"outline_colors", Json::array()},
                             {"fill_color", color({0.0, 0.0, 0.0, 0.0})},
                             {"thickness", thickness}});
}

}  // namespace reorient::foxglove
