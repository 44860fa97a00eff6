// SPDX-License-Identifier: MIT
// The camera offset from many images, by vertical edges and by field lines, and what these do not determine.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/field_landmarks.h"
#include "geometry/random.h"
#include "localization/calibration/edge_offset.h"
#include "localization/calibration/line_offset.h"

namespace reorient {
namespace {

const CameraModel kFootageCamera = CameraModel::from_fields_of_view(640, 480, from_degrees(56.3), from_degrees(43.7));

constexpr auto index_of(OffsetComponent component) { return static_cast<std::size_t>(component); }

/// Images of poles around the camera, with some clutter. `widest`: largest bearing of a pole to both sides, rad.
std::vector<EdgeView> pole_views(const CameraOffset& offset, double widest, int poles = 12, int clutter = 8) {
  Random random(3, 1);
  std::vector<EdgeView> views;
  for (int image = 0; image < 40; ++image) {
    EdgeView& view = views.emplace_back();
    view.camera = kFootageCamera;
    const double pitch = random.uniform(-0.15, 0.15), roll = random.uniform(-0.05, 0.05);
    view.robot_from_camera.linear() = rotation_about_y(pitch) * rotation_about_x(roll);
    view.robot_from_camera.translation().z() = 0.5;
    const Isometry3 camera_from_robot = turned(view.robot_from_camera, offset).inverse();
    for (int i = 0; i < poles; ++i) {
      const double bearing = random.uniform(-widest, widest), low = random.uniform(-0.5, 0.0);
      const Eigen::Vector2d place = 3.0 * unit_vector(bearing);
      const auto upper = kFootageCamera.project(camera_from_robot * Eigen::Vector3d(place.x(), place.y(), low + 1.5));
      const auto lower = kFootageCamera.project(camera_from_robot * Eigen::Vector3d(place.x(), place.y(), low + 0.5));
      if (!upper || !lower) continue;
      const double first = random.normal(), second = random.normal();
      view.edges.push_back({*upper + Eigen::Vector2d(first, 0.0), *lower + Eigen::Vector2d(second, 0.0)});
    }
    for (int i = 0; i < clutter; ++i) {
      const double u = random.uniform(0.0, 640.0), v = random.uniform(0.0, 400.0), lean = random.uniform(-0.6, 0.6);
      view.edges.push_back({{u, v}, {u + 80.0 * lean, v + 80.0}});
    }
  }
  return views;
}

TEST(EdgeOffset, IsFoundDespiteClutter) {
  for (const auto& [tilt, roll] : {std::pair{0.0, 0.0}, {8.0, 3.0}, {-8.0, -3.0}, {5.0, -1.0}}) {
    const OffsetEstimate found =
        mounting_from_edges(pole_views({.tilt = from_degrees(tilt), .roll = from_degrees(roll)}, 0.5)).estimate;
    ASSERT_TRUE(found.deviation[index_of(OffsetComponent::tilt)]) << tilt;
    ASSERT_TRUE(found.deviation[index_of(OffsetComponent::roll)]) << roll;
    EXPECT_NEAR(to_degrees(found.offset.tilt), tilt, 0.3);
    EXPECT_NEAR(to_degrees(found.offset.roll), roll, 0.15);
    EXPECT_LT(to_degrees(*found.deviation[index_of(OffsetComponent::tilt)]), 0.3);
    EXPECT_FALSE(found.deviation[index_of(OffsetComponent::pan)]);
    EXPECT_FALSE(found.deviation[index_of(OffsetComponent::height)]);
    EXPECT_EQ(found.offset.pan, 0.0);
  }
}

TEST(EdgeOffset, OfEdgesInTheMiddleOfTheImageHasNoTilt) {
  const OffsetEstimate found = mounting_from_edges(pole_views({.roll = from_degrees(2.0)}, 0.02, 12, 0)).estimate;
  EXPECT_FALSE(found.deviation[index_of(OffsetComponent::tilt)]);
  ASSERT_TRUE(found.deviation[index_of(OffsetComponent::roll)]);
  EXPECT_NEAR(to_degrees(found.offset.roll), 2.0, 0.3);
}

/// Images with different roll and pitch, of which only these fractions were recorded.
std::vector<EdgeView> swaying_views(double roll_fraction, double pitch_fraction) {
  std::vector<EdgeView> views = pole_views({.tilt = from_degrees(2.0), .roll = from_degrees(1.0)}, 0.5);
  Random random(3, 1);
  for (EdgeView& view : views) {
    const Isometry3 level = view.robot_from_camera;
    const double pitch = random.uniform(-0.1, 0.1), roll = random.uniform(-0.1, 0.1);
    const Isometry3 swaying = with_attitude(level, pitch_of(level) + pitch, roll_of(level) + roll);
    // The poles as the swaying camera sees them.
    const Eigen::Matrix3d swaying_from_level = swaying.linear().transpose() * level.linear();
    for (ImageEdge& edge : view.edges) {
      for (Eigen::Vector2d* const end : {&edge.upper, &edge.lower})
        *end = view.camera.project(swaying_from_level * view.camera.ray(*end)).value_or(*end);
    }
    view.robot_from_camera =
        with_attitude(level, pitch_of(level) + pitch_fraction * pitch, roll_of(level) + roll_fraction * roll);
  }
  return views;
}

TEST(EdgeOffset, LeavesOutARecordedAttitudeThatDoesNotBelongToTheImages) {
  EXPECT_EQ(mounting_from_edges(swaying_views(1.0, 1.0)).recorded, RecordedAttitude());
  EXPECT_EQ(mounting_from_edges(swaying_views(-1.0, 1.0)).recorded, (RecordedAttitude{.roll = false}));
  EXPECT_EQ(mounting_from_edges(swaying_views(1.0, -1.0)).recorded, (RecordedAttitude{.pitch = false}));
  // Without sway, the recorded attitude is correct.
  EXPECT_EQ(mounting_from_edges(pole_views({.tilt = from_degrees(2.0)}, 0.5)).recorded, RecordedAttitude());
}

TEST(EdgeOffset, OfClutterAloneIsNotDetermined) {
  const OffsetEstimate found = mounting_from_edges(pole_views({}, 0.5, 0, 20)).estimate;
  EXPECT_FALSE(found.deviation[index_of(OffsetComponent::tilt)]);
  EXPECT_FALSE(found.deviation[index_of(OffsetComponent::roll)]);
  EXPECT_FALSE(mounting_from_edges({}).estimate.deviation[0]);
}

TEST(VerticalEdges, HaveTheDirectionOfABoundaryToATenthOfADegree) {
  for (const double degrees : {-12.0, -3.3, 0.0, 0.7, 5.0, 14.0}) {
    Image image(160, 120);
    const Eigen::Vector2d across = unit_vector(from_degrees(degrees));  // of the boundary
    for (int v = 0; v < 120; ++v) {
      for (int u = 0; u < 160; ++u) {
        const double distance = across.dot(Eigen::Vector2d(u - 79.5, v - 59.5));
        image.row(v)[2 * u] =
            static_cast<std::uint8_t>(std::lround(60.0 + 120.0 * std::clamp(distance + 0.5, 0.0, 1.0)));
        image.row(v)[2 * u + 1] = 128;
      }
    }
    const CameraModel camera = kFootageCamera.scaled_to(160, 120);
    const std::vector<ImageEdge> edges = vertical_edges(image.view(), camera, Isometry3::Identity(), kEdgeReach);
    ASSERT_EQ(edges.size(), 1u) << degrees;
    const Eigen::Vector2d along = edges.front().lower - edges.front().upper;
    EXPECT_NEAR(to_degrees(-std::atan2(along.x(), along.y())), degrees, 0.1);
    EXPECT_GT(edges.front().length(), 100.0);
  }
}

TEST(VerticalEdges, AreNotFoundInAUniformImageNorFromAHorizontalEdge) {
  EXPECT_TRUE(vertical_edges(Image(160, 120).view(), kFootageCamera, Isometry3::Identity(), kEdgeReach).empty());
  Image image(160, 120);
  for (int v = 60; v < 120; ++v) {
    for (int u = 0; u < 160; ++u) image.row(v)[2 * u] = 200;
  }
  EXPECT_TRUE(
      vertical_edges(image.view(), kFootageCamera.scaled_to(160, 120), Isometry3::Identity(), kEdgeReach).empty());
  EXPECT_TRUE(vertical_edges(ImageView(), kFootageCamera, Isometry3::Identity(), kEdgeReach).empty());
}

/// Line points of images from many poses, computed with the recorded camera poses.
std::vector<LineView> line_views_of(const CameraOffset& offset, const FieldDimensions& field, double noise) {
  Random random(5, 1);
  std::vector<LineView> views;
  for (int image = 0; image < 30; ++image) {
    LineView& view = views.emplace_back();
    view.camera = kFootageCamera;
    const double x = random.uniform(-3.5, 3.5), y = random.uniform(-2.5, 2.5);
    view.robot = Pose2(x, y, random.uniform(-kPi, kPi));
    view.robot_from_camera.linear() = rotation_about_z(random.uniform(-0.8, 0.8)) * rotation_about_y(0.3);
    view.robot_from_camera.translation().z() = 0.5;
    view.found_from_camera = view.robot_from_camera;
    const Isometry3 camera_from_robot = turned(view.robot_from_camera, offset).inverse();
    for (const FieldLine& line : field_lines(field)) {
      const Eigen::Vector2d along = line.to - line.from;
      for (int i = 0; i <= 25; ++i) {
        const Eigen::Vector2d place = view.robot.inverse() * Eigen::Vector2d(line.from + i / 25.0 * along);
        const auto pixel = kFootageCamera.project(camera_from_robot * Eigen::Vector3d(place.x(), place.y(), 0.0));
        if (!pixel || !kFootageCamera.contains(*pixel) || place.norm() > 3.5) continue;
        // The finder places the point and its neighbor on the ground with the recorded camera pose.
        const auto on_ground = [&](const Eigen::Vector2d& at) {
          const Eigen::Vector3d ray = view.robot_from_camera.linear() * kFootageCamera.ray(at);
          return Eigen::Vector2d(-0.5 / ray.z() * ray.head<2>());
        };
        const Eigen::Vector2d next = place + 0.01 * rotated(along, -view.robot.rotation).normalized();
        const auto farther = kFootageCamera.project(camera_from_robot * Eigen::Vector3d(next.x(), next.y(), 0.0));
        if (!farther) continue;
        const double du = noise * random.normal(), dv = noise * random.normal();
        const Eigen::Vector2d seen = *pixel + Eigen::Vector2d(du, dv);
        const double direction = direction_of(on_ground(*farther + Eigen::Vector2d(du, dv)) - on_ground(seen));
        view.line_points.push_back({on_ground(seen), direction + 0.5 * kPi, seen.cast<float>()});
      }
    }
  }
  return views;
}

TEST(LineOffset, IsFoundWithAllItsComponents) {
  const FieldDimensions field;
  for (const auto& [tilt, pan, roll, height] :
       {std::array{0.0, 0.0, 0.0, 0.0}, {8.0, 3.0, 3.0, 0.05}, {-8.0, -2.0, -3.0, -0.05}, {4.0, 5.0, -2.0, 0.03}}) {
    const CameraOffset offset{from_degrees(tilt), from_degrees(pan), from_degrees(roll), height};
    const OffsetEstimate found = offset_from_lines(line_views_of(offset, field, 1.0), field);
    EXPECT_NEAR(to_degrees(found.offset.tilt), tilt, 0.1);
    EXPECT_NEAR(to_degrees(found.offset.pan), pan, 0.1);
    EXPECT_NEAR(to_degrees(found.offset.roll), roll, 0.1);
    EXPECT_NEAR(found.offset.height, height, 0.005);
    for (const std::optional<double>& deviation : found.deviation) EXPECT_TRUE(deviation);
  }
}

TEST(LineOffset, IsNotDeterminedFromWrongPosesOrFewPoints) {
  const FieldDimensions field;
  std::vector<LineView> views = line_views_of({}, field, 1.0);
  Random random(9, 1);
  for (LineView& view : views) {
    const double x = random.uniform(-3.0, 3.0);
    view.robot = Pose2(x, 1.0, random.uniform(-kPi, kPi));
  }
  EXPECT_FALSE(offset_from_lines(views, field).deviation[0]);
  for (LineView& view : views) view.line_points.resize(std::min<std::size_t>(view.line_points.size(), 1));
  EXPECT_FALSE(offset_from_lines(views, field).deviation[0]);
  EXPECT_FALSE(offset_from_lines({}, field).deviation[0]);
}

}  // namespace
}  // namespace reorient
