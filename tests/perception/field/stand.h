// SPDX-License-Identifier: MIT
// A robot that stands on the flat field of the tests, and its field features.
#pragma once

#include <cmath>

#include <gtest/gtest.h>

#include "geometry/head.h"
#include "tests/perception/field/flat_field.h"
#include "tests/perception/field/percept_in.h"

namespace reorient {

/// A NAO on the field, its camera, and the true pose of the camera.
struct Stand {
  CameraModel camera;
  Isometry3 robot_from_camera;
  Pose2 field_from_robot;

  Stand(int width, int height, const Pose2& pose, const HeadAngles& head, const TorsoAttitude& torso = {})
      : camera(CameraModel::from_fields_of_view(width, height, from_degrees(56.3), from_degrees(43.7))),
        robot_from_camera(reorient::robot_from_camera({}, head, torso, RobotDimensions{}.torso_height)),
        field_from_robot(pose) {}

  Image see(const FlatField& scene) const {
    return render(scene, camera, to_isometry(field_from_robot) * robot_from_camera);
  }
};

inline FieldPercept percept_of(const FlatField& scene, const Stand& stand) {
  FieldFeatures features({}, scene.field);
  const Image image = stand.see(scene);
  return percept_in(features, image.view(), stand.camera, stand.robot_from_camera);
}

/// The percept of a robot that has stood on a field of these colors for some images.
inline FieldPercept percept_after(const FlatField& scene, const Stand& stand, int images) {
  FieldFeatures features({}, scene.field);
  const Image image = stand.see(scene);
  FieldPercept percept;
  for (int i = 0; i < images; ++i) percept = percept_in(features, image.view(), stand.camera, stand.robot_from_camera);
  return percept;
}

inline bool is_empty(const FieldPercept& percept) {
  return percept.line_points.empty() && percept.goal_posts.empty() && percept.obstacles.empty();
}

/// Checks the fraction of line points on a true line, and the fraction of them with the normal of that line.
inline void expect_line_points_on_lines(const FieldPercept& percept, const FlatField& scene, const Stand& stand) {
  int misplaced = 0;
  int twisted = 0;
  for (const LinePoint& point : percept.line_points) {
    const NearestLine line = nearest_line(scene.field, stand.field_from_robot * point.position);
    const double turned = normalize_angle(2.0 * (point.normal + stand.field_from_robot.rotation - line.normal)) / 2.0;
    misplaced += line.distance > 0.05 + 0.03 * point.position.norm() ? 1 : 0;
    twisted += std::abs(turned) > from_degrees(10.0) ? 1 : 0;
    EXPECT_GT(point.normal, -0.5 * kPi);
    EXPECT_LE(point.normal, 0.5 * kPi);
  }
  const double count = static_cast<double>(percept.line_points.size());
  EXPECT_LE(misplaced, 0.02 * count) << "of " << count;
  EXPECT_LE(twisted, 0.15 * count) << "of " << count;
}

}  // namespace reorient
