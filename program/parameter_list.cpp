// SPDX-License-Identifier: MIT
#include "program/parameter_list.h"

#include <string>
#include <utility>

#include "engine/frame.h"
#include "program/experiment/compass_parameters.h"
#include "program/robots.h"
#include "program/run/simulation.h"
#include "program/run/venue.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"
#include "workbench/files/interface_file.h"
#include "workbench/files/parameter_file.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

std::vector<Parameter> all_parameters(const ScriptTexts& texts, const std::filesystem::path& body,
                                      const std::filesystem::path& field,
                                      const std::vector<ParameterChange>& overrides) {
  FrameSetup setup;
  setup.body = load_body(body_file(body));
  setup.field = load_field(field_file(field, setup.body));
  setup.scripts = texts;
  setup.behaviors = texts.in_folder("behaviors");
  setup.application = merged(known_interfaces(texts.root()));
  setup.parameters = overrides;
  std::vector<std::vector<Parameter>> lists{FrameLoop(setup).parameters()};
  const RecordedBehaviors no_behaviors;
  for (const std::string& file : texts.in_folder("scenarios"))
    lists.push_back(ScenarioHost(texts, file, overrides, no_behaviors).parameters().list());
  RobotOptions robot;
  robot.body = setup.body;
  robot.field = setup.field;
  robot.parameters = overrides;
  for (const std::string& name : robot_names()) lists.push_back(robot_parameters(name, robot));
  lists.push_back(peer_parameters(overrides));
  return merged(std::move(lists));
}

}  // namespace reorient
