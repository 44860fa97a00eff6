// SPDX-License-Identifier: MIT
// All of a trial except its seed: plain data, so that an experiment can be a file.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/parameters/parameter.h"
#include "workbench/experiments/condition/reference.h"
#include "workbench/experiments/trial/measure.h"
#include "workbench/experiments/trial/trial_observer.h"

namespace reorient {

/// File and line of a setting, such as "scenario" or "with head_scan".
using SaidAt = std::map<std::string, std::string>;

struct Condition {
  std::string scenario;
  std::vector<std::string> with;             ///< behaviors in addition to those that the scenario lists
  std::vector<std::string> without;          ///< of those that the scenario lists
  std::vector<std::string> parameter_files;  ///< read one after the other
  std::vector<ParameterChange> parameters;   ///< applied after the files
  std::string room;                          ///< panorama, by its path or as a shipped one; empty: the built-in hall
  std::optional<std::uint64_t> hall_seed;    ///< of the built-in hall; nothing: the scenario's
  std::string field;                         ///< file, or the name of a shipped one; empty: the scenario's
  std::string interface;                     ///< that the simulator plays; file, or a shipped one; empty: none
  std::string body = "nao-v6";               ///< file, or the name of a shipped one
  std::string cameras = "upper";             ///< or "both"
  int width = 320;                           ///< of the images, pixels
  bool room_awareness = true;
  double seconds = 600.0;       ///< of the robot's time, at most
  double learned_before = 0.0;  ///< s for which the robot learned the room on another day; 0: it did not
  bool compasses = false;       ///< whether room awareness and its peers are compared (trial/compass_observer.h)
  bool pose_errors = false;     ///< whether the belief of each frame is compared with the truth
  Measurement measurement;
  std::vector<Measure> measures;  ///< of the experiment
  SaidAt said_at;                 ///< for messages
};

/// The whole condition, a line for each value in a fixed order: equal conditions have equal texts.
std::string as_text(const Condition& condition);

/// Part of a condition: its values are changed or added.
struct ConditionPatch {
  std::vector<ConditionPatch> first;  ///< applied before it: from the condition files that it names
  std::optional<std::string> scenario;
  std::vector<std::string> with;
  std::vector<std::string> without;
  std::vector<std::string> parameter_files;
  std::vector<ParameterChange> parameters;
  std::optional<std::string> room;
  std::optional<std::uint64_t> hall_seed;
  std::optional<std::string> field;
  std::optional<std::string> interface;
  std::optional<std::string> body;
  std::optional<std::string> cameras;
  std::optional<int> width;
  std::optional<bool> room_awareness;
  std::optional<double> seconds;
  std::optional<double> learned_before;
  std::optional<bool> compasses;
  std::optional<bool> pose_errors;
  std::optional<std::string> measured_from;
  std::optional<double> limit;
  std::optional<double> hold;
  std::optional<bool> to_the_end;
  std::optional<bool> symmetric_room;
  SaidAt said_at;
};
void apply(const ConditionPatch& patch, Condition& condition);

/// One choice of an axis: "paper" of "mode".
struct AxisChoice {
  std::string name;
  ConditionPatch patch;
  std::string description{};  ///< one sentence for the report, or empty
};
struct Axis {
  std::string name;
  std::vector<AxisChoice> choices;
  std::vector<std::string> usual{};  ///< choices used if no others are requested; empty: all
  std::string description{};         ///< one sentence for the report, or empty
};

/// The time that the columns mean_s, median_s and p90_s contain.
enum class TimeOf {
  command,  ///< until the command that corrects the belief: the paper's measure
  belief,   ///< until the belief is right and stays right
};

/// A condition that is varied along axes, one or more trials for each combination of choices.
struct Experiment {
  std::string name;
  std::string title;
  std::string description;
  int trials = 20;  ///< of each cell
  TimeOf times = TimeOf::command;
  ConditionPatch base;
  std::vector<ConditionPatch> alternates;  ///< the trials of each cell use these in turn
  std::vector<Axis> axes;
  std::vector<Measure> measures;
  ConditionPatch overrides{};  ///< from the command line; applied last
  std::vector<Reference> references;
};

/// Whether it belongs to a cell with these choices, one for each axis.
bool belongs_to(const Reference& reference, const Experiment& experiment, const std::vector<std::string>& choices);

/// Keeps only these choices of the axis. `otherwise` creates the choice of an unknown name, or refuses it. Throws
/// std::runtime_error with one line if the axis is unknown.
void choose(Experiment& experiment, const std::string& axis, const std::vector<std::string>& names,
            const std::function<AxisChoice(const Axis& axis, const std::string& name)>& otherwise);

/// The experiment with the usual choices only.
Experiment with_usual_choices(Experiment experiment);

/// One combination of choices.
struct Cell {
  std::vector<std::string> choices;  ///< one for each axis, in their order
  Condition condition;
};
/// All cells; the last axis varies fastest. Throws std::runtime_error with one line if there are too many.
std::vector<Cell> cells_of(const Experiment& experiment);

}  // namespace reorient
