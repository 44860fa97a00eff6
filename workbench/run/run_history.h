// What happened in a run, kept for the timeline, the summary and the pictures.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "engine/frame.h"

namespace reorient {

struct FrameSample {
  double time = 0.0;  ///< s
  Confidences confidence;
  PoseBelief belief;
  std::optional<GroundTruth> truth;
  bool training = false;
  bool evaluating = false;
  bool carried = false;
  bool fallen = false;
};

/// How far a belief is from the truth.
struct PoseError {
  double position = 0.0;  ///< m
  double rotation = 0.0;  ///< rad, not negative
};
PoseError pose_error(const Pose2& belief, const Pose2& truth);

/// Nearer to the truth than to its reflection, by what tells the two apart: the direction, and close enough to count.
bool is_correct(const Pose2& belief, const Pose2& truth);

class RunHistory {
 public:
  void add(const FrameLoop& frame);
  void add(const FrameSample& sample) { samples_.push_back(sample); }
  void add(const Rearrangement& rearrangement) { rearrangements_.push_back(rearrangement); }

  const std::vector<FrameSample>& samples() const { return samples_; }
  const std::vector<TransitionRecord>& transitions() const { return transitions_; }
  const std::vector<CommandRecord>& commands() const { return commands_; }
  const std::vector<Rearrangement>& rearrangements() const { return rearrangements_; }

 private:
  std::vector<FrameSample> samples_;
  std::vector<TransitionRecord> transitions_;
  std::vector<CommandRecord> commands_;
  std::vector<Rearrangement> rearrangements_;
};

/// The result of a run against the truth; empty optionals where there is nothing to tell.
struct RunSummary {
  bool succeeded = false;                 ///< the scenario said so
  std::string verdict;                    ///< the scenario's words
  bool correct = false;                   ///< the belief is right at the end
  std::optional<double> belief_wrong_at;  ///< s, start of the last time that the belief was wrong
  std::optional<double> corrected_after;  ///< s from then until it was right and stayed so
  std::optional<PoseError> error;         ///< at the end
  int flips = 0;
  int purges = 0;
  int resets = 0;
  double seconds = 0.0;  ///< of the robot's time
  int frames = 0;
};

/// Without a verdict the scenario did not end in time.
RunSummary summarize(const RunHistory& history, const std::optional<ScenarioVerdict>& verdict);

}  // namespace reorient
