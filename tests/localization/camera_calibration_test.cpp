// SPDX-License-Identifier: MIT
#include "localization/calibration/camera_calibration.h"

#include <vector>

#include <gtest/gtest.h>

#include "geometry/field_landmarks.h"
#include "geometry/head.h"
#include "geometry/random.h"

namespace reorient {
namespace {

const FieldDimensions kField;
const CameraModel kCamera = CameraModel::from_fields_of_view(640, 480, from_degrees(56.3), from_degrees(43.7));

/// The line points of a camera that is mounted with `offset`, computed with the nominal mounting.
std::vector<CalibrationView> views(const Pose2& robot, const CameraOffset& offset, double noise = 0.0) {
  Random random(7, 1);
  std::vector<CalibrationView> all;
  for (const double yaw : {-1.0, -0.5, 0.0, 0.5, 1.0}) {
    for (const double pitch : {0.1, 0.3}) {
      CalibrationView view;
      view.camera = kCamera;
      view.robot_from_camera = robot_from_camera(RobotDimensions(), {yaw, pitch}, {}, RobotDimensions().torso_height);
      const Isometry3 camera_from_robot = turned(view.robot_from_camera, offset).inverse();
      for (const FieldLine& line : field_lines(kField)) {
        const Eigen::Vector2d along = line.to - line.from;
        for (int i = 0; i <= 200; ++i) {
          const Eigen::Vector2d place = robot.inverse() * Eigen::Vector2d(line.from + 0.005 * i * along);
          const auto pixel = kCamera.project(camera_from_robot * Eigen::Vector3d(place.x(), place.y(), 0.0));
          if (!pixel || !kCamera.contains(*pixel) || place.norm() > 4.0) continue;
          const double normal = direction_of(rotated(along, kPi / 2.0 - robot.rotation));
          view.line_points.push_back(
              {place, normal,
               (*pixel + Eigen::Vector2d(noise * random.normal(), noise * random.normal())).cast<float>()});
        }
      }
      all.push_back(view);
    }
  }
  return all;
}

TEST(CameraCalibration, FindsHowTheCameraIsMounted) {
  const Pose2 robot(-3.2, -1.5, from_degrees(40.0));
  for (const auto& [tilt, pan] :
       {std::pair{0.0, 0.0}, {2.0, 0.0}, {-3.0, 1.5}, {4.0, -3.0}, {0.3, 0.2}, {9.0, 2.0}, {-8.0, -5.0}}) {
    const CameraOffset offset{from_degrees(tilt), from_degrees(pan)};
    const auto found = calibrate(views(robot, offset, 1.0), robot, kField);
    ASSERT_TRUE(found) << tilt << ", " << pan;
    EXPECT_NEAR(to_degrees(found->offset.tilt), tilt, 0.05) << tilt << ", " << pan;
    EXPECT_NEAR(to_degrees(found->offset.pan), pan, 0.05) << tilt << ", " << pan;
    EXPECT_LE(found->error_after, found->error_before);
    EXPECT_LT(to_degrees(found->error_after), 0.2);
  }
}

TEST(CameraCalibration, FindsNothingFromTooFewLinePoints) {
  const Pose2 robot(-3.2, -1.5, from_degrees(40.0));
  EXPECT_FALSE(calibrate({}, robot, kField));
  std::vector<CalibrationView> few = views(robot, {});
  for (CalibrationView& view : few) view.line_points.resize(std::min<std::size_t>(view.line_points.size(), 3));
  EXPECT_FALSE(calibrate(few, robot, kField));
}

TEST(CameraCalibration, FindsNothingFromAWrongPose) {
  const Pose2 robot(-3.2, -1.5, from_degrees(40.0));
  EXPECT_FALSE(calibrate(views(robot, {}), Pose2(2.0, 1.0, from_degrees(-75.0)), kField));
}

}  // namespace
}  // namespace reorient
