#include "program/run/simulation.h"

#include <algorithm>

#include "program/robots.h"
#include "workbench/files/field_file.h"
#include "workbench/files/home.h"
#include "workbench/files/script_files.h"

namespace reorient {

std::vector<Parameter> merged(std::vector<std::vector<Parameter>> lists) {
  std::vector<Parameter> all;
  for (std::vector<Parameter>& list : lists) all.insert(all.end(), list.begin(), list.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name < b.name; });
  all.erase(std::unique(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.name == b.name; }),
            all.end());
  return all;
}

Simulation::Simulation(const SimulationOptions& options) : longest_(options.seconds) {
  const std::vector<ParameterChange> overrides = overrides_of(options.parameters);
  const ScriptTexts scripts = read_scripts(options.scripts);
  scenario_ =
      std::make_unique<ScenarioHost>(scripts, script_named(options.scripts, options.scenario), overrides, behaviors_);
  FrameSetup setup;
  setup.field = load_field(options.field.empty() ? find_home() / "assets" / "fields" / "spl.toml" : options.field);
  setup.seed = options.seed;
  setup.room_awareness = options.room_awareness;
  setup.scripts = scripts;
  for (const std::string& name : options.with) setup.behaviors.push_back(script_named(options.scripts, name));
  for (const std::string& name : scenario_->wanted_behaviors()) setup.behaviors.push_back(name);
  setup.parameters = overrides;
  RobotOptions robot{setup.field, options.room, options.hall, options.seed, options.width, options.cameras == "both",
                     overrides};
  robot_parameters_ = robot_parameters(options.robot, robot);
  engine_ = std::make_unique<FrameLoop>(std::move(setup));
  require_known(overrides, parameters());
  robot_ = make_robot(options.robot, robot);
}

RunParts Simulation::parts() {
  RunParts parts{robot_, *engine_, scenario_.get(), &behaviors_, {}, {}, {}, longest_, false};
  return parts;
}

std::vector<Parameter> Simulation::parameters() const {
  return merged({engine_->parameters(), scenario_->parameters().list(), robot_parameters_});
}

}  // namespace reorient
