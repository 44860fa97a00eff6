// SPDX-License-Identifier: MIT
// Percepts of a detector outside of the engine: how they merge with the field vision, and what they do.
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/covered_areas.h"
#include "engine/intersection_direction.h"
#include "engine/merged_percepts.h"
#include "engine/record/input_bytes.h"
#include "engine/record/record_bytes.h"
#include "perception/field/ground_projection.h"
#include "tests/engine/frame_fixture.h"

namespace reorient {
namespace {

using Eigen::Vector2d;

/// The upper camera of a standing NAO with 640 x 480 pixels.
DetectorCamera standing_camera() {
  DetectorCamera camera;
  camera.measured = camera.corrected =
      robot_from_camera(RobotDimensions(), {0.0, 0.3}, {}, RobotDimensions().torso_height);
  return camera;
}

class MergedPercepts : public testing::Test {
 protected:
  void add(const std::vector<ExternalPercept>& list) {
    add_external({false, list}, cameras_, FieldDimensions(), {}, {}, percepts_);
  }
  Vector2d pixel(const Vector2d& place, double height = 0.0) const {
    const auto view = GroundProjection::look(cameras_[0]->camera, cameras_[0]->measured);
    return view->pixel({place.x(), place.y(), height}).value();
  }
  static ExternalPercept on_ground(PerceptType type, const Vector2d& place, double more = 0.0) {
    ExternalPercept percept;
    percept.type = type;
    percept.at = {place.x(), place.y(), more, more};
    return percept;
  }
  ExternalPercept in_image(PerceptType type, const Vector2d& place, double height = 0.0) const {
    ExternalPercept percept;
    percept.type = type;
    percept.space = PerceptSpace::upper_image;
    const Vector2d seen = pixel(place, height);
    percept.at = {seen.x(), seen.y(), 0.0, 0.0};
    return percept;
  }
  FieldPercept& upper() { return percepts_[0]; }

