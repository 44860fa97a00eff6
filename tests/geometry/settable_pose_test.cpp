// SPDX-License-Identifier: MIT
#include "geometry/settable_pose.h"

#include <limits>

#include <gtest/gtest.h>

namespace reorient {
namespace {

TEST(SettablePose, IsOnOrBesideAField) {
  EXPECT_EQ(mistake_in_pose(Pose2()), "");
  EXPECT_EQ(mistake_in_pose(-60.0, 45.0, 7.0 * kPi), "") << "a corner of the largest field";
  EXPECT_EQ(mistake_in_pose(100.0, -100.0, -200.0 * kPi), "");
}

TEST(SettablePose, IsRefusedAnywhereElse) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  for (const double value : {101.0, -101.0, 1e4, 1e308, -1e308, kNan, kInf, -kInf}) {
    EXPECT_NE(mistake_in_pose(value, 0.0, 0.0), "") << value;
    EXPECT_NE(mistake_in_pose(0.0, value, 0.0), "") << value;
  }
  for (const double value : {1e3, -1e308, kNan, kInf}) EXPECT_NE(mistake_in_pose(0.0, 0.0, value), "") << value;
  EXPECT_EQ(mistake_in_pose(1e308, -2.0, 0.5),
            "expected a pose within 100 m of the field's center along each axis and within 100 turns, found 1e+308 m, "
            "-2 m, 0.5 rad");
}

}  // namespace
}  // namespace reorient
