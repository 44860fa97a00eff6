// SPDX-License-Identifier: MIT
// The result of one trial: plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/world/commands.h"
#include "engine/world/world.h"
#include "workbench/experiments/peers/compass_look.h"
#include "workbench/experiments/trial/pose_errors.h"

namespace reorient {

/// The confidences at one moment.
struct ConfidenceSample {
  double time = 0.0;  ///< s since the trial's clock started
  double current = 0.0;
  double opposite = 0.0;
  double evidence = 0.0;  ///< log-odds for the reflection of the belief
  RoomStatus status = RoomStatus::resting;
  bool correct = false;    ///< the belief
  bool reflected = false;  ///< it is the reflection of a correct one
  double threshold = 0.0;  ///< of the evidence, for an unconfirmed pose; 0: no behavior has one
};
/// Visits its values in a fixed order, for reading and writing.
template <typename Visit, typename Sample>
void visit_values(Visit&& visit, Sample& sample) {
  visit(sample.time);
  visit(sample.current);
  visit(sample.opposite);
  visit(sample.evidence);
  visit(sample.status);
  visit(sample.correct);
  visit(sample.reflected);
  visit(sample.threshold);
}

/// All times are in s since the trial's clock started: its scenario entered the state from which a condition measures.
struct TrialResult {
  std::uint64_t seed = 0;
  bool started = false;          ///< whether the clock started
  double seconds = 0.0;          ///< measured duration
  bool correct_at_start = true;  ///< the belief

  std::optional<double>
      right_after;  ///< time from which the belief was right and stayed right for the required duration
  std::optional<double> corrected_after;  ///< the first command that corrected a wrong belief: the paper's measure
  std::optional<Reorientation> corrected_by;
  std::optional<double> usable_after;  ///< time from which the room distinguished the two poses
  bool displaced = false;              ///< the robot was moved to another place while lifted, even before the clock

  int flips = 0;
  int purges = 0;
  int resets = 0;
  int false_flips = 0;                 ///< flips of a right belief
  int false_purges = 0;                ///< purges that made a right belief wrong
  double right_seconds = 0.0;          ///< for which the belief was right, while the robot stood on its feet
  double wrong_seconds = 0.0;          ///< the same of a wrong one
  double uninformative_seconds = 0.0;  ///< in which the robot called its room symmetric
  bool ended_uninformative = false;
  bool symmetric_room = false;  ///< nothing distinguishes its two ends: a robot that reports this has not failed
  std::vector<ConfidenceSample> confidences;  ///< twice a second
  std::vector<CompassLook> looks;             ///< empty unless the condition compares compasses
  std::optional<PoseErrors> pose_errors;      ///< if the condition requests them
  /// Values of the experiment's measures, in their order; nothing: the trial has none.
  std::vector<std::optional<double>> measures;

  bool failed() const { return !right_after.has_value() && !(symmetric_room && ended_uninformative); }
  /// Whether its belief was wrong when the clock started; a trial whose clock never started counts as disturbed.
  bool disturbed() const { return !started || !correct_at_start; }
};
/// Visits all values except the lists and the errors of the pose, each with its name, for reading and writing. A value
/// that is missing here is lost between the process of the trial and the process that prints the results.
template <typename Visit, typename Result>
void visit_named_values(Visit&& visit, Result& result) {
  visit("seed", result.seed);
  visit("started", result.started);
  visit("seconds", result.seconds);
  visit("correct_at_start", result.correct_at_start);
  visit("right_after", result.right_after);
  visit("corrected_after", result.corrected_after);
  visit("corrected_by", result.corrected_by);
  visit("usable_after", result.usable_after);
  visit("displaced", result.displaced);
  visit("flips", result.flips);
  visit("purges", result.purges);
  visit("resets", result.resets);
  visit("false_flips", result.false_flips);
  visit("false_purges", result.false_purges);
  visit("right_seconds", result.right_seconds);
  visit("wrong_seconds", result.wrong_seconds);
  visit("uninformative_seconds", result.uninformative_seconds);
  visit("ended_uninformative", result.ended_uninformative);
  visit("symmetric_room", result.symmetric_room);
}

}  // namespace reorient
