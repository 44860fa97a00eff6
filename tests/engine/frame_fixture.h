// SPDX-License-Identifier: MIT
// A frame loop with one behavior; the test sets the inputs of each frame.
#pragma once

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "engine/frame.h"

namespace reorient {

inline constexpr const char* kIdle = R"(behavior "tested" {})";

/// A behavior that does `action` after half a second.
inline std::string then(const std::string& action) {
  return R"(behavior "tested" { initial = "waiting",
    state "waiting" { { "acting", after = 0.5, because = "it is time" } },
    state "acting" { enter = function() )" +
         action + R"( end } })";
}

/// `tolerance`: m and rad.
inline void expect_near(const Pose2& a, const Pose2& b, double tolerance = 0.1) {
  EXPECT_LT((a.position - b.position).norm(), tolerance) << a.position.transpose() << " and " << b.position.transpose();
  EXPECT_LT(std::abs(angle_difference(a.rotation, b.rotation)), tolerance);
}

/// An image with a different color at each pixel.
inline Image colorful_image(int width, int height) {
  Image image(width, height);
  for (int y = 0; y < height; ++y) {
    std::uint8_t* const row = image.row(y);
    for (int x = 0; x < 2 * width; ++x) row[x] = static_cast<std::uint8_t>(x % 2 == 0 ? 40 + x / 2 : 128 + y / 4);
  }
  return image;
}

/// A robot that stands, and the inputs of its next frame.
class HandFedLoop {
 public:
  static constexpr double kStep = 1.0 / 30.0;

  explicit HandFedLoop(const std::string& behavior, FrameSetup setup = {}) : image(colorful_image(160, 120)) {
    setup.scripts.apply({"behaviors/tested.lua", ScriptText{behavior, ""}});
    setup.behaviors.emplace_back("tested");
    engine.emplace(std::move(setup));
    CameraFrame& upper = inputs.observation.upper.emplace();
    upper.image = image.view();
    upper.camera = CameraModel().scaled_to(image.width(), image.height());
    upper.robot_from_camera = robot_from_camera(RobotDimensions(), {}, {}, RobotDimensions().torso_height);
  }

  /// Runs this many frames; external inputs and changes are for the first of them.
  const FrameRecord& step(int frames = 1) {
    for (int i = 0; i < frames; ++i) {
      Observation& observation = inputs.observation;
      observation.upper->time = observation.time;
      observation.upper->odometry = observation.odometry;
      observation.body.time = observation.time;
      engine->step(inputs, wanted);
      observation.time += kStep;
      inputs.parameter_changes.clear();
      inputs.script_edits.clear();
      inputs.external = {};
    }
    return engine->record();
  }
  const FrameRecord& record() const { return engine->record(); }
  const World& world() const { return record().world; }
  void set_pose(const Pose2& pose) { inputs.external.initial_pose = InitialPose{pose}; }

  /// The operator lifts the robot; the engine detects it within ten frames.
  void lift() {
    inputs.observation.body.foot_load = 0.0;
    inputs.observation.body.acceleration.z() += 5.0;
    step(10);
    inputs.observation.body.acceleration.z() -= 5.0;
  }
  void put_down() {
    inputs.observation.body.foot_load = BodySample().foot_load;
    step(10);
  }

  /// Steps until a reorientation was granted.
  const FrameRecord& reoriented() {
    for (int i = 0; i < 100 && !record().reorientation; ++i) step();
    EXPECT_TRUE(record().reorientation);
    return record();
  }

  Image image;
  FrameInputs inputs;
  Topics wanted;
  std::optional<FrameLoop> engine;
};

}  // namespace reorient
