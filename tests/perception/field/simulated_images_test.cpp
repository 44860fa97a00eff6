// How good the field features are in the simulator's images, with its blur, noise, vignetting, people and other robots.
// The camera's place is the true one, so that what is measured is the vision and not the inertial unit.
#include <cmath>
#include <optional>

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "perception/field/field_features.h"
#include "robots/simulator/simulator.h"
#include "tests/perception/field/flat_field.h"
#include "tests/perception/field/percept_in.h"

namespace reorient {
namespace {

struct Score {
  int frames = 0;
  int line_points = 0, misplaced = 0, twisted = 0;
  int lines_in_view = 0, lines_found = 0;  ///< places on lines closer than 3.5 m
  int posts = 0, false_posts = 0;
  int posts_in_view = 0, posts_found = 0;
  int robots_in_view = 0, robots_found = 0;
};

struct Snapshot {
  const Simulator& simulator;
  const CameraFrame& frame;
  const FieldPercept& percept;
  Isometry3 robot_from_camera;
  Pose2 truth;

  Label label(const Eigen::Vector2d& pixel) const {
    const auto index = std::lround(pixel.y()) * frame.image.width + std::lround(pixel.x());
    return simulator.labels()[static_cast<std::size_t>(index)];
  }
  /// The pixel of a point given in the robot frame, unless it is at the image's rim or outside.
  std::optional<Eigen::Vector2d> pixel(const Eigen::Vector2d& point, double height) const {
    auto seen = frame.camera.project(robot_from_camera.inverse() * Eigen::Vector3d(point.x(), point.y(), height));
    const double rim = 0.03 * frame.image.width;
    if (seen && (seen->x() < rim || seen->y() < rim || seen->x() > frame.image.width - 1 - rim ||
                 seen->y() > frame.image.height - 1 - rim)) {
      seen.reset();
    }
    return seen;
  }
};

void score_lines(const Snapshot& shot, const FieldDimensions& field, Score& score) {
  for (const LinePoint& point : shot.percept.line_points) {
    const NearestLine line = nearest_line(field, shot.truth * point.position);
    const double turned = normalize_angle(2.0 * (point.normal + shot.truth.rotation - line.normal)) / 2.0;
    ++score.line_points;
    score.misplaced += line.distance > 0.05 + 0.03 * point.position.norm() ? 1 : 0;
    score.twisted += std::abs(turned) > from_degrees(10.0) ? 1 : 0;
  }
  for (double x = -4.5; x <= 4.5; x += 0.1) {
    for (double y = -3.0; y <= 3.0; y += 0.1) {
      const Eigen::Vector2d place = shot.truth.inverse() * Eigen::Vector2d(x, y);
      if (nearest_line(field, {x, y}).distance > 0.02 || place.norm() > 3.5) continue;
      const auto pixel = shot.pixel(place, 0.0);
      if (!pixel || shot.label(*pixel) != Label::line) continue;
      ++score.lines_in_view;
      for (const LinePoint& point : shot.percept.line_points) {
        if ((point.position - place).norm() > 0.25) continue;
        ++score.lines_found;
        break;
      }
    }
  }
}

void score_posts(const Snapshot& shot, const FieldDimensions& field, Score& score) {
  score.posts += static_cast<int>(shot.percept.goal_posts.size());
  score.false_posts += static_cast<int>(shot.percept.goal_posts.size());
  for (const double x : {-0.5 * field.length, 0.5 * field.length}) {
    for (const double y : {-field.goal_post_y, field.goal_post_y}) {
      const Eigen::Vector2d place = shot.truth.inverse() * Eigen::Vector2d(x, y);
      int found = 0;
      for (const GoalPost& post : shot.percept.goal_posts) {
        if ((post.position - place).norm() < 0.05 + 0.15 * place.norm()) ++found;
      }
      score.false_posts -= found;
      const auto foot = shot.pixel(place, 0.05);
      if (!foot || !shot.pixel(place, 0.5) || place.norm() > 4.5 || shot.label(*foot) != Label::goal) continue;
      ++score.posts_in_view;
      score.posts_found += found > 0 ? 1 : 0;
    }
  }
}

void score_robots(const Snapshot& shot, Score& score) {
  for (const Player& player : shot.simulator.other_robots()) {
    const Eigen::Vector2d place = shot.truth.inverse() * player.pose.position;
    if (place.norm() < 0.8 || place.norm() > 3.0 || !shot.pixel(place, 0.05)) continue;
    ++score.robots_in_view;
    for (const Obstacle& obstacle : shot.percept.obstacles) {
      if ((obstacle.position - place).norm() > 0.3 + 0.1 * place.norm()) continue;
      ++score.robots_found;
      break;
    }
  }
}

Score look_around(int width, int places) {
  const FieldDimensions field;
  SimulatorParameters parameters;
  parameters.width = width;
  parameters.labels = true;
  parameters.tilt_error = 0.0;
  parameters.other_robots = 8;
  const Room room = procedural_hall(2, {});
  Simulator simulator(parameters, RobotBody(), field, room, {-2.0, 0.0, 0.0}, 11);
  FieldFeatures features({}, field);
  Random random(5);
  Score score;
  for (int i = 0; i < places; ++i) {
    simulator.put_down({random.uniform(-4.2, 4.2), random.uniform(-2.8, 2.8), random.uniform(-kPi, kPi)});
    Answer answer;
    answer.request.head = HeadRequest{{random.uniform(-1.0, 1.0), random.uniform(-0.05, 0.3)}, 10.0};
    simulator.answer(answer);
    Observation observation;
    for (int k = 0; k < 5; ++k) simulator.observe(observation);
    const CameraFrame& frame = observation.upper.value();
    const Pose2 truth = simulator.ground_truth().pose;
    const Isometry3 robot_from_camera = to_isometry(truth).inverse() * simulator.field_from_camera();
    const FieldPercept percept = percept_in(features, frame.image, frame.camera, robot_from_camera);
    const Snapshot shot{simulator, frame, percept, robot_from_camera, truth};
    ++score.frames;
    score_lines(shot, field, score);
    score_posts(shot, field, score);
    score_robots(shot, score);
  }
  return score;
}

struct Look {
  int width;
  int places;
};
class SimulatedImages : public testing::TestWithParam<Look> {};

TEST_P(SimulatedImages, ShowLinesAndPostsToTheFieldFeatures) {
  const Score score = look_around(GetParam().width, GetParam().places);
  RecordProperty("line_points", score.line_points);
  RecordProperty("misplaced", score.misplaced);
  RecordProperty("twisted", score.twisted);
  RecordProperty("posts_found", score.posts_found);
  RecordProperty("posts_in_view", score.posts_in_view);
  RecordProperty("robots_found", score.robots_found);
  RecordProperty("robots_in_view", score.robots_in_view);
  EXPECT_GE(score.line_points, 25 * score.frames);
  EXPECT_LE(score.misplaced, 0.02 * score.line_points);
  EXPECT_LE(score.twisted, 0.08 * score.line_points);
  ASSERT_GE(score.lines_in_view, 300);
  EXPECT_GE(score.lines_found, 0.9 * score.lines_in_view);
  ASSERT_GE(score.posts_in_view, 3);
  EXPECT_GE(score.posts_found, 0.6 * score.posts_in_view) << score.posts_in_view;
  EXPECT_LE(score.false_posts, 0.1 * score.posts);
  ASSERT_GE(score.robots_in_view, 4);
  EXPECT_GE(score.robots_found, 0.6 * score.robots_in_view) << score.robots_in_view;
}

INSTANTIATE_TEST_SUITE_P(Sizes, SimulatedImages, testing::Values(Look{640, 20}, Look{320, 40}, Look{160, 60}));

}  // namespace
}  // namespace reorient
