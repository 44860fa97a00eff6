// SPDX-License-Identifier: MIT
// The whole engine with a robot of your own. own_robot SCRIPTS: runs the behaviors of this folder for one minute and
// prints their decisions. After 40 s it sets a wrong pose, on the other half of the field.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <stdexcept>

#include <reorient/engine/frame.h>
#include <reorient/geometry/pinned_math.h>
#include <reorient/robots/robot.h>
#include <reorient/workbench/files/script_files.h>

using namespace reorient;

/// A robot that stands in a hall with a different color in each direction. A real robot waits for its camera here.
class OwnRobot : public Robot {
 public:
  bool observe(Observation& observation) override {
    if (frame_++ == 60 * 30) return false;
    head_ = requested_;  // these motors need no time
    paint();
    observation = Observation();
    observation.time = frame_ / 30.0;
    observation.body.head = head_;
    CameraFrame& upper = observation.upper.emplace();
    upper.time = observation.time;
    upper.image = image_.view();
    upper.camera = camera_;
    upper.robot_from_camera = robot_from_camera(RobotDimensions(), head_, {}, RobotDimensions().torso_height);
    if (frame_ == 1) observation.external.initial_pose = InitialPose{truth_};
    if (frame_ == 40 * 30) observation.external.initial_pose = InitialPose{reflect(truth_)};
    return true;
  }

  void answer(const Answer& answer) override {
    if (!answer.request.head) return;                       // this robot cannot walk
    const double step = answer.request.head->speed / 30.0;  // rad
    requested_.yaw += std::clamp(answer.request.head->angles.yaw - requested_.yaw, -step, step);
    requested_.pitch = answer.request.head->angles.pitch;
  }

 private:
  void paint() {
    for (int x = 0; x < camera_.width; x += 2) {
      const Eigen::Vector3d ray = camera_.ray({x + 0.5, camera_.center.y()});
      const double turns = (truth_.rotation + head_.yaw + pinned::atan2(ray.y(), ray.x())) / (2.0 * kPi);
      const int panel = static_cast<int>(24.0 * (turns - std::floor(turns)));
      const int color[] = {60 + 37 * panel % 120, 100 + 29 * panel % 60, 60 + 37 * panel % 120, 100 + 47 * panel % 60};
      for (int y = 0; y < camera_.height; ++y)
        for (int i = 0; i < 4; ++i) image_.row(y)[2 * x + i] = static_cast<std::uint8_t>(color[i]);
    }
  }

  const Pose2 truth_{-2.0, -1.5, kPi / 2};
  CameraModel camera_ = CameraModel().scaled_to(160, 120);
  Image image_{160, 120};
  HeadAngles head_, requested_;
  int frame_ = 0;
};

int main(int argc, char** argv) try {
  if (argc != 2)
    throw std::runtime_error("expected the folder of the scripts, as in: own_robot PREFIX/share/reorient/scripts");
  ScriptFiles scripts(argv[1]);
  FrameSetup setup;
  setup.scripts = scripts.texts();
  setup.behaviors = {"orientation", "background_training", "head_scan"};
  // At this position a scan with the shipped width sees only one side of the room, so no tiles can be compared with the
  // mirrored tiles.
  setup.parameters = {{"head_scan.width", "1.9", ParameterOrigin::live, "own_robot"}};
  FrameLoop engine(std::move(setup));
  OwnRobot robot;
  FrameInputs inputs;
  while (robot.observe(inputs.observation)) {
    inputs.script_edits = scripts.poll(inputs.observation.time);  // saved scripts are reloaded at once
    const FrameRecord& record = engine.step(inputs);
    robot.answer(record.answer);
    for (const CommandRecord& command : record.commands)
      std::cout << record.world.time << " s: " << to_string(command.request.reorientation) << ", because "
                << record.name(command.request.issuer.reason) << ": " << to_string(command.verdict) << '\n';
  }
  std::cout << "believes that it stands at " << engine.record().world.pose.pose.position.transpose() << '\n';
  return 0;
} catch (const std::exception& error) {
  std::cerr << "own_robot: " << error.what() << '\n';
  return 2;
}
