// SPDX-License-Identifier: MIT
// Judges a trial while it runs, from the records alone.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "workbench/experiments/trial/trial_result.h"
#include "workbench/run/decision_threshold.h"
#include "workbench/run/observer.h"

namespace reorient {

/// The measurement of a trial.
struct Measurement {
  std::string from;  ///< state of the scenario (or an outer state) whose first entry starts the clock; empty: at once
  double limit = 60.0;          ///< s, within which the belief must be right
  double hold = 10.0;           ///< s for which it must stay right, beyond the limit if necessary
  bool symmetric_room = false;  ///< nothing distinguishes its two ends: a robot that reports this has not failed
  bool to_the_end = true;       ///< false: a trial ends when its belief was right for `hold`
};

/// Whether a state of that path equals the other one or is within it, as "mirrored/lost" is within "mirrored".
bool is_within(std::string_view path, std::string_view state);

/// Between frames the belief counts as in the last one; in the air, and if the true pose is unknown, as wrong.
class TrialObserver : public Observer {
 public:
  explicit TrialObserver(Measurement measurement) : measurement_(std::move(measurement)) {
    result_.symmetric_room = measurement_.symmetric_room;
  }

  Topics wanted() const override { return {DecisionThreshold::kTopic}; }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  /// Whether the measurement is complete.
  bool is_over() const;
  const TrialResult& result() const { return result_; }

 private:
  bool starts(const ScenarioRecord& scenario) const;
  void watch_carrying(const SceneTruth& scene);
  void judge_start(bool is_held, bool correct);
  void judge_belief(const World& world, bool correct);
  void judge_reorientation(const ReorientationRecord& record, const GroundTruth& truth, double time);
  void sample(const World& world, bool correct, bool reflected, double time);

  Measurement measurement_;
  TrialResult result_;
  DecisionThreshold threshold_;
  double started_at_ = 0.0;  ///< s of the robot's time
  std::optional<Pose2> picked_up_at_;
  bool is_start_judged_ = false;
  std::optional<double> right_since_;  ///< s since the clock started
};

}  // namespace reorient
