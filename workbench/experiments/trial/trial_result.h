// What one trial showed: plain data.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/world/commands.h"
#include "engine/world/world.h"

namespace reorient {

/// The confidences at one moment.
struct ConfidenceSample {
  double time = 0.0;  ///< s since the trial's clock started
  double current = 0.0;
  double opposite = 0.0;
  RoomStatus status = RoomStatus::resting;
  bool correct = false;  ///< the belief
};
template <typename Visit>
void fields(Visit&& visit, ConfidenceSample& sample) {
  visit(sample.time, sample.current, sample.opposite, sample.status, sample.correct);
}

/// All times are in s since the trial's clock started: its scenario entered the state from which a condition measures.
struct TrialResult {
  std::uint64_t seed = 0;
  bool started = false;          ///< the clock did
  double seconds = 0.0;          ///< that were measured
  bool correct_at_start = true;  ///< the belief

  std::optional<double> right_after;   ///< from when on the belief was right and stayed so for as long as is asked
  std::optional<double> mended_after;  ///< the first command that put a wrong belief right: what the paper measures
  std::optional<Reorientation> mended_by;
  std::optional<double> usable_after;  ///< from when on the room told the two poses apart
  bool kidnapped = false;  ///< the robot was put down elsewhere than it was picked up, even before the clock

  int flips = 0;
  int purges = 0;
  int resets = 0;
  int false_flips = 0;                 ///< of a belief that was right
  int false_purges = 0;                ///< that made a right belief wrong
  double right_seconds = 0.0;          ///< for which the belief was right, while the robot stood on its feet
  double wrong_seconds = 0.0;          ///< the same of a wrong one
  double uninformative_seconds = 0.0;  ///< for which the robot took its room for symmetric
  bool ended_uninformative = false;
  bool symmetric_room = false;                ///< nothing tells its two ends apart: who says so has not failed
  std::vector<ConfidenceSample> confidences;  ///< twice a second

  bool failed() const { return !right_after.has_value() && !(symmetric_room && ended_uninformative); }
};
template <typename Visit>
void fields(Visit&& visit, TrialResult& result) {
  visit(result.seed, result.started, result.seconds, result.correct_at_start, result.right_after, result.mended_after,
        result.mended_by, result.usable_after, result.kidnapped, result.flips, result.purges, result.resets,
        result.false_flips, result.false_purges, result.right_seconds, result.wrong_seconds,
        result.uninformative_seconds, result.ended_uninformative, result.symmetric_room, result.confidences);
}

}  // namespace reorient
