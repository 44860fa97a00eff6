// SPDX-License-Identifier: MIT
// The result of a run compared with the truth: an observer with constant memory.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "workbench/run/observer.h"
#include "workbench/run/run_end.h"

namespace reorient {

/// Error of a belief.
struct PoseError {
  double position = 0.0;  ///< m
  double rotation = 0.0;  ///< rad, not negative
};
PoseError pose_error(const Pose2& belief, const Pose2& truth);

/// Whether the belief is near the truth and has its direction, not that of the reflection.
bool is_correct(const Pose2& belief, const Pose2& truth);

/// One granted reorientation, judged by the truth.
struct JudgedReorientation {
  double time = 0.0;  ///< s
  Reorientation reorientation = Reorientation::flip_pose;
  std::optional<bool> correct_before;  ///< whether the belief was correct; nothing if the true pose is unknown
  std::optional<bool> correct_after;
};

/// A script that was stopped for its errors and did not run again.
struct StoppedScript {
  std::string script;  ///< file, from the scripts' root
  int errors = 0;      ///< since it was last loaded
  std::string last;    ///< the last error, with its position
};

/// The result; empty optionals for values that do not exist.
struct RunSummary {
  bool succeeded = false;  ///< by the verdict of the scenario
  std::string verdict;     ///< text of the scenario, or how the run ended without a verdict
  bool correct = false;    ///< the belief is correct at the end
  /// s, start of the last period of wrong belief after a correct one, or after the operator moved the robot.
  std::optional<double> belief_wrong_at;
  std::optional<double> corrected_after;  ///< s from then until it was correct and stayed correct
  int wrong_periods = 0;                  ///< number of periods of wrong belief
  double longest_wrong = 0.0;             ///< s, duration of the longest one
  double wrong_seconds = 0.0;             ///< total time with a wrong belief, except while the robot was lifted
  std::optional<PoseError> error;         ///< at the end
  std::optional<PoseError> mean_error;    ///< of correct beliefs, while the robot was upright
  PoseBelief belief;                      ///< at the end
  CameraBias camera_bias;                 ///< at the end
  std::optional<GroundTruth> truth;
  int flips = 0;
  int purges = 0;
  int resets = 0;
  std::vector<JudgedReorientation> reorientations;  ///< the first kMostJudged
  std::vector<StoppedScript> stopped;               ///< at the end, by name
  double seconds = 0.0;                             ///< of the robot's time
  std::uint64_t frames = 0;

  static constexpr std::size_t kMostJudged = 1000;
};

class SummaryObserver : public Observer {
 public:
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  /// Whether the scenario has judged the run.
  bool has_verdict() const { return !summary_.verdict.empty(); }
  /// `end`: how the run ended, if not by the scenario's verdict.
  RunSummary summary(RunEnd end = RunEnd::time_up) const;

 private:
  void judge_belief(const FrameRecord& frame, const SceneTruth& scene);
  void note_faults(const std::vector<FaultRecord>& faults, const std::vector<ReloadRecord>& reloads);
  void judge_reorientation(const FrameRecord& frame, const SceneTruth& scene);

  RunSummary summary_;
  struct Faults {
    int errors = 0;
    std::string last;
    bool stopped = false;
  };
  std::map<std::string, Faults> faults_;  ///< of each running script
  bool may_be_wrong_ = false;             ///< the belief was correct before, or the operator moved the robot
  std::optional<Pose2> last_truth_;
  std::optional<double> wrong_since_;  ///< start of the last period of wrong belief
  double last_wrong_ = 0.0;            ///< s
  PoseError sum_;                      ///< of correct beliefs' errors
  std::uint64_t summed_ = 0;           ///< frames
};

}  // namespace reorient
