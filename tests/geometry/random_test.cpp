// SPDX-License-Identifier: MIT
#include "geometry/random.h"

#include <gtest/gtest.h>

namespace reorient {
namespace {

TEST(Random, IsTheSameForTheSameSeedAndDiffersBetweenSeedsAndStreams) {
  Random first(7), same(7), other_seed(8), other_stream(7, 1);
  const auto value = first();
  EXPECT_EQ(value, same());
  EXPECT_NE(value, other_seed());
  EXPECT_NE(value, other_stream());
}

TEST(Random, StartsWithTheRecordedNumbers) {
  // Recorded once. A change of these numbers changes every digest.
  Random random(1);
  EXPECT_EQ(random(), 14971601782005023387ull);
}

TEST(Random, UniformFillsItsRangeEvenly) {
  Random random(3);
  constexpr int kDraws = 100'000;
  double sum = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.uniform(2.0, 4.0);
    ASSERT_GE(value, 2.0);
    ASSERT_LT(value, 4.0);
    sum += value;
  }
  EXPECT_NEAR(sum / kDraws, 3.0, 0.01);
}

TEST(Random, NormalHasMeanZeroAndVarianceOne) {
  Random random(5);
  constexpr int kDraws = 100'000;
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const double value = random.normal();
    sum += value;
    squares += value * value;
  }
  EXPECT_NEAR(sum / kDraws, 0.0, 0.02);
  EXPECT_NEAR(squares / kDraws, 1.0, 0.03);
}

}  // namespace
}  // namespace reorient
