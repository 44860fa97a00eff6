// SPDX-License-Identifier: MIT
#include "program/experiment/trial_runner.h"

#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "program/experiment/compass_parameters.h"
#include "program/model/known_room.h"
#include "program/run/simulation.h"
#include "workbench/experiments/trial/compass_observer.h"
#include "workbench/experiments/trial/pose_error_observer.h"
#include "workbench/experiments/trial/trial_observer.h"
#include "workbench/run/run_loop.h"

namespace reorient {

SimulationOptions options_of(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts) {
  SimulationOptions options;
  options.scenario = condition.scenario;
  options.with = condition.with;
  options.without = condition.without;
  options.scripts = scripts;
  options.field = condition.field;
  options.interface = condition.interface;
  options.body = condition.body;
  options.room = condition.room;
  options.hall_seed = condition.hall_seed;
  options.seed = seed;
  options.width = condition.width;
  options.cameras = condition.cameras;
  options.room_awareness = condition.room_awareness;
  options.seconds = condition.seconds;
  options.parameters.files.assign(condition.parameter_files.begin(), condition.parameter_files.end());
  options.said_at = condition.said_at;
  options.parameters.changes = condition.compasses ? without_peers(condition.parameters) : condition.parameters;
  return options;
}

namespace {

/// The room on another day: the same parameters, but without a disturbance, and with another seed, so with other
/// people. Nothing if it was not learned before.
std::optional<SimulationOptions> options_of_another_day(const Condition& condition, std::uint64_t seed,
                                                        const std::filesystem::path& scripts) {
  constexpr std::uint64_t kOtherSeeds = 0x0d1f'0000'0000;
  if (condition.learned_before <= 0.0) return std::nullopt;
  Condition before = condition;
  before.scenario = "trial";
  before.seconds = condition.learned_before;
  const std::string learn = to_text(ParameterValue(condition.learned_before));
  for (const auto& [name, value] : {std::pair{"trial.learn", learn}, {"trial.event", std::string("none")}})
    before.parameters.push_back({name, value, ParameterOrigin::file, "learned_before"});
  return options_of(before, seed ^ kOtherSeeds, scripts);
}

std::optional<SavedModel> model_of_another_day(const Condition& condition, std::uint64_t seed,
                                               const std::filesystem::path& scripts, RoomCache& rooms) {
  const std::optional<SimulationOptions> options = options_of_another_day(condition, seed, scripts);
  if (!options) return std::nullopt;
  Simulation simulation(*options, &rooms);
  KnownRoom room;
  RunParts parts = simulation.parts();
  parts.observers = {&room};
  RunLoop(std::move(parts)).run();
  return room.model();
}

/// Requires that the scenario has the state: otherwise all trials would count as failed.
void require_state(const Condition& condition, const ScenarioHost& scenario) {
  const std::string& wanted = condition.measurement.from;
  if (wanted.empty()) return;
  std::vector<std::string> known;
  for (const MachineDefinition* const machine : scenario.machines()) {
    for (const StateDefinition& state : machine->states) {
      if (is_within(state.path, wanted)) return;
      known.push_back(state.path);
    }
  }
  const auto place = condition.said_at.find("measured_from");
  throw std::runtime_error(as_line((place == condition.said_at.end() ? "" : place->second + ": ") + "scenario " +
                                   condition.scenario + ": unknown state '" + wanted + "'" +
                                   did_you_mean(wanted, known)));
}

}  // namespace

LoadedFiles check_trial(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts) {
  if (condition.compasses) static_cast<void>(compass_parameters_of(condition));
  LoadedFiles before;
  if (const auto day = options_of_another_day(condition, seed, scripts)) before = Simulation::check(*day);
  LoadedFiles loaded = Simulation::check(options_of(condition, seed, scripts),
                                         [&](const ScenarioHost& scenario) { require_state(condition, scenario); });
  loaded.scripts.merge(before.scripts);
  loaded.parameters.merge(before.parameters);
  return loaded;
}

SimulationOptions prepared_options_of(const Condition& condition, std::uint64_t seed,
                                      const std::filesystem::path& scripts, RoomCache& rooms) {
  SimulationOptions options = options_of(condition, seed, scripts);
  options.learned = model_of_another_day(condition, seed, scripts, rooms);
  return options;
}

CompassParameters compass_parameters_of(const Condition& condition) {
  ParameterOptions options;
  options.files.assign(condition.parameter_files.begin(), condition.parameter_files.end());
  options.changes = condition.parameters;
  return compass_parameters(overrides_of(options));
}

TrialResult run_trial(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts,
                      RoomCache& rooms) {
  Simulation simulation(prepared_options_of(condition, seed, scripts, rooms), &rooms);
  TrialObserver observer(condition.measurement);
  RunParts parts = simulation.parts();
  parts.observers = {&observer};
  std::optional<CompassObserver> compasses;
  if (condition.compasses) {
    compasses.emplace(compass_parameters_of(condition), observer, seed);
    parts.observers.push_back(&*compasses);
  }
  PoseErrorObserver pose_errors(observer);
  if (condition.pose_errors) parts.observers.push_back(&pose_errors);
  MeasureObserver measures(condition.measures, observer);
  if (!condition.measures.empty()) parts.observers.push_back(&measures);
  parts.stop = [&observer] { return observer.is_over(); };
  RunLoop(std::move(parts)).run();
  TrialResult result = observer.result();
  if (condition.pose_errors) result.pose_errors = pose_errors.errors();
  if (compasses) result.looks = compasses->looks();
  result.measures = measures.values();
  result.seed = seed;
  return result;
}

}  // namespace reorient
