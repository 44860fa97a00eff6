// SPDX-License-Identifier: MIT
#include "robots/simulator/simulator.h"

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/robots/simulator/mean_luma.h"
#include "tests/robots/simulator/shared_hall.h"

namespace reorient {
namespace {

const Pose2 kBesideTheField(-3.2, -3.5, kPi / 2.0);

SimulatorParameters small() {
  SimulatorParameters parameters;
  parameters.width = 160;
  return parameters;
}

Answer walking_and_looking(int frame) {
  Answer answer;
  answer.request.head = HeadRequest{{1.5 * std::sin(0.05 * frame), 0.1}, 2.0};
  answer.request.walk = {0.2, 0.0, 0.1};
  return answer;
}

std::vector<std::uint8_t> bytes_of(const ImageView& image) {
  return {image.data, image.data + static_cast<std::ptrdiff_t>(image.stride) * image.height};
}

TEST(Simulator, RepeatsARunOfOneSeedByteForByte) {
  Simulator one(small(), RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 5);
  Simulator two(small(), RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 5);
  Observation a;
  Observation b;
  for (int frame = 0; frame < 60; ++frame) {
    one.answer(walking_and_looking(frame));
    two.answer(walking_and_looking(frame));
    if (frame == 20) one.push_over(), two.push_over();
    ASSERT_TRUE(one.observe(a) && two.observe(b));
    ASSERT_EQ(bytes_of(a.upper->image), bytes_of(b.upper->image)) << "frame " << frame;
    ASSERT_EQ(a.odometry.position, b.odometry.position);
    ASSERT_EQ(a.body.head.yaw, b.body.head.yaw);
    ASSERT_EQ(a.body.torso.roll, b.body.torso.roll);
    ASSERT_EQ(a.body.foot_load, b.body.foot_load);
  }
}

TEST(Simulator, ShowsADifferentSceneForEachSeed) {
  Simulator one(small(), RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 5);
  Simulator two(small(), RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 6);
  Observation a;
  Observation b;
  one.observe(a);
  two.observe(b);
  EXPECT_NE(bytes_of(a.upper->image), bytes_of(b.upper->image));
}

TEST(Simulator, WithARoomSmallerThanItsCarpetIsRefused) {
  RoomShape box;
  box.length = 10.0;
  RoomShape round;
  round.form = RoomForm::cylinder;
  round.length = 12.0;  // the carpet's corners would lie outside
  for (const RoomShape& shape : {box, round}) {
    Room room = shared_hall();
    room.shape = shape;
    try {
      Simulator simulator(small(), RobotBody(), FieldDimensions{}, room, kBesideTheField, 1);
      FAIL() << shape.length;
    } catch (const std::runtime_error& error) {
      EXPECT_NE(std::string(error.what()).find("room: expected space for a carpet of 10.4 x 7.4 m, found a "),
                std::string::npos)
          << error.what();
    }
  }
}

TEST(Simulator, UsesTheCameraTheSensorsAndTheLimitsOfTheBody) {
  RobotBody body;
  body.upper_camera.width = 544;
  body.upper_camera.height = 448;
  body.upper_camera.field_of_view_horizontal = from_degrees(105.0);
  body.upper_camera.field_of_view_vertical = from_degrees(94.0);
  body.upper_camera.k1 = 0.0;
  body.upper_camera.rate = 20.0;
  body.lower_camera.reset();
  body.standing_load.reset();
  body.neck = {1.0, {{0.0, -0.3, 0.8}}};
  body.dimensions.torso_height = 0.6;
  SimulatorParameters parameters = simulator_parameters_of(body);
  parameters.width = 320;
  Simulator simulator(parameters, body, FieldDimensions{}, shared_hall(), kBesideTheField, 1);
  Observation observation;
  Answer answer;
  answer.request.head = HeadRequest{{2.0, 1.5}, 10.0};
  for (int frame = 0; frame < 40; ++frame) {
    simulator.observe(observation);
    simulator.answer(answer);
  }
  EXPECT_NEAR(observation.time, 39 / 20.0, 1e-9);
  EXPECT_EQ(observation.upper->image.width, 320);
  EXPECT_EQ(observation.upper->image.height, 264);
  EXPECT_FALSE(observation.lower);
  EXPECT_NEAR(observation.body.head.yaw, 1.0, 0.02);
  EXPECT_NEAR(observation.body.head.pitch, 0.8, 0.02);
  EXPECT_EQ(observation.body.foot_load, 0.0);
  EXPECT_GT(observation.upper->robot_from_camera.translation().z(), 0.8);
  EXPECT_NEAR(observation.upper->camera.ray({159.5, 0.0}).z(), std::tan(from_degrees(47.0)), 0.02);

  parameters.cameras = Cameras::both;
  EXPECT_THROW(Simulator(parameters, body, FieldDimensions{}, shared_hall(), kBesideTheField, 1), std::runtime_error);
}

TEST(Simulator, AdvancesByOneFramePerObservation) {
  Simulator simulator(small(), RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 1);
  Observation observation;
  for (int frame = 0; frame < 31; ++frame) simulator.observe(observation);
  EXPECT_NEAR(observation.time, 1.0, 1e-9);
}

TEST(Simulator, HasTheSameFieldOfViewAtEachResolution) {
  for (const int width : {640, 320, 160}) {
    SimulatorParameters parameters;
    parameters.width = width;
    Simulator simulator(parameters, RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 1);
    Observation observation;
    simulator.observe(observation);
    EXPECT_EQ(observation.upper->image.width, width);
    EXPECT_EQ(observation.upper->image.height, width * 3 / 4);
    EXPECT_EQ(observation.upper->camera.width, width);
    EXPECT_NEAR(observation.upper->camera.project({1.0, 0.3, 0.2})->x() / width, 0.2158, 2e-3);
  }
}

TEST(Simulator, LabelsTheGoalPostWhereTheObservationProjectsIt) {
  SimulatorParameters parameters = small();
  parameters.labels = true;
  parameters.tilt_error = 0.0;
  parameters.other_robots = 0;
  parameters.body.head_noise = parameters.body.attitude_noise = parameters.body.attitude_bias = 0.0;
  Simulator simulator(parameters, RobotBody(), FieldDimensions{}, shared_hall(), Pose2(2.0, 0.0, 0.0), 1);
  Observation observation;
  simulator.observe(observation);
  const Isometry3 field_from_camera = to_isometry(simulator.ground_truth().pose) * observation.upper->robot_from_camera;
  const auto pixel = observation.upper->camera.project(field_from_camera.inverse() * Eigen::Vector3d(4.5, 0.8, 0.4));
  ASSERT_TRUE(pixel && observation.upper->camera.contains(*pixel));
  const auto index = static_cast<std::size_t>(std::lround(pixel->y()) * 160 + std::lround(pixel->x()));
  EXPECT_EQ(simulator.labels()[index], Label::goal);
  EXPECT_NEAR(simulator.depth()[index], 2.4, 0.05);
}

TEST(Simulator, GivesLabelsAndDepthOnlyOnRequest) {
  Simulator simulator(small(), RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 1);
  Observation observation;
  simulator.observe(observation);
  EXPECT_TRUE(simulator.labels().empty());
  EXPECT_TRUE(simulator.depth().empty());
}

TEST(Simulator, HasTheSameLabelsButOtherColorsAfterARotationBy180Degrees) {
  SimulatorParameters parameters = small();
  parameters.labels = true;
  parameters.other_robots = 0;
  parameters.spectators = 0;
  parameters.ball = false;
  parameters.tilt_error = 0.0;
  Simulator here(parameters, RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 1);
  Simulator there(parameters, RobotBody(), FieldDimensions{}, shared_hall(), reflect(kBesideTheField), 1);
  Observation a;
  Observation b;
  here.observe(a);
  there.observe(b);
  int different_labels = 0;
  double difference = 0.0;
  for (std::size_t i = 0; i < here.labels().size(); ++i)
    different_labels += here.labels()[i] != there.labels()[i] ? 1 : 0;
  for (int y = 0; y < 50; ++y) {
    for (int x = 0; x < 160; ++x)
      difference += std::abs(a.upper->image.luma(x, y) - b.upper->image.luma(x, y)) / (50.0 * 160.0);
  }
  EXPECT_LT(different_labels, 60) << "of 19200: rounding on edges";
  EXPECT_GT(difference, 8.0);
}

TEST(Simulator, SeesGroundOrCeilingAfterAFall) {
  SimulatorParameters parameters = small();
  parameters.labels = true;
  std::set<Label> seen;
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Simulator simulator(parameters, RobotBody(), FieldDimensions{}, shared_hall(), Pose2(-1.5, 1.5, 0.0), seed);
    Observation observation;
    simulator.observe(observation);
    simulator.push_over();
    for (int i = 0; i < 40; ++i) simulator.observe(observation);
    EXPECT_TRUE(simulator.ground_truth().fallen);
    EXPECT_GT(std::hypot(observation.body.torso.roll, observation.body.torso.pitch), 1.3);
    seen.insert(simulator.labels()[60 * 160 + 80]);
  }
  EXPECT_TRUE(seen.count(Label::carpet) + seen.count(Label::ceiling) > 0);
}

TEST(Simulator, LetsTheOperatorMoveTheRobot) {
  Simulator simulator(small(), RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 1);
  Observation observation;
  simulator.observe(observation);
  const Pose2 odometry = observation.odometry;
  simulator.pick_up();
  for (int i = 0; i < 30; ++i) simulator.observe(observation);
  EXPECT_LT(observation.body.foot_load, 0.6);
  simulator.put_down(reflect(kBesideTheField));
  for (int i = 0; i < 45; ++i) simulator.observe(observation);  // the operator lowers it
  EXPECT_GT(observation.body.foot_load, 4.0);
  EXPECT_EQ(observation.odometry.position, odometry.position);
  EXPECT_LT((simulator.ground_truth().pose.position + kBesideTheField.position).norm(), 1e-9);
}

TEST(Simulator, GivesOnRequestTheLowerCameraShortlyBeforeTheUpperOne) {
  SimulatorParameters parameters = small();
  Simulator one(parameters, RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 1);
  parameters.cameras = Cameras::both;
  Simulator both(parameters, RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 1);
  Observation upper_alone, observation;
  for (int i = 0; i < 5; ++i) {
    one.observe(upper_alone);
    both.observe(observation);
    EXPECT_FALSE(upper_alone.lower);
    ASSERT_TRUE(observation.lower);
    EXPECT_EQ(observation.time, observation.upper->time);
    EXPECT_NEAR(observation.time - observation.lower->time, 1.0 / 90.0, 1e-9);
    const ImageView& a = upper_alone.upper->image;
    const ImageView& b = observation.upper->image;
    for (int row = 0; row < a.height; ++row)
      ASSERT_TRUE(std::equal(a.row(row), a.row(row) + 2 * a.width, b.row(row))) << "the upper camera sees the same";
  }
  // It points at the ground in front of the feet.
  const Eigen::Vector3d axis = observation.lower->robot_from_camera.linear().col(0);
  EXPECT_NEAR(std::asin(-axis.z()), from_degrees(39.7), from_degrees(2.0));
}

TEST(Simulator, DarkensThePictureIfTheOperatorReducesTheLight) {
  Simulator simulator(small(), RobotBody(), FieldDimensions{}, shared_hall(), kBesideTheField, 1);
  Observation observation;
  double before = 1e9;
  for (const double stops : {1.0, 0.0, -1.0, -2.0}) {
    simulator.set_exposure_compensation(stops);
    simulator.observe(observation);
    EXPECT_LT(mean_luma(observation.upper->image), before - 5.0);
    before = mean_luma(observation.upper->image);
  }
}

TEST(Simulator, StopsTheRobotAtAGoalPost) {
  SimulatorParameters parameters = small();
  parameters.other_robots = 0;
  Simulator simulator(parameters, RobotBody(), FieldDimensions{}, shared_hall(), Pose2(4.0, 0.8, 0.0), 1);
  Observation observation;
  Answer answer;
  answer.request.walk.forward = 0.25;
  simulator.answer(answer);
  for (int i = 0; i < 150; ++i) simulator.observe(observation);
  EXPECT_LT(simulator.ground_truth().pose.position.x(), 4.5 - 0.05 - Body::kRadius + 1e-6);
  EXPECT_GT(observation.odometry.position.x(), 0.5) << "its feet continue to walk";
}

TEST(Simulator, KeepsRobotsApart) {
  SimulatorParameters parameters = small();
  parameters.other_robots = 8;
  Simulator simulator(parameters, RobotBody(), FieldDimensions{}, shared_hall(), Pose2(0.0, 0.0, 0.0), 3);
  Observation observation;
  for (int i = 0; i < 600; ++i) {
    Answer answer;
    answer.request.walk = {0.25, 0.0, 0.6 * std::sin(0.02 * i)};
    simulator.answer(answer);
    simulator.observe(observation);
    const Eigen::Vector2d robot = simulator.ground_truth().pose.position;
    for (const Player& player : simulator.other_robots()) {
      ASSERT_GT((player.pose.position - robot).norm(), Body::kRadius + Players::kRadius - 0.02) << "frame " << i;
    }
  }
}

/// A stand-in for the engine's list of parameters.
struct Visitor {
  std::set<std::string> names;
  void operator()(const char* name, double& value, double least, double most, const char*, const char* text) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(least <= value && value <= most) << name;
    EXPECT_NE(std::string(text), "");
  }
  void operator()(const char* name, int& value, int least, int most, const char*, const char*) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_TRUE(least <= value && value <= most) << name;
  }
  void operator()(const char* name, bool&, const char*) { EXPECT_TRUE(names.insert(name).second) << name; }
  template <typename Choice>
  void operator()(const char* name, Choice& value, std::initializer_list<const char*> choices, const char*) {
    EXPECT_TRUE(names.insert(name).second) << name;
    EXPECT_LT(static_cast<std::size_t>(value), choices.size());
  }
};

TEST(Simulator, DeclaresEveryParameterWithADefaultInsideOfItsRange) {
  SimulatorParameters parameters;
  RoomShape shape;
  Visitor simulator;
  Visitor body;
  Visitor sensor;
  Visitor light;
  Visitor room;
  describe(parameters, simulator);
  describe(parameters.body, body);
  describe(parameters.sensor, sensor);
  describe(parameters.light, light);
  describe(shape, room);
  EXPECT_EQ(simulator.names.size() + body.names.size() + sensor.names.size() + room.names.size(),
            16u + 28u + 16u + 10u);
  EXPECT_EQ(light.names.size(), 13u);
}

}  // namespace
}  // namespace reorient
