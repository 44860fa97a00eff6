#include "geometry/angle.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

TEST(Angle, OfHalfATurnIsPositivePi) {
  EXPECT_DOUBLE_EQ(normalize_angle(kPi), kPi);
  EXPECT_DOUBLE_EQ(normalize_angle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(normalize_angle(3.0 * kPi), kPi);
}

TEST(Angle, DifferenceTakesTheShortWayAcrossTheSeam) {
  EXPECT_NEAR(angle_difference(from_degrees(-179.0), from_degrees(179.0)), from_degrees(2.0), 1e-12);
  EXPECT_NEAR(angle_difference(from_degrees(179.0), from_degrees(-179.0)), from_degrees(-2.0), 1e-12);
}

RC_GTEST_PROP(Angle, NormalisedKeepsItsDirectionAndItsRange, ()) {
  const double angle = *rc::gen::inRange(-1'000'000, 1'000'000) * 1e-3;
  const double normalised = normalize_angle(angle);
  RC_ASSERT(normalised > -kPi);
  RC_ASSERT(normalised <= kPi);
  RC_ASSERT(std::abs(std::sin(normalised) - std::sin(angle)) < 1e-9);
  RC_ASSERT(std::abs(std::cos(normalised) - std::cos(angle)) < 1e-9);
}

}  // namespace
}  // namespace reorient
