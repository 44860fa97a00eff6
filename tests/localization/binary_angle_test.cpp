// SPDX-License-Identifier: MIT
#include "localization/particles/binary_angle.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

RC_GTEST_PROP(BinaryAngle, SurvivesTheConversionFromRadiansAndBack, ()) {
  const double angle = *rc::gen::inRange(-100000, 100000) * 1e-3;
  RC_ASSERT(std::abs(angle_difference(to_radians(to_binary_angle(angle)), angle)) < 2e-9);
}

RC_GTEST_PROP(BinaryAngle, HasTheSineAndCosineOfItsRadians, (BinaryAngle angle)) {
  RC_ASSERT(std::abs(static_cast<double>(sine(angle)) - std::sin(to_radians(angle))) < 4e-7);
  RC_ASSERT(std::abs(static_cast<double>(cosine(angle)) - std::cos(to_radians(angle))) < 4e-7);
}

RC_GTEST_PROP(BinaryAngle, NegatesSineAndCosineExactlyAfterHalfATurn, (BinaryAngle angle)) {
  RC_ASSERT(sine(angle + kHalfTurn) == -sine(angle));
  RC_ASSERT(cosine(angle + kHalfTurn) == -cosine(angle));
}

TEST(BinaryAngle, RepresentsTheFourQuartersExactly) {
  EXPECT_EQ(to_binary_angle(0.0), 0u);
  EXPECT_EQ(to_binary_angle(kPi / 2.0), 0x40000000u);
  EXPECT_EQ(to_binary_angle(kPi), kHalfTurn);
  EXPECT_EQ(to_binary_angle(-kPi), kHalfTurn);
  EXPECT_NEAR(sine(to_binary_angle(kPi / 2.0)), 1.0, 1e-6);
  EXPECT_NEAR(cosine(to_binary_angle(kPi)), -1.0, 1e-6);
}

}  // namespace
}  // namespace reorient
