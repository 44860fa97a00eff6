// SPDX-License-Identifier: MIT
#include "localization/measurement/field_map.h"

#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/angle.h"
#include "geometry/pose2.h"

namespace reorient {
namespace {

const FieldMap& spl_map() {
  static const FieldMap map{FieldDimensions()};
  return map;
}

RC_GTEST_PROP(FieldMap, LooksExactlyTheSameFromAReflectedPose, (BinaryAngle normal)) {
  const auto x = static_cast<float>(*rc::gen::inRange(-7000, 7000)) * 1e-3f;
  const auto y = static_cast<float>(*rc::gen::inRange(-6000, 6000)) * 1e-3f;
  RC_ASSERT(spl_map().steps(x, y, normal) == spl_map().steps(-x, -y, normal + kHalfTurn));
}

RC_GTEST_PROP(FieldMap, LooksExactlyTheSameInAMirror, ()) {
  const auto x = static_cast<float>(*rc::gen::inRange(1, 7000)) * 1e-3f;
  const auto y = static_cast<float>(*rc::gen::inRange(1, 6000)) * 1e-3f;
  const BinaryAngle normal = *rc::gen::arbitrary<BinaryAngle>();
  RC_PRE((normal * 2 + (1u << 27)) % (1u << 28) != 0);  // between two directions, either one may be used
  RC_ASSERT(spl_map().steps(x, y, normal) == spl_map().steps(-x, y, 0u - normal));
}

RC_GTEST_PROP(FieldMap, IsZeroOnEveryLineFromBothSides, ()) {
  const std::vector<FieldLine> lines = field_lines(FieldDimensions());
  const FieldLine line = lines[static_cast<std::size_t>(*rc::gen::inRange(0, static_cast<int>(lines.size())))];
  const Eigen::Vector2d place = line.from + *rc::gen::inRange(0, 1001) * 1e-3 * (line.to - line.from);
  const double normal = std::atan2(line.to.x() - line.from.x(), line.from.y() - line.to.y());
  RC_ASSERT(spl_map().distance(place, normal) <= FieldMap::kCellSize);
  RC_ASSERT(spl_map().distance(place, normal + kPi) <= FieldMap::kCellSize);
}

RC_GTEST_PROP(FieldMap, IsZeroOnTheCenterCircle, ()) {
  const double angle = *rc::gen::inRange(-3141, 3142) * 1e-3;
  const Eigen::Vector2d place = 0.75 * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  RC_ASSERT(spl_map().distance(place, angle) <= FieldMap::kCellSize);
}

TEST(FieldMap, MeasuresTheDistanceFromATouchline) {
  for (const double meters : {0.1, 0.3, 0.5, 0.9}) {
    EXPECT_NEAR(spl_map().distance({1.7, 3.0 + meters}, kPi / 2.0), meters, FieldMap::kCellSize);
    EXPECT_NEAR(spl_map().distance({1.7, 3.0 - meters}, kPi / 2.0), meters, FieldMap::kCellSize);
  }
}

TEST(FieldMap, DoesNotMatchATouchlineWithALineAcrossIt) { EXPECT_GT(spl_map().distance({1.7, 3.0}, 0.0), 0.5); }

TEST(FieldMap, MatchesAPenaltyMarkWithALineOfAnyDirection) {
  for (double normal = 0.0; normal < kPi; normal += 0.1) {
    EXPECT_LE(spl_map().distance({3.2, 0.0}, normal), FieldMap::kCellSize);
  }
}

TEST(FieldMap, IsFarFromAllLinesBeyondItsEdge) {
  for (const double far : {10.0, 1e3, 1e9}) {
    EXPECT_EQ(spl_map().distance({far, 0.0}, 0.0), FieldMap::kMaxDistance);
    EXPECT_EQ(spl_map().distance({0.0, -far}, kPi / 2.0), FieldMap::kMaxDistance);
  }
}

TEST(FieldMap, MatchesTheTubesBehindAGoalWithLines) {
  const FieldDimensions field;
  const double rear = field.length / 2.0 + field.goal_depth;
  EXPECT_LT(spl_map().distance({rear, 0.3}, 0.0), 0.05);
  EXPECT_LT(spl_map().distance({rear - 0.2, -field.goal_post_y}, kPi / 2.0), 0.05);
  EXPECT_GT(spl_map().distance({rear + 0.4, 0.0}, 0.0), 0.3);
}

TEST(FieldMap, HasNoGoalAreaWhereItsDepthIsZero) {
  FieldDimensions field;
  const std::size_t with = field_lines(field).size();
  field.goal_area_depth = 0.0;
  EXPECT_EQ(field_lines(field).size() + 6, with);
}

TEST(FieldMap, HasTheOppositePostsAtReflectedPositions) {
  const auto posts = goal_posts(FieldDimensions());
  EXPECT_EQ(posts[0], -posts[2]);
  EXPECT_EQ(posts[1], -posts[3]);
  EXPECT_EQ(posts[0], Eigen::Vector2d(4.5, 0.8));
}

TEST(FieldMap, RejectsFieldsOfInvalidSize) {
  for (const double length :
       {0.0, -9.0, 1e9, std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    FieldDimensions field;
    field.length = length;
    EXPECT_THROW(FieldMap{field}, std::invalid_argument) << length;
  }
}

}  // namespace
}  // namespace reorient
