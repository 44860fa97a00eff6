// SPDX-License-Identifier: MIT
#include "workbench/views/viewer/foxglove.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <Eigen/Geometry>

#include "geometry/pinned_math.h"
#include "workbench/views/viewer/base64.h"

namespace reorient::foxglove {
namespace {

constexpr double kNanosecond = 1e-9;

// Messages are for viewing. Steps in a unit: a tenth of a millimeter, a millimeter of what there are many, a tenth of a
// pixel. Rounding takes a fifth of the text of a double.
constexpr double kExact = 1e4, kMillimeters = 1e3, kTenthsOfPixels = 1e1;

double rounded(double number, double steps = kExact) {
  return std::isfinite(number) ? std::round(steps * number) / steps : 0.0;
}

/// The same, without a fraction if it is whole: `0` takes less text than `0.0`.
Json short_number(double number, double steps) {
  const double value = rounded(number, steps);
  constexpr double kLargestWhole = 1e9;
  if (std::abs(value) < kLargestWhole && value == std::floor(value)) return static_cast<std::int64_t>(value);
  return value;
}

template <typename Vector>
Json point(const Vector& point, double steps = kExact) {
  Json json{{"x", short_number(point.x(), steps)}, {"y", short_number(point.y(), steps)}};
  if constexpr (Vector::RowsAtCompileTime == 3) json["z"] = short_number(point.z(), steps);
  return json;
}

Json quaternion(const Eigen::Matrix3d& rotation, double steps = 1e6) {
  const Eigen::Quaterniond turn(rotation);
  return {{"x", short_number(turn.x(), steps)},
          {"y", short_number(turn.y(), steps)},
          {"z", short_number(turn.z(), steps)},
          {"w", short_number(turn.w(), steps)}};
}

Json color(const scene::Color& color) {
  const auto level = [](std::uint8_t byte) { return rounded(byte / 255.0, 1e3); };
  return {{"r", level(color.red)}, {"g", level(color.green)}, {"b", level(color.blue)}, {"a", color.opacity}};
}

template <typename Point>
Json points_json(const std::vector<Point>& points, double steps) {
  Json all = Json::array();
  for (const Point& each : points) all.push_back(point(each, steps));
  return all;
}

Json pose_at(const Eigen::Vector3d& where) {
  return {{"position", point(where)}, {"orientation", {{"x", 0.0}, {"y", 0.0}, {"z", 0.0}, {"w", 1.0}}}};
}

Json triangles_json(const std::vector<scene::Shape<Eigen::Vector3d>>& shapes) {
  Json points = Json::array(), colors = Json::array(), indices = Json::array();
  for (const auto& shape : shapes) {
    if (!(shape.fill.opacity > 0.0)) continue;
    const std::size_t first = points.size();
    for (const Eigen::Vector3d& corner : shape.points) {
      points.push_back(point(corner, kMillimeters));
      colors.push_back(color(shape.fill));
    }
    for (std::size_t i = 2; i < shape.points.size(); ++i)
      for (const std::size_t corner : {std::size_t{0}, i - 1, i}) indices.push_back(first + corner);
  }
  if (points.empty()) return Json::array();
  return Json::array({{{"pose", pose_at(Eigen::Vector3d::Zero())},
                       {"points", std::move(points)},
                       {"color", color({255, 255, 255})},
                       {"colors", std::move(colors)},
                       {"indices", std::move(indices)}}});
}

/// Shapes with a common style combined into one. `is_list`: its points are pairs.
template <typename Point>
struct Stroke {
  scene::Shape<Point> shape;
  bool is_list = false;
};

/// Combines successive short lines, which reduces the text to a fraction.
template <typename Point>
std::vector<Stroke<Point>> strokes(const std::vector<scene::Shape<Point>>& shapes) {
  std::vector<Stroke<Point>> all;
  for (const scene::Shape<Point>& shape : shapes) {
    if (shape.points.empty() || !(shape.thickness > 0.0)) continue;
    const bool is_list = shape.points.size() == 2 && !shape.closed;
    if (is_list && !all.empty() && all.back().is_list && all.back().shape.color == shape.color &&
        all.back().shape.thickness == shape.thickness) {
      auto& points = all.back().shape.points;
      points.insert(points.end(), shape.points.begin(), shape.points.end());
    } else {
      all.push_back({shape, is_list});
    }
  }
  return all;
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

Json pose(const Pose2& pose) {
  const Isometry3 motion = on_the_ground(pose);
  return {{"position", point(motion.translation())}, {"orientation", quaternion(motion.linear())}};
}

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
  constexpr double kStepsOfTurn = 1e4;
  for (const Pose2& each : poses) {
    const Isometry3 motion = on_the_ground(each);
    all.push_back({{"position", point(motion.translation(), kMillimeters)},
                   {"orientation", quaternion(motion.linear(), kStepsOfTurn)}});
  }
  return {{"timestamp", time(seconds)}, {"frame_id", frame}, {"poses", std::move(all)}};
}

Json camera_calibration(double seconds, std::string_view frame, const CameraModel& camera) {
  const double fx = camera.focal.x(), fy = camera.focal.y(), cx = camera.center.x(), cy = camera.center.y();
  // Names of the camera models in ROS, which has no name for an equirectangular image.
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

Json scene_update(double seconds, std::string_view frame, std::string_view id, const scene::Scene& scene) {
  Json cylinders = Json::array(), lines = Json::array(), triangles = Json::array(), texts = Json::array();
  for (const scene::SceneLayer& layer : scene) {
    for (Json& each : triangles_json(layer.shapes)) triangles.push_back(std::move(each));
    for (const auto& [shape, is_list] : strokes(layer.shapes)) {
      lines.push_back({{"type", is_list        ? 2
                                : shape.closed ? 1
                                               : 0},  // LINE_LIST, LINE_LOOP, LINE_STRIP
                       {"pose", pose_at(Eigen::Vector3d::Zero())},
                       {"thickness", shape.thickness},
                       {"scale_invariant", false},
                       {"points", points_json(shape.points, kMillimeters)},
                       {"color", color(shape.color)},
                       {"colors", Json::array()},
                       {"indices", Json::array()}});
    }
    for (const auto& circle : layer.circles) {
      cylinders.push_back({{"pose", pose_at(circle.center + 0.5 * circle.height * Eigen::Vector3d::UnitZ())},
                           {"size", point(Eigen::Vector3d(2.0 * circle.radius, 2.0 * circle.radius, circle.height))},
                           {"bottom_scale", 1.0},
                           {"top_scale", 1.0},
                           {"color", color(circle.color)}});
    }
    for (const auto& label : layer.labels) {
      texts.push_back({{"pose", pose_at(label.position)},
                       {"billboard", true},
                       {"font_size", label.size},
                       {"scale_invariant", false},
                       {"color", color(label.color)},
                       {"text", label.text}});
    }
  }
  Json entity{{"timestamp", time(seconds)},
              {"frame_id", frame},
              {"id", id},
              {"lifetime", time(0.0)},
              {"frame_locked", true},
              {"cylinders", std::move(cylinders)},
              {"lines", std::move(lines)},
              {"triangles", std::move(triangles)},
              {"texts", std::move(texts)}};
  for (const char* const unused : {"metadata", "arrows", "cubes", "spheres", "models"}) entity[unused] = Json::array();
  return {{"deletions", Json::array()}, {"entities", Json::array({std::move(entity)})}};
}

Json image_annotations(double seconds, const scene::Overlay& overlay) {
  const Json timestamp = time(seconds);
  constexpr scene::Color kNothing{0, 0, 0, 0.0};
  Json circles = Json::array(), points = Json::array(), texts = Json::array();
  const auto add_points = [&](int type, const std::vector<Eigen::Vector2d>& pixels, double thickness,
                              const scene::Color& outline, const scene::Color& fill) {
    points.push_back({{"timestamp", timestamp},
                      {"type", type},
                      {"points", points_json(pixels, kTenthsOfPixels)},
                      {"outline_color", color(outline)},
                      {"outline_colors", Json::array()},
                      {"fill_color", color(fill)},
                      {"thickness", rounded(thickness)}});
  };
  for (const scene::OverlayLayer& layer : overlay) {
    for (const auto& [shape, is_list] : strokes(layer.shapes))  // LINE_LIST, LINE_LOOP, LINE_STRIP
      add_points(is_list ? 4 : shape.closed ? 2 : 3, shape.points, shape.thickness, shape.color, shape.fill);
    for (std::size_t i = 0; i < layer.circles.size();) {
      const auto& style = layer.circles[i];
      std::vector<Eigen::Vector2d> centers;
      for (; i < layer.circles.size() && layer.circles[i].radius == style.radius &&
             layer.circles[i].ring == style.ring && layer.circles[i].color == style.color;
           ++i)
        centers.push_back(layer.circles[i].center);
      if (!(style.ring > 0.0)) {
        add_points(1, centers, 2.0 * style.radius, style.color, style.color);  // POINTS
        continue;
      }
      for (const Eigen::Vector2d& center : centers) {
        circles.push_back({{"timestamp", timestamp},
                           {"position", point(center, kTenthsOfPixels)},
                           {"diameter", rounded(2.0 * style.radius, kTenthsOfPixels)},
                           {"thickness", rounded(style.ring, kTenthsOfPixels)},
                           {"fill_color", color(kNothing)},
                           {"outline_color", color(style.color)}});
      }
    }
    for (const auto& label : layer.labels) {
      texts.push_back({{"timestamp", timestamp},
                       {"position", point(Eigen::Vector2d(label.position + label.size * Eigen::Vector2d(0.25, 0.3)))},
                       {"text", label.text},
                       {"font_size", rounded(label.size)},
                       {"text_color", color(label.color)},
                       {"background_color", color(kNothing)}});
    }
  }
  return {{"timestamp", timestamp},
          {"circles", std::move(circles)},
          {"points", std::move(points)},
          {"texts", std::move(texts)}};
}

}  // namespace reorient::foxglove
