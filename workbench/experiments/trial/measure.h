// SPDX-License-Identifier: MIT
// What an experiment counts and averages in each trial besides the belief: the table [measure] of its file.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/experiments/trial/trial_observer.h"
#include "workbench/run/observer.h"

namespace reorient {

enum class MeasureType {
  entered,     ///< entries of a state, or of one within it: "orientation/correcting"
  transition,  ///< "orientation/watching > correcting"
  granted,     ///< commands: "flip_pose", or actions of the application: "action.kick"
  refused,
  logged,  ///< log lines that contain a text
  mean,    ///< of a number or boolean of the world: "robot.head_yaw"
  minimum,
  maximum,
  at_end
};
constexpr int enum_count(MeasureType) { return 9; }

/// "entered": the key in the file.
std::string_view to_string(MeasureType type);

struct Measure {
  MeasureType type = MeasureType::entered;
  std::string name;     ///< as in the file
  std::string said_at;  ///< file and line

  /// "entered orientation/correcting": the name of its column.
  std::string label() const { return std::string(to_string(type)) + " " + name; }
  /// Whether it counts events: its value is 0 in a trial without any.
  bool is_count() const { return type < MeasureType::mean; }
};
inline constexpr std::size_t kMostMeasures = 64;

/// "rad" of a world value; empty for counts.
std::string unit_of(const Measure& measure);

/// The empty text, or why the name can never have a value, with the nearest name. The states of machines are not known
/// here.
std::string mistake_in(const Measure& measure);

/// The states in its name, as "orientation/correcting": one of an entry, two of a transition, else none.
std::vector<std::string> states_of(const Measure& measure);
/// The empty text, or which state is not among the `known` ones nor contains one of them, with the nearest name.
std::string mistake_in_states(const Measure& measure, const std::set<std::string>& known);

/// The value of a measure in one trial; nothing: its clock never started.
using MeasuredValue = std::optional<double>;

/// Counts and averages from the start of the trial's clock.
class MeasureObserver : public Observer {
 public:
  /// `trial` judges the same run and observes each frame before this one does. Measures of actions that the
  /// application does not declare are 0.
  MeasureObserver(std::vector<Measure> measures, const TrialObserver& trial);

  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  /// In the order of the measures.
  std::vector<MeasuredValue> values() const;

 private:
  struct Tally {
    Measure measure;
    std::vector<std::string> states;  ///< of its name
    std::size_t field = 0;            ///< index of a world value
    double sum = 0.0, minimum = 0.0, maximum = 0.0, last = 0.0;
  };
  void count(const FrameRecord& frame, const ScenarioRecord& scenario, Tally& tally) const;

  const TrialObserver& trial_;
  std::vector<Tally> tallies_;
  std::vector<double> world_;
  std::uint64_t frames_ = 0;
};

}  // namespace reorient
