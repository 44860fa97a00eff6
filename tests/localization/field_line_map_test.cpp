// SPDX-License-Identifier: MIT
#include "localization/measurement/field_line_map.h"

#include <gtest/gtest.h>

#include "tests/localization/biased_camera.h"

namespace reorient {
namespace {

const CameraModel kWideCamera = CameraModel::from_fields_of_view(640, 480, from_degrees(56.3), from_degrees(43.7));

double length_from(const Pose2& robot, const HeadAngles& head, double farthest) {
  return FieldLineMap(FieldDimensions()).length_in_view(robot, kWideCamera, BiasedCamera::measured(head), farthest);
}

TEST(FieldLineMap, HasTheHalfwayLineInViewOfARobotThatFacesIt) {
  // 2 m before it and near the touchline, the camera shows a part of it that is about as wide as it is far away.
  const double length = length_from({-2.0, 2.0, 0.0}, {0.0, 0.3}, 2.3);
  EXPECT_GT(length, 1.0);
  EXPECT_LT(length, 2.5);
}

TEST(FieldLineMap, HasNoLineInViewOfARobotThatFacesTheWalls) {
  EXPECT_EQ(length_from({-3.2, -3.3, -0.5 * kPi}, {0.0, 0.0}, 6.0), 0.0);
  EXPECT_EQ(length_from({-2.0, 0.0, 0.0}, {0.0, -0.6}, 6.0), 0.0);
}

TEST(FieldLineMap, ShowsMoreOfTheFieldToACameraThatMaySeeFarther) {
  EXPECT_LT(length_from({-2.0, 0.0, 0.0}, {0.0, 0.2}, 2.5), length_from({-2.0, 0.0, 0.0}, {0.0, 0.2}, 5.0));
}

}  // namespace
}  // namespace reorient
