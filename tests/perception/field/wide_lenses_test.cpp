// SPDX-License-Identifier: MIT
// Number of line points per meter of visible line for a wide lens, compared with a pinhole of the usual field of view
// on the same body. The camera's pose is the true one, so the test measures the vision and the lens.
#include <cstdio>
#include <filesystem>

#include <gtest/gtest.h>

#include "engine/core_parameters.h"
#include "geometry/random.h"
#include "perception/field/field_features.h"
#include "robots/simulator/simulator.h"
#include "tests/paths.h"
#include "tests/perception/field/flat_field.h"
#include "tests/perception/field/percept_in.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"

namespace reorient {
namespace {

constexpr double kStep = 0.02;  // m, along a line

struct LineScore {
  double meters = 0.0;  // of lines in view: in the image, in range and not hidden
  int points = 0, misplaced = 0;

  double points_per_meter() const { return (points - misplaced) / meters; }
};

/// All positions on lines, kStep apart.
std::vector<Eigen::Vector2d> places_on_lines(const FieldDimensions& field) {
  std::vector<Eigen::Vector2d> places;
  for (const FieldLine& line : field_lines(field)) {
    const int steps = static_cast<int>((line.to - line.from).norm() / kStep);
    for (int i = 0; i < steps; ++i) places.emplace_back(line.from + (line.to - line.from) * ((i + 0.5) / steps));
  }
  const int steps = static_cast<int>(2.0 * kPi * field.center_circle_radius / kStep);
  for (int i = 0; i < steps; ++i)
    places.emplace_back(field.center_circle_radius * unit_vector(2.0 * kPi * (i + 0.5) / steps));
  return places;
}

LineScore look_around(const RobotBody& body, const FieldDimensions& field, int width, int views) {
  SimulatorParameters parameters = simulator_parameters_of(body);
  parameters.width = width;
  parameters.labels = true;
  parameters.tilt_error = 0.0;
  Simulator simulator(parameters, body, field, procedural_hall(2, {}), {-2.0, 0.0, 0.0}, 11);
  const FieldFeatureParameters vision = core_parameters_for(field, body).field_features;
  FieldFeatures features(vision, field);
  const std::vector<Eigen::Vector2d> places = places_on_lines(field);
  Random random(5);
  LineScore score;
  for (int i = 0; i < views; ++i) {
    simulator.put_down({random.uniform(-0.45, 0.45) * field.length, random.uniform(-0.45, 0.45) * field.width,
                        random.uniform(-kPi, kPi)});
    Answer answer;
    answer.request.head = HeadRequest{{random.uniform(-0.8, 0.8), random.uniform(-0.05, 0.3)}, 10.0};
    simulator.answer(answer);
    Observation observation;
    for (int k = 0; k < 5; ++k) simulator.observe(observation);
    const CameraFrame& frame = observation.upper.value();
    const Pose2 truth = simulator.ground_truth().pose;
    const Isometry3 robot_from_camera = to_isometry(truth).inverse() * simulator.field_from_camera();
    const Isometry3 camera_from_field = simulator.field_from_camera().inverse();
    const FieldPercept percept = percept_in(features, frame.image, frame.camera, robot_from_camera);
    for (const LinePoint& point : percept.line_points) {
      const NearestLine line = nearest_line(field, truth * point.position);
      ++score.points;
      score.misplaced += line.distance > 0.05 + 0.03 * point.position.norm() ? 1 : 0;
    }
    const Eigen::Vector2d eye = simulator.field_from_camera().translation().head<2>();
    for (const Eigen::Vector2d& place : places) {
      if ((place - eye).norm() > vision.line_range) continue;
      const auto pixel = frame.camera.project(camera_from_field * Eigen::Vector3d(place.x(), place.y(), 0.0));
      if (!pixel || pixel->x() < 0.0 || pixel->y() < 0.0 || pixel->x() > frame.image.width - 1.0 ||
          pixel->y() > frame.image.height - 1.0)
        continue;
      const auto index = std::lround(pixel->y()) * frame.image.width + std::lround(pixel->x());
      const Label label = simulator.labels()[static_cast<std::size_t>(index)];
      if (label == Label::line || label == Label::carpet) score.meters += kStep;
    }
  }
  return score;
}

RobotBody body_named(const std::string& file) { return load_body(std::filesystem::path(kSourceFolder) / file); }

/// The same body with a pinhole camera that has the NAO's fields of view.
RobotBody with_usual_pinhole(RobotBody body) {
  body.upper_camera = {};
  body.upper_camera.k1 = 0.0;
  return body;
}

class WideLens : public testing::TestWithParam<const char*> {};

TEST_P(WideLens, GivesFourFifthsOfThePinholesLinePointsPerMeter) {
  const RobotBody body = body_named(GetParam());
  const FieldDimensions field =
      load_field(std::filesystem::path(kSourceFolder) / "assets/fields" / (body.field + ".toml"));
  constexpr int kViews = 40;
  const LineScore pinhole = look_around(with_usual_pinhole(body), field, body.upper_camera.width, kViews);
  const LineScore wide = look_around(body, field, body.upper_camera.width, kViews);
  std::printf("%s: %.1f points per meter (%d points, %d misplaced, %.0f m); pinhole: %.1f (%d, %d, %.0f m)\n",
              GetParam(), wide.points_per_meter(), wide.points, wide.misplaced, wide.meters, pinhole.points_per_meter(),
              pinhole.points, pinhole.misplaced, pinhole.meters);
  EXPECT_GE(wide.points_per_meter(), 0.8 * pinhole.points_per_meter());
  EXPECT_LE(wide.misplaced, 0.03 * wide.points);
}

INSTANTIATE_TEST_SUITE_P(Bodies, WideLens,
                         testing::Values("assets/robots/booster-k1.toml", "tests/robots/bodies/fisheye-160.toml"));

}  // namespace
}  // namespace reorient
