#include "program/experiment/trial_runner.h"

#include "program/run/simulation.h"
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
  options.room = condition.room;
  options.hall_seed = condition.hall_seed;
  options.seed = seed;
  options.width = condition.width;
  options.cameras = condition.cameras;
  options.room_awareness = condition.room_awareness;
  options.seconds = condition.seconds;
  options.parameters.files.assign(condition.parameter_files.begin(), condition.parameter_files.end());
  options.parameters.changes = condition.parameters;
  return options;
}

TrialResult run_trial(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts,
                      RoomCache& rooms) {
  Simulation simulation(options_of(condition, seed, scripts), &rooms);
  TrialObserver observer(condition.measurement);
  RunParts parts = simulation.parts();
  parts.observers = {&observer};
  parts.stop = [&observer] { return observer.is_over(); };
  RunLoop(std::move(parts)).run();
  TrialResult result = observer.result();
  result.seed = seed;
  return result;
}

}  // namespace reorient
