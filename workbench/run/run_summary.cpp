#include "workbench/run/run_summary.h"

namespace reorient {

PoseError pose_error(const Pose2& belief, const Pose2& truth) {
  return {(belief.position - truth.position).norm(), std::abs(angle_difference(belief.rotation, truth.rotation))};
}

bool is_correct(const Pose2& belief, const Pose2& truth) {
  constexpr double kNear = 1.0;          // m
  constexpr double kTurned = kPi / 4.0;  // rad
  const PoseError error = pose_error(belief, truth);
  return error.position < kNear && error.rotation < kTurned;
}

void SummaryObserver::observe(const FrameRecord& frame, const StageRecord& stage) {
  ++summary_.frames;
  summary_.seconds = frame.world.time;
  summary_.belief = frame.world.pose;
  summary_.truth = stage.truth;
  if (stage.scenario.verdict) {
    summary_.succeeded = stage.scenario.verdict->succeeded;
    summary_.verdict = stage.scenario.verdict->text;
  }
  if (frame.reorientation) judge_reorientation(frame, stage);
  if (stage.truth) judge_belief(frame, stage);
}

void SummaryObserver::judge_reorientation(const FrameRecord& frame, const StageRecord& stage) {
  const ReorientationRecord& record = *frame.reorientation;
  summary_.flips += record.reorientation == Reorientation::flip_pose;
  summary_.purges += record.reorientation == Reorientation::purge_reflection;
  summary_.resets += record.reorientation == Reorientation::reset_orientation;
  if (summary_.reorientations.size() >= RunSummary::kMostJudged) return;
  JudgedReorientation judged{frame.world.time, record.reorientation, {}, {}};
  if (stage.truth) {
    judged.correct_before = is_correct(record.belief_before.pose, stage.truth->pose);
    judged.correct_after = is_correct(record.belief_after.pose, stage.truth->pose);
  }
  summary_.reorientations.push_back(judged);
}

/// A stretch of wrong belief may be interrupted by moments in which the belief was correct for a short while.
void SummaryObserver::judge_belief(const FrameRecord& frame, const StageRecord& stage) {
  constexpr double kStaysCorrect = 5.0;  // s
  const World& world = frame.world;
  const GroundTruth& truth = *stage.truth;
  summary_.error = pose_error(world.pose.pose, truth.pose);
  summary_.correct = is_correct(world.pose.pose, truth.pose);
  if (summary_.correct && world.upright()) {
    sum_.position += summary_.error->position;
    sum_.rotation += summary_.error->rotation;
    ++summed_;
  }
  if (summary_.correct || world.posture == Posture::lifted || truth.carried) return;
  summary_.wrong_seconds += world.time_step;
  if (!wrong_since_ || world.time - last_wrong_ >= kStaysCorrect) wrong_since_ = world.time;
  last_wrong_ = world.time;
}

RunSummary SummaryObserver::summary() const {
  RunSummary summary = summary_;
  if (summary.verdict.empty()) summary.verdict = "the scenario did not end in time";
  if (summed_ > 0) {
    const auto count = static_cast<double>(summed_);
    summary.mean_error = PoseError{sum_.position / count, sum_.rotation / count};
  }
  if (!wrong_since_) return summary;
  summary.belief_wrong_at = wrong_since_;
  if (summary.correct) summary.corrected_after = last_wrong_ - *wrong_since_;
  return summary;
}

}  // namespace reorient
