// SPDX-License-Identifier: MIT
#include "program/run/simulation.h"

#include <algorithm>
#include <set>
#include <stdexcept>

#include "engine/parameters/nearest_name.h"
#include "program/former_names.h"
#include "program/model/model_file.h"
#include "program/parameter_modules.h"
#include "program/robots.h"
#include "program/run/missing_interface.h"
#include "program/script_names.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"
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

namespace {

/// The source of the setting `what`, for a message: an option, or the line of an experiment.
std::string said(const SimulationOptions& options, const std::string& what) {
  const auto place = options.said_at.find(what);
  return place == options.said_at.end() ? "--" + what : place->second + ": " + what;
}

/// The result of `find`; its exceptions begin with the line of the experiment that sets `what`, if one does.
std::string with_its_line(const SimulationOptions& options, const std::string& what,
                          const std::function<std::string()>& find) {
  const auto place = options.said_at.find(what);
  if (place == options.said_at.end()) return find();
  try {
    return find();
  } catch (const std::runtime_error& error) {
    throw std::runtime_error(place->second + ": " + error.what());
  }
}

/// The files of the behaviors to load. Throws if a behavior would be loaded twice, or if --without names one that the
/// scenario does not have.
std::vector<std::string> chosen_behaviors(const SimulationOptions& options, const ScriptTexts& texts,
                                          const std::vector<std::string>& wanted) {
  std::vector<std::string> rest;
  rest.reserve(wanted.size());
  for (const std::string& name : wanted) rest.push_back(script_file("behaviors", name));
  for (const std::string& name : options.without) {
    const auto left_out =
        std::find(rest.begin(), rest.end(), script_file("behaviors", script_named(options.scripts, name)));
    if (left_out == rest.end())
      throw std::runtime_error(
          said(options, "without " + name) + ": unknown behavior of scenario " + options.scenario +
          (name.find(',') == std::string::npos ? did_you_mean(name, wanted) : " (repeat --without for each behavior)"));
    rest.erase(left_out);
  }
  std::vector<std::string> chosen;
  for (const std::string& name : options.with) {
    const std::string file =
        with_its_line(options, "with " + name, [&] { return behavior_file(options.scripts, texts, name); });
    for (const std::vector<std::string>& loaded : {rest, chosen}) {
      if (std::find(loaded.begin(), loaded.end(), file) != loaded.end())
        throw std::runtime_error(said(options, "with " + name) +
                                 ": expected a behavior that is not loaded yet, found one of scenario " +
                                 options.scenario + " or of another --with");
    }
    chosen.push_back(file);
  }
  chosen.insert(chosen.end(), rest.begin(), rest.end());
  return chosen;
}

std::set<std::string> loaded_modules(const SimulationOptions& options, const std::vector<std::string>& behaviors) {
  std::set<std::string> modules{module_of_script(options.scenario)};
  for (const std::string& behavior : behaviors) modules.insert(module_of_script(behavior));
  return modules;
}

}  // namespace

std::optional<SavedModel> model_to_begin_with(const SimulationOptions& options) {
  if (options.model.empty()) return std::nullopt;
  const std::string name = "--model " + options.model.string() + ": ";
  if (!options.room_awareness)
    throw std::runtime_error(name + "expected room awareness, found --no-room-awareness; leave out one of them");
  std::error_code error;
  if (std::filesystem::status(options.model, error).type() == std::filesystem::file_type::not_found)
    return std::nullopt;
  try {
    SavedModel model = read_model_file(options.model);
    if (options.sides_changed) model.rotate_by_180_degrees();
    return model;
  } catch (const std::runtime_error& reason) {
    throw std::runtime_error(name + reason.what() + "; it was not changed; name a new file or a valid copy");
  }
}

