// SPDX-License-Identifier: MIT
#include "geometry/angle.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/random.h"

namespace reorient {
namespace {

TEST(Angle, Of180DegreesIsPositivePi) {
  EXPECT_DOUBLE_EQ(normalize_angle(kPi), kPi);
  EXPECT_DOUBLE_EQ(normalize_angle(-kPi), kPi);
  EXPECT_DOUBLE_EQ(normalize_angle(3.0 * kPi), kPi);
}

TEST(Angle, DifferenceIsTheShorterArcAcrossTheSeam) {
  EXPECT_NEAR(angle_difference(from_degrees(-179.0), from_degrees(179.0)), from_degrees(2.0), 1e-12);
  EXPECT_NEAR(angle_difference(from_degrees(179.0), from_degrees(-179.0)), from_degrees(-2.0), 1e-12);
}

RC_GTEST_PROP(Angle, NormalizedHasTheSameDirectionAndIsInRange, ()) {
  const double angle = *rc::gen::inRange(-1'000'000, 1'000'000) * 1e-3;
  const double normalized = normalize_angle(angle);
  RC_ASSERT(normalized > -kPi);
  RC_ASSERT(normalized <= kPi);
  RC_ASSERT(std::abs(std::sin(normalized) - std::sin(angle)) < 1e-9);
  RC_ASSERT(std::abs(std::cos(normalized) - std::cos(angle)) < 1e-9);
}

/// The bits must be equal, since digests depend on them.
RC_GTEST_PROP(Angle, NormalizedIsTheRemainderToTheLastBit, (std::uint64_t seed)) {
  const auto by_remainder = [](double angle) {
    const double turned = std::remainder(angle, 2.0 * kPi);
    return turned <= -kPi ? kPi : turned;
  };
  const auto same_bits = [](double a, double b) { return a == b && std::signbit(a) == std::signbit(b); };
  Random random(seed);
  for (int i = 0; i < 100; ++i) {
    const double angle = random.uniform(-12.0, 12.0);
    RC_ASSERT(same_bits(normalize_angle(angle), by_remainder(angle)));
  }
  for (const double halves : {0.0, 1.0, 2.0, 3.0, 4.0, 5.0}) {
    for (const double exact : {halves * kPi, -halves * kPi}) {
      for (const double angle : {exact, std::nextafter(exact, 100.0), std::nextafter(exact, -100.0)})
        RC_ASSERT(same_bits(normalize_angle(angle), by_remainder(angle)));
    }
  }
  RC_ASSERT(std::isnan(normalize_angle(std::numeric_limits<double>::quiet_NaN())));
  RC_ASSERT(std::isnan(normalize_angle(std::numeric_limits<double>::infinity())));
}

}  // namespace
}  // namespace reorient
