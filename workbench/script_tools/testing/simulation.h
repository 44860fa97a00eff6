// SPDX-License-Identifier: MIT
// The request of a scripted test for a whole scenario on a robot. The script tools have no robot, so the caller
// provides one.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "workbench/run/observer.h"
#include "workbench/script_tools/testing/coverage.h"

namespace reorient {

struct SimulationRequest {
  std::string scenario;
  std::vector<std::string> with;  ///< behaviors in addition to those of the scenario
  std::uint64_t seed = 1;
  int width = 160;         ///< of the camera image, pixels
  double seconds = 600.0;  ///< longest run, in the robot's time
  // The setting, as in a scenario. Empty: the scenario's.
  std::string room;
  std::optional<std::uint64_t> hall_seed;
  std::string field;
  bool room_awareness = true;
  std::vector<std::pair<std::string, std::string>> parameters;  ///< name, value
};

/// The observations that tests can check, as text.
struct SeenCommand {
  std::string name;  ///< "flip_pose", "pause_training"
  std::string verdict;
  bool is_reorientation = true;
};
struct SeenTransition {
  std::string machine;
  std::string reason;
};
struct SeenMachine {
  std::string name;
  std::string state;
};

/// Observations of some frames: at least the latest ten thousand of each type.
struct SeenFrames {
  std::vector<SeenMachine> machines;  ///< at the end
  std::vector<SeenCommand> commands;
  std::vector<SeenTransition> transitions;
  std::vector<std::string> logs;
  std::vector<std::string> messages;  ///< to the teammates
  std::vector<ScriptFault> faults;
  std::vector<std::string> actions;  ///< of the scenario's operator
  std::optional<ScenarioVerdict> verdict;

  void note(const NameTable& names, std::span<const TransitionRecord> taken, std::span<const LogRecord> logged,
            std::span<const FaultRecord> failed);
  void note_messages(std::span<const std::string> sent);
  void note_commands(std::span<const CommandRecord> given, std::span<const Lease> begun);
  void note_scenario(const ScenarioRecord& scenario);
  void note_machines(const NameTable& names, std::span<const MachineStatus> statuses);
};

/// Collects the observations of a run.
class SeenObserver : public Observer {
 public:
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;
  void finish(const FrameRecord& last, const SceneTruth& scene) override;

  SeenFrames seen;
};

/// Result of a whole run.
/// The interface of an application that a test names. Throws std::runtime_error with one line.
using LoadInterface = std::function<ApplicationInterface(const std::string& name)>;

struct SimulationOutcome {
  bool is_correct = false;  ///< the belief fits the truth at the end
  double seconds = 0.0;     ///< of the robot's time
  SeenFrames seen;
};

/// `stop` is called before each frame. Throws std::runtime_error with one line if the request is impossible.
using Simulate =
    std::function<SimulationOutcome(const SimulationRequest&, CoverageTrace&, const std::function<bool()>& stop)>;

}  // namespace reorient