LoadedFiles Simulation::check(const SimulationOptions& options,
                              const std::function<void(const ScenarioHost& scenario)>& more) {
  const Simulation simulation(options, nullptr, false);
  if (more) more(*simulation.scenario_);
  LoadedFiles loaded{simulation.venue_, {}, {}, {}, {}};
  const ScriptTexts texts = read_scripts(options.scripts);
  for (const std::string& file : with_required(texts, simulation.files_))
    loaded.scripts[file] = content_hash(texts.find(file)->text);
  for (const Parameter& parameter : simulation.parameters()) loaded.parameters.insert(parameter.name);
  for (const std::vector<const MachineDefinition*>& machines :
       {simulation.engine_->machines(), simulation.scenario_->machines()}) {
    for (const MachineDefinition* const machine : machines) {
      for (const StateDefinition& state : machine->states) {
        if (!state.path.empty()) loaded.states.insert(machine->name + "/" + state.path);
      }
    }
  }
  for (const DeclaredAction& action : simulation.engine_->application().actions) loaded.actions.insert(action.name);
  return loaded;
}

Simulation::Simulation(const SimulationOptions& options, RoomCache* rooms, bool makes_robot)
    : model_(options.learned ? options.learned : model_to_begin_with(options)),
      longest_(options.seconds.value_or(kUsualSeconds)) {
  const ScriptTexts scripts = read_scripts(options.scripts);
  const std::vector<ParameterChange> overrides = with_present_names(overrides_of(options.parameters), scripts);
  const std::string scenario =
      with_its_line(options, "scenario", [&] { return scenario_file(options.scripts, scripts, options.scenario); });
  scenario_ = std::make_unique<ScenarioHost>(scripts, scenario, overrides, behaviors_, options.seed);
  const RobotBody body = load_body(body_file(options.body));
  venue_ = venue_of(options, scenario_->setting(), body);
  FrameSetup setup = engine_setup(options, scripts, overrides);
  field_ = setup.field = load_field(venue_.field);
  setup.behaviors = chosen_behaviors(options, scripts, scenario_->wanted_behaviors());
  setup.model = model_;
  setup.application = interface_named(options.interface.empty() ? std::filesystem::path(interface_named_by_script(
                                                                      options.scripts, scenario_->setting().interface))
                                                                : options.interface);
  ParameterModules modules{{}, loaded_modules(options, setup.behaviors), all_modules(scripts)};
  RobotOptions robot{
      body,      setup.field, venue_.room, venue_.hall_seed, options.seed, options.width, options.cameras == "both",
      overrides, rooms,       {}};
  // The scenario plays the application of an interface that it names.
  if (!options.interface.empty()) robot.application = setup.application;
  robot_parameters_ = robot_parameters(options.robot, robot);
  if (makes_robot) robot_ = make_robot(options.robot, robot);
  setup.body = makes_robot ? robot_.body : body;
  try {
    engine_ = std::make_unique<FrameLoop>(std::move(setup));
  } catch (const UnfitModel& reason) {
    throw std::runtime_error("--model " + options.model.string() + ": " + reason.what() +
                             "; set the same values with --set, or name another file with --model");
  }
  modules.parameters = parameters();
  kept_parameters_ = kept_for_others(overrides, modules);
  files_ = files_of(*engine_);
  files_.insert(scenario);
  warn_of_former_fields(scripts, files_);
  warn_of_missing_values(options.scripts, scripts, files_, engine_->application());
}

RunParts Simulation::parts() {
  RunParts parts{robot_, *engine_, scenario_.get(), &behaviors_, {}, {}, {}, longest_, false};
  return parts;
}

std::vector<ParameterChange> Simulation::kept_parameters() const {
  const std::vector<Parameter> declared = parameters();
  std::vector<ParameterChange> kept = kept_parameters_;
  std::erase_if(kept, [&](const ParameterChange& change) {
    return std::any_of(declared.begin(), declared.end(), [&](const auto& one) { return one.name == change.name; });
  });
  return kept;
}

std::vector<Parameter> Simulation::parameters() const {
  return merged({engine_->parameters(), scenario_->parameters().list(), robot_parameters_});
}

}  // namespace reorient
