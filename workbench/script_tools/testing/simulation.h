// How a scripted test asks for a whole scenario on the simulator. The script engine knows no simulator: who runs the
// tests hands one in.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/script/script_host.h"
#include "engine/script/script_output.h"
#include "engine/world/command.h"
#include "workbench/script_tools/testing/coverage.h"

namespace reorient {

struct SimulationRequest {
  std::string scenario;
  std::vector<std::string> with;  ///< behaviours beside those of the scenario
  std::uint64_t seed = 1;
  int width = 160;         ///< of the camera image, pixels
  double seconds = 600.0;  ///< of the robot's time, at most
  bool room_awareness = true;
  std::vector<std::pair<std::string, std::string>> parameters;  ///< name, value
};

/// What was seen from the beginning to the end.
struct SimulationOutcome {
  std::optional<ScenarioVerdict> verdict;
  bool is_correct = false;              ///< the belief fits the truth at the end
  std::vector<MachineStatus> machines;  ///< at the end
  std::vector<CommandRecord> commands;
  std::vector<TransitionRecord> transitions;
  std::vector<LogRecord> logs;
  std::vector<FaultRecord> faults;
};

/// Throws std::runtime_error with one line on a request that cannot be met.
using Simulate = std::function<SimulationOutcome(const SimulationRequest&, CoverageTrace&)>;

}  // namespace reorient
