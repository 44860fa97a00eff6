// SPDX-License-Identifier: MIT
// A scenario, run between frames: it reads the last frame's record and the true pose of the robot, and its actions
// go to the operator or into the next frame's inputs. Behaviors cannot access it.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/parameters/parameter_registry.h"
#include "engine/record/frame_record.h"
#include "engine/script/script_host.h"
#include "workbench/scenario/scenario_language.h"

namespace reorient {

/// The output of a scenario after one frame: plain data, like a frame's record.
struct ScenarioRecord {
  std::shared_ptr<const NameTable> names = std::make_shared<NameTable>();
  std::vector<MachineStatus> machines;
  std::vector<TransitionRecord> transitions;
  std::vector<OperatorAction> actions;
  std::vector<LogRecord> logs;
  std::vector<FaultRecord> faults;
  std::vector<ReloadRecord> reloads;
  std::optional<ScenarioVerdict> verdict;  ///< does not change after it was given

  const std::string& name(NameId id) const { return (*names)[id]; }

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    NameTable table = *self.names;
    archive(table, self.machines, self.transitions, self.actions, self.logs, self.faults, self.reloads, self.verdict);
    if constexpr (Archive::kReads) self.names = std::make_shared<NameTable>(std::move(table));
  }
};

/// Inputs of a scenario.
struct ScenarioView {
  const World& world;
  const ApplicationRecord& application;
  std::optional<GroundTruth> truth;
  std::optional<BallTruth> ball{};  ///< empty: there is no ball
};

/// The behaviors of a frame's record, for `behaviors.NAME.state`.
class RecordedBehaviors : public MachineDirectory {
 public:
  /// Both must outlive the next read.
  void show(const NameTable& names, const std::vector<MachineStatus>& machines, const std::vector<NameId>& published,
            double time) {
    names_ = &names;
    machines_ = &machines;
    published_ = &published;
    time_ = time;
  }
  bool look_up(std::string_view name, MachineSight& sight) const override;
  bool is_published(std::string_view flag) const override;
  bool look_up_called(const Machine& /*caller*/, std::string_view /*behavior*/, CalledSight& /*sight*/) const override {
    return false;  // a scenario runs no behaviors
  }

 private:
  const NameTable* names_ = nullptr;
  const std::vector<MachineStatus>* machines_ = nullptr;
  const std::vector<NameId>* published_ = nullptr;
  double time_ = 0.0;
};

class ScenarioHost {
 public:
  /// `name`: "mirrored_placement", or a file below the scripts' root. `behaviors`: their view for the scenario;
  /// must outlive the host. `seed`: of the scenario's random numbers. Throws std::runtime_error (of a script:
  /// ScriptError) with one line.
  ScenarioHost(ScriptTexts texts, const std::string& name, const std::vector<ParameterChange>& parameters,
               const MachineDirectory& behaviors, std::uint64_t seed = 1);

  /// The behaviors that it requests.
  std::vector<std::string> wanted_behaviors() const;

  /// Its setting.
  ScenarioSetting setting() const;

  /// Call once after each frame. The result is valid until the next call.
  const ScenarioRecord& tick(const ScenarioView& view);
  const ScenarioRecord& record() const { return record_; }

  /// Applies edits of its files; the next record contains the results.
  void apply(std::span<const ScriptEdit> edits);

  /// Changes one of its parameters; nothing: unknown name.
  std::optional<ParameterOutcome> change(const ParameterChange& change);
  const ParameterRegistry& parameters() const { return parameters_; }
  std::vector<const MachineDefinition*> machines() const { return host_.definitions(); }
  const ScriptHost& host() const { return host_; }

 private:
  ParameterRegistry parameters_;
  ScenarioLanguage language_;
  ScriptHost host_;
  std::vector<double> values_;
  std::vector<ReloadRecord> reloads_;
  ScenarioRecord record_;
};

/// Applies the action to the robot, and adds inputs for the robot to `told`. `sides_changed`: whether the pose of the
/// action is in the operator's axes rotated by 180 degrees; half-time changes it. `referee`: the last state sent.
void carry_out(const OperatorAction& action, Operator& the_operator, ExternalInputs& external, bool& sides_changed,
               const RefereeState& referee);

/// Converts a pose from the axes of the hall (the team's axes in the first half) to the team's axes, and back.
inline Pose2 in_axes_of_team(const Pose2& pose, bool sides_changed) { return sides_changed ? reflect(pose) : pose; }

/// Counts the goals of a team that changes sides: `now` is the ball in the axes of the hall, whose goals are those in
/// the goals at positive and negative x.
class TeamScore {
 public:
  BallTruth count(const BallTruth& now, bool sides_changed);

 private:
  BallTruth last_, team_;
};

}  // namespace reorient
