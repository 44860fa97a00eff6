// What the scripts said in one frame.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/script/sandbox/sandbox.h"
#include "engine/world/command.h"
#include "geometry/pose2.h"
#include "robots/robot.h"

namespace reorient {

struct TransitionRecord {
  double time = 0.0;
  std::string machine;
  std::string from;  ///< path; empty at the start
  std::string to;
  std::string reason;   ///< the transition's `because`
  int transition = -1;  ///< of the machine's definition; -1: the start, or after a reload
};

struct LogRecord {
  double time = 0.0;
  std::string issuer;
  std::string state;
  std::string text;
};

/// A run-time error, and what the host did about it.
struct FaultRecord {
  enum class Consequence { none, rolled_back, stopped };

  double time = 0.0;
  std::string script;  ///< file, from the scripts' root
  ScriptFault fault;
  Consequence consequence = Consequence::none;
};

/// What a scenario wants done from outside: to robots/experimenter.h, and telling the robot where it stands.
struct ExperimenterAction {
  enum class Kind { pick_up, put_down, push_over, penalize, set_exposure_compensation, set_initial_pose };

  Kind kind = Kind::pick_up;
  Pose2 pose;              ///< of put_down, set_initial_pose
  double stops = 0.0;      ///< of set_exposure_compensation
  bool penalized = false;  ///< of penalize
};

struct ScenarioVerdict {
  bool succeeded = false;
  std::string text;
  double time = 0.0;
};

struct ScriptOutput {
  std::vector<CommandRequest> commands;  ///< reorientations, issued in this frame
  std::vector<Lease> leases;             ///< all that are held now
  Request request;                       ///< to the robot
  std::vector<TransitionRecord> transitions;
  std::vector<LogRecord> logs;
  std::vector<FaultRecord> faults;
  std::vector<ExperimenterAction> actions;
  std::optional<ScenarioVerdict> verdict;  ///< stays once it was given
};

}  // namespace reorient
