// SPDX-License-Identifier: MIT
// Values and actions of your own. application SCRIPTS: declares a ball and a kick, rolls a ball toward a standing robot
// without cameras, and carries out the kicks that the shipped behavior kick_ball requests. Ends after three kicks.
#include <algorithm>
#include <iostream>
#include <stdexcept>

#include <reorient/engine/frame.h>
#include <reorient/workbench/files/interface_file.h>
#include <reorient/workbench/files/script_files.h>

using namespace reorient;

// An interface can also be a file (assets/interfaces/). This one has only what the behavior needs.
constexpr const char* kInterface = R"(
[values.ball.position]
type = "point"
lasts = 3.0
description = "position of the ball relative to the robot"
[values.ball.distance]
type = "number"
default = 20.0
description = "distance of the ball"
[actions.kick]
takes = 4.0
reports = true
description = "kicks the ball"
[actions.kick.arguments.foot]
type = "text"
choices = ["left", "right"]
description = "foot that kicks"
[actions.kick.arguments.direction]
type = "number"
default = 0.0
description = "direction of the ball"
)";
enum Value : std::uint16_t { kDistance, kPosition };  // in the order of the names

int main(int argc, char** argv) try {
  if (argc != 2) throw std::runtime_error("expected the folder of the scripts");
  FrameSetup setup;
  setup.scripts = read_scripts(argv[1]);
  setup.behaviors = {"kick_ball"};
  setup.application = parse_interface(kInterface, "ball");
  FrameLoop engine(std::move(setup));
  FrameInputs inputs;
  double distance = 1.0, kick_ends = 0.0;
  std::uint32_t kick = 0;
  for (int frame = 1, kicks = 0; kicks < 3; ++frame) {
    if (frame > 60 * 30) throw std::runtime_error("expected three kicks in a minute");
    inputs.observation.time = frame / 30.0;
    distance = std::max(0.15, distance - 0.5 / 30.0);
    inputs.external = {};
    inputs.external.values = {{kPosition, 1, {{distance, 0.05}, {}}}, {kDistance, 1, {{distance}, {}}}};
    if (kick != 0 && inputs.observation.time > kick_ends) {
      inputs.external.reports = {{kick, ActionState::done, ""}};
      kick = 0;
      distance = 1.0;
      ++kicks;
    }
    for (const StartedAction& started : engine.step(inputs).answer.actions) {
      std::cout << inputs.observation.time
                << " s: " << to_text(started.arguments, engine.application().actions[started.action].arguments) << '\n';
      kick = started.id;
      kick_ends = inputs.observation.time + 0.5;
    }
  }
  return 0;
} catch (const std::exception& error) {
  std::cerr << "application: " << error.what() << '\n';
  return 2;
}
