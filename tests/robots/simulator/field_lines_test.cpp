// SPDX-License-Identifier: MIT
#include "robots/simulator/render/scene/field_lines.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

constexpr float kSmall = 1e-3f;  // m, half size of a patch that fits into a line

TEST(FieldLines, LieAtThePositionsOfTheFieldDimensions) {
  const FieldLines lines{FieldDimensions{}};
  EXPECT_NEAR(lines.cover(0.0f, 2.0f, kSmall, kSmall), 1.0f, 1e-3f) << "halfway line";
  EXPECT_NEAR(lines.cover(-4.5f, 2.5f, kSmall, kSmall), 1.0f, 1e-3f) << "goal line";
  EXPECT_NEAR(lines.cover(2.0f, -3.0f, kSmall, kSmall), 1.0f, 1e-3f) << "touchline";
  EXPECT_NEAR(lines.cover(2.85f, 1.0f, kSmall, kSmall), 1.0f, 1e-3f) << "front of the penalty area";
  EXPECT_NEAR(lines.cover(-3.9f, -1.1f, kSmall, kSmall), 1.0f, 1e-3f) << "corner of the goal area";
  EXPECT_NEAR(lines.cover(3.2f, 0.0f, kSmall, kSmall), 1.0f, 1e-3f) << "penalty mark";
  EXPECT_NEAR(lines.cover(0.53f, 0.53f, kSmall, kSmall), 1.0f, 1e-3f) << "center circle";
  EXPECT_FLOAT_EQ(lines.cover(1.7f, 0.5f, kSmall, kSmall), 0.0f) << "plain carpet";
  EXPECT_FLOAT_EQ(lines.cover(4.8f, 1.0f, kSmall, kSmall), 0.0f) << "behind the goal line";
}

TEST(FieldLines, HaveNoGoalAreaIfTheDimensionsHaveNone) {
  FieldDimensions field;
  field.goal_area_depth = 0.0;
  EXPECT_FLOAT_EQ(FieldLines(field).cover(4.2f, 1.1f, kSmall, kSmall), 0.0f);
}

TEST(FieldLines, CoverHalfOfAPatchOnTheirEdge) {
  const FieldLines lines{FieldDimensions{}};
  EXPECT_NEAR(lines.cover(0.025f, 2.0f, 0.01f, 0.01f), 0.5f, 1e-3f);
}

RC_GTEST_PROP(FieldLines, AreTheSameAfterARotationBy180Degrees, ()) {
  const FieldLines lines{FieldDimensions{}};
  const float x = static_cast<float>(*rc::gen::inRange(-5200, 5200)) * 1e-3f;
  const float y = static_cast<float>(*rc::gen::inRange(-3700, 3700)) * 1e-3f;
  const float half = static_cast<float>(*rc::gen::inRange(1, 400)) * 1e-3f;
  RC_ASSERT(lines.cover(x, y, half, 0.02f) == lines.cover(-x, -y, half, 0.02f));
}

RC_GTEST_PROP(FieldLines, LoseNoPaintWhenAPatchIsDivided, ()) {
  // Away from corners, where lines overlap, the cover of a patch is the mean of its quarters' covers.
  const FieldLines lines{FieldDimensions{}};
  const float x = 1.6f + static_cast<float>(*rc::gen::inRange(-300, 300)) * 1e-3f;
  const float y = 3.0f + static_cast<float>(*rc::gen::inRange(-200, 200)) * 1e-3f;
  const float half = static_cast<float>(*rc::gen::inRange(2, 200)) * 1e-3f;
  float mean = 0.0f;
  for (const float across : {-0.5f, 0.5f}) {
    for (const float along : {-0.5f, 0.5f}) {
      mean += 0.25f * lines.cover(x + across * half, y + along * half, 0.5f * half, 0.5f * half);
    }
  }
  RC_ASSERT(std::abs(mean - lines.cover(x, y, half, half)) < 1e-3f);
}

}  // namespace
}  // namespace reorient
