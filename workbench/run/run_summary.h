// How a run ended, against the truth: an observer that remembers a few numbers, however long the run is.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "workbench/run/observer.h"

namespace reorient {

/// How far a belief is from the truth.
struct PoseError {
  double position = 0.0;  ///< m
  double rotation = 0.0;  ///< rad, not negative
};
PoseError pose_error(const Pose2& belief, const Pose2& truth);

/// Nearer to the truth than to its reflection, by what tells the two apart: the direction, and close enough to count.
bool is_correct(const Pose2& belief, const Pose2& truth);

/// One granted reorientation against the truth.
struct JudgedReorientation {
  double time = 0.0;  ///< s
  Reorientation reorientation = Reorientation::flip_pose;
  std::optional<bool> correct_before;  ///< the belief; nothing where nobody knows the truth
  std::optional<bool> correct_after;
};

/// The result; empty optionals where there is nothing to tell.
struct RunSummary {
  bool succeeded = false;                 ///< the scenario said so
  std::string verdict;                    ///< the scenario's words
  bool correct = false;                   ///< the belief is correct at the end
  std::optional<double> belief_wrong_at;  ///< s, start of the last time that the belief was wrong
  std::optional<double> corrected_after;  ///< s from then until it was correct and stayed so
  double wrong_seconds = 0.0;             ///< for which the belief was wrong altogether, while nobody carried the robot
  std::optional<PoseError> error;         ///< at the end
  std::optional<PoseError> mean_error;    ///< of correct beliefs, while the robot was upright
  PoseBelief belief;                      ///< at the end
  std::optional<GroundTruth> truth;
  int flips = 0;
  int purges = 0;
  int resets = 0;
  std::vector<JudgedReorientation> reorientations;  ///< the first kMostJudged
  double seconds = 0.0;                             ///< of the robot's time
  std::uint64_t frames = 0;

  static constexpr std::size_t kMostJudged = 1000;
};

class SummaryObserver : public Observer {
 public:
  void observe(const FrameRecord& frame, const StageRecord& stage) override;

  /// Without a verdict the scenario did not end in time.
  RunSummary summary() const;

 private:
  void judge_belief(const FrameRecord& frame, const StageRecord& stage);
  void judge_reorientation(const FrameRecord& frame, const StageRecord& stage);

  RunSummary summary_;
  std::optional<double> wrong_since_;  ///< start of the last stretch of wrong belief
  double last_wrong_ = 0.0;            ///< s
  PoseError sum_;                      ///< of correct beliefs' errors
  std::uint64_t summed_ = 0;           ///< frames
};

}  // namespace reorient