  DetectorCameras cameras_{standing_camera(), std::nullopt};
  std::array<FieldPercept, 2> percepts_;
};

TEST_F(MergedPercepts, AreTheSameFromTheImageAndFromTheGround) {
  const Vector2d place(2.0, 0.4);
  for (const PerceptType type : {PerceptType::penalty_mark, PerceptType::ball}) {
    for (const ExternalPercept& percept :
         {on_ground(type, place), in_image(type, place, type == PerceptType::ball ? 0.05 : 0.0)}) {
      percepts_ = {};
      ExternalPercept sent = percept;
      if (type == PerceptType::ball) sent.at[2] = 10.0;
      add({sent});
      const Vector2d found =
          type == PerceptType::ball ? upper().ball.value().position : upper().penalty_marks.at(0).position;
      EXPECT_NEAR((found - place).norm(), 0.0, 1e-6) << to_string(type);
    }
  }
}

TEST_F(MergedPercepts, OnTheGroundAreCorrectedForTheBiasOfTheCamera) {
  // The robot measures a camera that looks 1 degree too low, so the detector projects things too near.
  cameras_[0]->corrected = robot_from_camera(RobotDimensions(), {0.0, 0.3}, {}, RobotDimensions().torso_height);
  cameras_[0]->measured =
      robot_from_camera(RobotDimensions(), {0.0, 0.3 + from_degrees(1.0)}, {}, RobotDimensions().torso_height);
  const auto seen = GroundProjection::look(cameras_[0]->camera, cameras_[0]->measured);
  const auto truth = GroundProjection::look(cameras_[0]->camera, cameras_[0]->corrected);
  const Vector2d place(3.0, 0.0);
  const Vector2d sent = seen->ground(truth->pixel({place.x(), place.y(), 0.0}).value()).value();
  ASSERT_LT(sent.x(), 2.8);
  add({on_ground(PerceptType::penalty_mark, sent)});
  EXPECT_NEAR((upper().penalty_marks.at(0).position - place).norm(), 0.0, 1e-6);
  percepts_ = {};
  add({on_ground(PerceptType::penalty_mark, {-2.0, 0.0})});
  EXPECT_EQ(upper().penalty_marks.at(0).position, Vector2d(-2.0, 0.0)) << "no camera shows it";
}

TEST_F(MergedPercepts, ReplaceWhatTheFieldVisionFoundAtTheSamePlace) {
  upper().goal_posts = {{Vector2d(3.0, 0.1)}, {Vector2d(3.0, 1.6)}};
  upper().penalty_marks = {{Vector2d(2.1, 0.0)}, {Vector2d(4.0, 0.0)}};
  upper().intersections = {{Vector2d(1.9, 0.1)}};
  upper().ball = Ball{Vector2d(5.0, 0.0)};
  upper().line_points = {{Vector2d(1.5, 0.52)}, {Vector2d(1.5, 0.9)}};
  upper().obstacles = {{Vector2d(2.0, 0.0), 300, 340, 100, 300}, {Vector2d(2.0, 0.0), 500, 540, 100, 300}};
  ExternalPercept line = on_ground(PerceptType::line, {1.0, 0.5});
  line.at[2] = 2.0;
  line.at[3] = 0.5;
  ExternalPercept robot;
  robot.type = PerceptType::robot;
  robot.space = PerceptSpace::upper_image;
  robot.at = {290.0, 80.0, 360.0, 320.0};
  ExternalPercept corner = on_ground(PerceptType::t_intersection, {2.0, 0.0});
  corner.direction = 1.0;
  add({on_ground(PerceptType::goal_post, {3.1, 0.1}), on_ground(PerceptType::penalty_mark, {2.0, 0.0}), corner,
       on_ground(PerceptType::ball, {2.0, 1.0}), line, robot});
  ASSERT_EQ(upper().goal_posts.size(), 2u);
  EXPECT_NEAR(upper().goal_posts[1].position.x(), 3.1, 1e-6);
  EXPECT_EQ(upper().penalty_marks.size(), 2u);
  ASSERT_EQ(upper().intersections.size(), 1u);
  EXPECT_EQ(upper().intersections[0].kind, IntersectionKind::t);
  EXPECT_NEAR(upper().ball->position.y(), 1.0, 1e-6);
  ASSERT_EQ(upper().line_points.size(), 11u) << "one own point is left, and ten are on the line of 1 m";
  EXPECT_EQ(upper().line_points[0].position.y(), 0.9);
  for (std::size_t i = 1; i < 11; ++i) EXPECT_NEAR(upper().line_points[i].normal, 0.5 * kPi, 1e-6);
  ASSERT_EQ(upper().obstacles.size(), 2u);
  EXPECT_EQ(upper().obstacles[1].left, 290);
}

TEST_F(MergedPercepts, OfAnIntersectionWithoutADirectionGetThatOfTheFieldVision) {
  Intersection own;
  own.position = {2.0, 0.1};
  own.kind = IntersectionKind::t;
  own.direction = 0.7;
  upper().intersections = {own};
  add({on_ground(PerceptType::t_intersection, {2.1, 0.0})});
  ASSERT_EQ(upper().intersections.size(), 1u);
  EXPECT_NEAR(upper().intersections[0].position.x(), 2.1, 1e-6);
  EXPECT_EQ(upper().intersections[0].direction, 0.7);
  // Nothing shows the direction of an X here, so the field vision's intersection stays.
  add({on_ground(PerceptType::x_intersection, {2.0, 0.0})});
  ASSERT_EQ(upper().intersections.size(), 1u);
  EXPECT_EQ(upper().intersections[0].kind, IntersectionKind::t);
}

TEST_F(MergedPercepts, NearEachOtherAreAllUsed) {
  add({on_ground(PerceptType::penalty_mark, {2.0, 0.0}), on_ground(PerceptType::penalty_mark, {2.2, 0.0})});
  EXPECT_EQ(upper().penalty_marks.size(), 2u);
}

TEST_F(MergedPercepts, OfRobotsAndPeopleCoverTheImageUpToTheirHeight) {
  ExternalPercept robot = on_ground(PerceptType::robot, {2.0, 0.0});
  robot.at[2] = 0.4;
  robot.at[3] = 0.6;
  add({robot});
  ASSERT_EQ(upper().obstacles.size(), 1u);
  const Obstacle& box = upper().obstacles[0];
  EXPECT_NEAR(box.left, pixel({2.0, 0.2}).x(), 20.0);
  EXPECT_NEAR(box.right, pixel({2.0, -0.2}).x(), 20.0);
  EXPECT_NEAR(box.top, pixel({2.0, 0.0}, 0.6).y(), 20.0);
  EXPECT_NEAR(box.bottom, pixel({2.0, 0.0}).y(), 20.0);
  std::vector<CoveredArea> covered;
  collect_covered(upper(), covered);
  EXPECT_EQ(covered.size(), 1u);
  percepts_ = {};
  ExternalPercept person;
  person.type = PerceptType::person;
  person.space = PerceptSpace::upper_image;
  person.at = {100.0, -50.0, 130.0, 20.0};  // the feet are above the horizon
  add({person, on_ground(PerceptType::person, {-2.0, 0.0})});
  ASSERT_EQ(upper().obstacles.size(), 1u) << "the camera does not show a person behind it";
  EXPECT_EQ(upper().obstacles[0].top, 0);
  EXPECT_GT(upper().obstacles[0].position.norm(), 5.0);
}

TEST_F(MergedPercepts, OfLowConfidenceOrWithInvalidNumbersAreIgnored) {
  ExternalPercept unsure = on_ground(PerceptType::ball, {2.0, 0.0});
  unsure.confidence = 0.2;
  ExternalPercept invalid = on_ground(PerceptType::ball, {2.0, std::numeric_limits<double>::quiet_NaN()});
  ExternalPercept above = in_image(PerceptType::ball, {2.0, 0.0});
  above.at = {320.0, 1.0, 5.0, 0.0};
  add({unsure, invalid, above, on_ground(PerceptType::ball, {50.0, 0.0})});
  EXPECT_FALSE(upper().ball);
  cameras_ = {};
  add({on_ground(PerceptType::ball, {2.0, 0.0})});
  EXPECT_FALSE(upper().ball) << "without a camera in this frame";
}

/// Line points of the arms at these angles (rad) around a place.
FieldPercept arms(const Vector2d& place, const std::vector<double>& angles) {
  FieldPercept percept;
  for (const double angle : angles) {
    for (int i = 2; i < 7; ++i) {
      LinePoint& point = percept.line_points.emplace_back();
      point.position = place + 0.1 * i * unit_vector(angle);
      point.normal = angle > 0.0 ? angle - 0.5 * kPi : angle + 0.5 * kPi;
    }
  }
  return percept;
}

TEST(DirectionOfAnIntersection, FollowsFromTheLinesAroundIt) {
  const Vector2d place(2.0, 1.0);
  const double right = 0.5 * kPi;
  for (const double turn : {-1.2, -0.4, 0.0, 0.3, 0.7, 1.5}) {
    const std::array<FieldPercept, 2> corner{arms(place, {turn, turn + right}), {}};
    const auto of_l = direction_from_lines(IntersectionKind::l, place, corner);
    ASSERT_TRUE(of_l) << turn;
    EXPECT_NEAR(angle_difference(*of_l, turn + 0.5 * right), 0.0, 1e-6);
    EXPECT_FALSE(direction_from_lines(IntersectionKind::x, place, {}));
    const std::array<FieldPercept, 2> end{arms(place, {turn, turn + right, turn - right}), {}};
    const auto of_t = direction_from_lines(IntersectionKind::t, place, end);
    ASSERT_TRUE(of_t) << turn;
    EXPECT_NEAR(angle_difference(*of_t, turn), 0.0, 1e-6);
    EXPECT_FALSE(direction_from_lines(IntersectionKind::l, place, end)) << "the lines are those of a T";
  }
}

RC_GTEST_PROP(MergedPerceptsProperty, AreFiniteForAnyPercepts, ()) {
  std::vector<ExternalPercept> list;
  for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
    ExternalPercept& percept = list.emplace_back();
    percept.type = static_cast<PerceptType>(*rc::gen::inRange(0, enum_count(PerceptType{})));
    percept.space = static_cast<PerceptSpace>(*rc::gen::inRange(0, enum_count(PerceptSpace{})));
    const auto number = [&] {
      const int kind = *rc::gen::inRange(0, 20);
      return kind == 0 ? std::nan("") : kind == 1 ? 1e300 : 0.1 * *rc::gen::inRange(-5000, 5000);
    };
    for (double& one : percept.at) one = number();
    if (*rc::gen::arbitrary<bool>()) percept.direction = 0.01 * number();
    if (*rc::gen::arbitrary<bool>()) percept.covariance = {number(), number(), number()};
    percept.base_hidden = *rc::gen::arbitrary<bool>();
  }
  std::array<FieldPercept, 2> percepts;
  DetectorCameras cameras{standing_camera(), standing_camera()};
  if (*rc::gen::arbitrary<bool>()) cameras[1].reset();
  add_external({false, list}, cameras, FieldDimensions(), {}, {}, percepts);
  for (const FieldPercept& percept : percepts) {
    for (const LinePoint& one : percept.line_points) RC_ASSERT(one.position.allFinite() && std::isfinite(one.normal));
    for (const GoalPost& one : percept.goal_posts) RC_ASSERT(one.position.allFinite());
    for (const Intersection& one : percept.intersections)
      RC_ASSERT(one.position.allFinite() && one.covariance.allFinite() && one.covariance.determinant() > 0.0);
    for (const PenaltyMark& one : percept.penalty_marks)
      RC_ASSERT(one.position.allFinite() && one.covariance.determinant() > 0.0);
    for (const Obstacle& one : percept.obstacles)
      RC_ASSERT(one.position.allFinite() && 0 <= one.left && one.left <= one.right && one.right < 640 && 0 <= one.top &&
                one.top <= one.bottom && one.bottom < 480);
    RC_ASSERT(!percept.ball || percept.ball->covariance.allFinite());
    RC_ASSERT(!percept.center_circle || percept.center_circle->covariance.determinant() > 0.0);
    RC_ASSERT(percept.line_points.size() <= 600u && percept.obstacles.size() <= 64u);
  }
}

TEST(ExternalPercepts, OfABallAreWhatBehaviorsSee) {
  HandFedLoop loop(kIdle);
  const std::vector<ExternalPercept> ball{{.type = PerceptType::ball, .at = {1.5, 0.5, 0.0, 0.0}}};
  loop.inputs.observation.percepts = {false, ball};
  EXPECT_TRUE(loop.step().world.ball);
  EXPECT_NEAR(loop.world().ball_distance, std::hypot(1.5, 0.5), 1e-6);
  loop.inputs.observation.percepts.reset();
  EXPECT_FALSE(loop.step().world.ball);
}

TEST(ExternalPercepts, AreIgnoredWhileTheRobotIsLifted) {
  HandFedLoop loop(kIdle);
  const std::vector<ExternalPercept> ball{{.type = PerceptType::ball, .at = {1.5, 0.5, 0.0, 0.0}}};
  loop.lift();
  loop.inputs.observation.percepts = {false, ball};
  EXPECT_FALSE(loop.step().world.ball);
}

TEST(ExternalPercepts, LocateTheRobotInsteadOfTheFieldVision) {
  HandFedLoop loop(kIdle);  // its image shows no field
  const Pose2 truth(1.0, 0.5, 0.3);
  loop.set_pose(truth * Pose2(0.3, -0.3, 0.1));
  std::vector<ExternalPercept> lines;
  for (const FieldLine& line : field_lines(FieldDimensions())) {
    const Vector2d from = truth.inverse() * line.from, to = truth.inverse() * line.to;
    lines.push_back({.type = PerceptType::line, .at = {from.x(), from.y(), to.x(), to.y()}});
  }
  loop.inputs.observation.percepts = {true, lines};
  loop.step(90);
  expect_near(loop.world().pose.pose, truth, 0.08);
}

TEST(ExternalPercepts, SurviveTheBytesOfTheInputsAndGiveTheSameFrames) {
  HandFedLoop loop(kIdle), replay(kIdle);
  const std::vector<ExternalPercept> percepts{
      {.type = PerceptType::ball, .at = {1.5, 0.5, 0.0, 0.0}, .covariance = {{0.1, 0.0, 0.1}}},
      {.type = PerceptType::line_point, .at = {2.0, 0.5, 0.0, 0.0}, .direction = 0.3}};
  std::vector<std::byte> without, with;
  write_inputs_without_pixels(loop.inputs, without);
  loop.inputs.observation.percepts = {true, percepts};
  write_inputs_without_pixels(loop.inputs, with);
  ASSERT_GT(with.size(), without.size());
  EXPECT_TRUE(std::equal(without.begin(), without.end(), with.begin())) << "they are a part at the end";
  for (std::size_t size = without.size() + 1; size < with.size(); ++size)
    EXPECT_THROW(StoredInputs(std::span(with).first(size)), BadBytes) << size;
  std::vector<std::byte> bytes;
  write_inputs(loop.inputs, bytes);
  const StoredInputs stored(bytes);
  ASSERT_TRUE(stored.inputs().observation.percepts);
  EXPECT_TRUE(stored.inputs().observation.percepts->replaces_vision);
  std::vector<std::byte> recorded, replayed;
  write_record(loop.engine->step(loop.inputs), recorded);
  write_record(replay.engine->step(stored.inputs()), replayed);
  EXPECT_EQ(recorded, replayed);
  EXPECT_TRUE(loop.world().ball);
}

}  // namespace
}  // namespace reorient
