// SPDX-License-Identifier: MIT
#include "workbench/run/run_summary.h"

#include <algorithm>

namespace reorient {
namespace {

/// The verdict of a run without a verdict of its scenario.
const char* words_of(RunEnd end) {
  switch (end) {
    case RunEnd::stopped:
      return "interrupted";
    case RunEnd::robot_gone:
      return "the robot sends no more frames";
    default:
      return "the scenario did not end in time";
  }
}

/// Whether the motion between two frames is faster than a robot walks, turns or falls.
bool is_jump(const Pose2& from, const Pose2& to) {
  constexpr double kFar = 0.25;          // m
  constexpr double kTurned = kPi / 6.0;  // rad
  const PoseError step = pose_error(from, to);
  return step.position > kFar || step.rotation > kTurned;
}

}  // namespace

PoseError pose_error(const Pose2& belief, const Pose2& truth) {
  return {(belief.position - truth.position).norm(), std::abs(angle_difference(belief.rotation, truth.rotation))};
}

bool is_correct(const Pose2& belief, const Pose2& truth) {
  constexpr double kNear = 1.0;          // m
  constexpr double kTurned = kPi / 4.0;  // rad
  const PoseError error = pose_error(belief, truth);
  return error.position < kNear && error.rotation < kTurned;
}

void SummaryObserver::observe(const FrameRecord& frame, const SceneTruth& scene) {
  ++summary_.frames;
  summary_.seconds = frame.world.time;
  summary_.belief = frame.world.pose;
  summary_.camera_bias = frame.world.camera_bias;
  summary_.truth = scene.truth;
  if (scene.scenario.verdict) {
    summary_.succeeded = scene.scenario.verdict->succeeded;
    summary_.verdict = scene.scenario.verdict->text;
  }
  note_faults(frame.faults, frame.reloads);
  note_faults(scene.scenario.faults, scene.scenario.reloads);
  if (frame.reorientation) judge_reorientation(frame, scene);
  if (scene.truth) judge_belief(frame, scene);
}

void SummaryObserver::note_faults(const std::vector<FaultRecord>& faults, const std::vector<ReloadRecord>& reloads) {
  for (const ReloadRecord& reload : reloads) {
    if (reload.accepted) faults_.erase(reload.script);
  }
  for (const FaultRecord& record : faults) {
    Faults& script = faults_[record.script];
    ++script.errors;
    script.last = record.fault.text();
    script.stopped = record.consequence == FaultRecord::Consequence::stopped;
  }
}

void SummaryObserver::judge_reorientation(const FrameRecord& frame, const SceneTruth& scene) {
  const ReorientationRecord& record = *frame.reorientation;
  summary_.flips += record.reorientation == Reorientation::flip_pose;
  summary_.purges += record.reorientation == Reorientation::purge_reflection;
  summary_.resets += record.reorientation == Reorientation::reset_orientation;
  if (summary_.reorientations.size() >= RunSummary::kMostJudged) return;
  JudgedReorientation judged{frame.world.time, record.reorientation, {}, {}};
  if (scene.truth) {
    judged.correct_before = is_correct(record.belief_before.pose, scene.truth->pose);
    judged.correct_after = is_correct(record.belief_after.pose, scene.truth->pose);
  }
  summary_.reorientations.push_back(judged);
}

/// A period of wrong belief may contain short times with a correct belief.
void SummaryObserver::judge_belief(const FrameRecord& frame, const SceneTruth& scene) {
  constexpr double kStaysCorrect = 5.0;  // s
  const World& world = frame.world;
  const GroundTruth& truth = *scene.truth;
  summary_.error = pose_error(world.pose.pose, truth.pose);
  summary_.correct = is_correct(world.pose.pose, truth.pose);
  if (summary_.correct && world.upright()) {
    sum_.position += summary_.error->position;
    sum_.rotation += summary_.error->rotation;
    ++summed_;
  }
  may_be_wrong_ =
      may_be_wrong_ || summary_.correct || truth.carried || (last_truth_ && is_jump(*last_truth_, truth.pose));
  last_truth_ = truth.pose;
  if (!may_be_wrong_ || summary_.correct || world.posture == Posture::lifted || truth.carried) return;
  summary_.wrong_seconds += world.time_step;
  if (!wrong_since_ || world.time - last_wrong_ >= kStaysCorrect) {
    wrong_since_ = world.time;
    ++summary_.wrong_periods;
  }
  last_wrong_ = world.time;
  summary_.longest_wrong = std::max(summary_.longest_wrong, last_wrong_ - *wrong_since_);
}

RunSummary SummaryObserver::summary(RunEnd end) const {
  RunSummary summary = summary_;
  if (summary.verdict.empty()) summary.verdict = words_of(end);
  for (const auto& [script, faults] : faults_) {
    if (faults.stopped) summary.stopped.push_back({script, faults.errors, faults.last});
  }
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
