#include "workbench/recording/viewer/foxglove.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <stdexcept>
#include <utility>

#include <Eigen/Geometry>

#include "geometry/pinned_math.h"
#include "workbench/recording/viewer/base64.h"

namespace reorient::foxglove {
namespace {

constexpr double kNanosecond = 1e-9;

Json constants_schema(int first, int last) {
  Json all = Json::array();
  for (int i = first; i <= last; ++i) all.push_back({{"const", i}});
  return {{"oneOf", std::move(all)}};
}

Json count_schema() { return {{"type", "integer"}, {"minimum", 0}}; }

Json instant_schema(Json seconds) {
  return {{"type", "object"},
          {"properties",
           {{"sec", std::move(seconds)}, {"nsec", {{"type", "integer"}, {"minimum", 0}, {"maximum", 999999999}}}}}};
}
Json time_schema() { return instant_schema(count_schema()); }
Json duration_schema() { return instant_schema(integer_schema()); }

Json numbers_schema(int count) {
  Json schema = array_schema(number_schema());
  schema["minItems"] = count;
  schema["maxItems"] = count;
  return schema;
}

Json bytes_schema() { return {{"type", "string"}, {"contentEncoding", "base64"}}; }

Json numbers_object(std::initializer_list<const char*> names) {
  std::vector<std::pair<std::string, Json>> properties;
  for (const char* const name : names) properties.emplace_back(name, number_schema());
  return object_schema(properties);
}
Json point2_schema() { return numbers_object({"x", "y"}); }
Json point3_schema() { return numbers_object({"x", "y", "z"}); }
Json quaternion_schema() { return numbers_object({"x", "y", "z", "w"}); }
Json color_schema() { return numbers_object({"r", "g", "b", "a"}); }
Json pose_schema() { return object_schema({{"position", point3_schema()}, {"orientation", quaternion_schema()}}); }

Json texts_schema() { return array_schema(object_schema({{"key", string_schema()}, {"value", string_schema()}})); }

Json entity_schema() {
  const auto posed = [](std::vector<std::pair<std::string, Json>> properties) {
    properties.insert(properties.begin(), {"pose", pose_schema()});
    return array_schema(object_schema(properties));
  };
  const Json number = number_schema(), color = color_schema(), size = point3_schema();
  const Json points = array_schema(point3_schema()), colors = array_schema(color_schema()),
             indices = array_schema(count_schema());
  return object_schema({
      {"timestamp", time_schema()},
      {"frame_id", string_schema()},
      {"id", string_schema()},
      {"lifetime", duration_schema()},
      {"frame_locked", boolean_schema()},
      {"metadata", texts_schema()},
      {"arrows", posed({{"shaft_length", number},
                        {"shaft_diameter", number},
                        {"head_length", number},
                        {"head_diameter", number},
                        {"color", color}})},
      {"cubes", posed({{"size", size}, {"color", color}})},
      {"spheres", posed({{"size", size}, {"color", color}})},
      {"cylinders", posed({{"size", size}, {"bottom_scale", number}, {"top_scale", number}, {"color", color}})},
      {"lines", array_schema(object_schema({{"type", constants_schema(0, 2)},
                                            {"pose", pose_schema()},
                                            {"thickness", number},
                                            {"scale_invariant", boolean_schema()},
                                            {"points", points},
                                            {"color", color},
                                            {"colors", colors},
                                            {"indices", indices}}))},
      {"triangles", posed({{"points", points}, {"color", color}, {"colors", colors}, {"indices", indices}})},
      {"texts", posed({{"billboard", boolean_schema()},
                       {"font_size", number},
                       {"scale_invariant", boolean_schema()},
                       {"color", color},
                       {"text", string_schema()}})},
      {"models", posed({{"scale", size},
                        {"color", color},
                        {"override_color", boolean_schema()},
                        {"url", string_schema()},
                        {"media_type", string_schema()},
                        {"data", bytes_schema()}})},
  });
}

Json scene_update_schema() {
  const Json deletion =
      object_schema({{"timestamp", time_schema()}, {"type", constants_schema(0, 1)}, {"id", string_schema()}});
  return object_schema({{"deletions", array_schema(deletion)}, {"entities", array_schema(entity_schema())}});
}

Json frame_transforms_schema() {
  return object_schema({{"transforms", array_schema(object_schema({{"timestamp", time_schema()},
                                                                   {"parent_frame_id", string_schema()},
                                                                   {"child_frame_id", string_schema()},
                                                                   {"translation", point3_schema()},
                                                                   {"rotation", quaternion_schema()}}))}});
}

Json pose_in_frame_schema() {
  return object_schema({{"timestamp", time_schema()}, {"frame_id", string_schema()}, {"pose", pose_schema()}});
}

Json poses_in_frame_schema() {
  return object_schema(
      {{"timestamp", time_schema()}, {"frame_id", string_schema()}, {"poses", array_schema(pose_schema())}});
}

Json compressed_image_schema() {
  return object_schema({{"timestamp", time_schema()},
                        {"frame_id", string_schema()},
                        {"data", bytes_schema()},
                        {"format", string_schema()}});
}

Json camera_calibration_schema() {
  return object_schema({{"timestamp", time_schema()},
                        {"frame_id", string_schema()},
                        {"width", count_schema()},
                        {"height", count_schema()},
                        {"distortion_model", string_schema()},
                        {"D", array_schema(number_schema())},
                        {"K", numbers_schema(9)},
                        {"R", numbers_schema(9)},
                        {"P", numbers_schema(12)}});
}

Json log_schema() {
  return object_schema({{"timestamp", time_schema()},
                        {"level", constants_schema(0, 5)},
                        {"message", string_schema()},
                        {"name", string_schema()},
                        {"file", string_schema()},
                        {"line", count_schema()}});
}

Json image_annotations_schema() {
  const Json color = color_schema(), number = number_schema(), point = point2_schema();
  const Json circle = object_schema({{"timestamp", time_schema()},
                                     {"position", point},
                                     {"diameter", number},
                                     {"thickness", number},
                                     {"fill_color", color},
                                     {"outline_color", color},
                                     {"metadata", texts_schema()}});
  const Json points = object_schema({{"timestamp", time_schema()},
                                     {"type", constants_schema(0, 4)},
                                     {"points", array_schema(point)},
                                     {"outline_color", color},
                                     {"outline_colors", array_schema(color)},
                                     {"fill_color", color},
                                     {"thickness", number},
                                     {"metadata", texts_schema()}});
  const Json text = object_schema({{"timestamp", time_schema()},
                                   {"position", point},
                                   {"text", string_schema()},
                                   {"font_size", number},
                                   {"text_color", color},
                                   {"background_color", color},
                                   {"metadata", texts_schema()}});
  // Metadata came later to these: they may be left out.
  const auto without_metadata = [](Json schema) {
    auto& required = schema["required"];
    required.erase(required.end() - 1);
    return schema;
  };
  Json all = object_schema({{"timestamp", time_schema()},
                            {"circles", array_schema(without_metadata(circle))},
                            {"points", array_schema(without_metadata(points))},
                            {"texts", array_schema(without_metadata(text))},
                            {"metadata", texts_schema()}});
  all["required"] = {"circles", "points", "texts"};
  return all;
}

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

Json object_schema(const std::vector<std::pair<std::string, Json>>& properties) {
  Json schema{{"type", "object"}, {"properties", Json::object()}, {"required", Json::array()}};
  for (const auto& [name, property] : properties) {
    schema["properties"][name] = property;
    schema["required"].push_back(name);
  }
  return schema;
}

Json array_schema(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }
Json number_schema() { return {{"type", "number"}}; }
Json integer_schema() { return {{"type", "integer"}}; }
Json string_schema() { return {{"type", "string"}}; }
Json boolean_schema() { return {{"type", "boolean"}}; }

Json schema(std::string_view name) {
  static const std::map<std::string_view, Json (*)()> kSchemas{
      {"foxglove.CameraCalibration", camera_calibration_schema},
      {"foxglove.CompressedImage", compressed_image_schema},
      {"foxglove.FrameTransforms", frame_transforms_schema},
      {"foxglove.ImageAnnotations", image_annotations_schema},
      {"foxglove.Log", log_schema},
      {"foxglove.PoseInFrame", pose_in_frame_schema},
      {"foxglove.PosesInFrame", poses_in_frame_schema},
      {"foxglove.SceneUpdate", scene_update_schema},
  };
  return kSchemas.at(name)();
}

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
  return {{"timestamp", time(seconds)},
          {"frame_id", frame},
          {"width", camera.width},
          {"height", camera.height},
          {"distortion_model", "plumb_bob"},
          {"D", {camera.k1, camera.k2, 0.0, 0.0, 0.0}},
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
