#include "workbench/run/run_history.h"

#include <algorithm>

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

void RunHistory::add(const FrameLoop& frame) {
  const World& world = frame.world();
  add(FrameSample{world.time, world.confidence, world.pose, world.truth, world.training, world.evaluating,
                  world.carried, world.fallen});
  const ScriptOutput& output = frame.script_output();
  transitions_.insert(transitions_.end(), output.transitions.begin(), output.transitions.end());
  commands_.insert(commands_.end(), frame.commands().begin(), frame.commands().end());
  if (frame.rearrangement()) add(*frame.rearrangement());
}

RunSummary summarize(const RunHistory& history, const std::optional<ScenarioVerdict>& verdict) {
  RunSummary summary;
  summary.succeeded = verdict && verdict->succeeded;
  summary.verdict = verdict ? verdict->text : "the scenario did not end in time";
  for (const Rearrangement& rearrangement : history.rearrangements()) {
    summary.flips += rearrangement.command == Command::flip_pose;
    summary.purges += rearrangement.command == Command::purge_reflection;
    summary.resets += rearrangement.command == Command::reset_orientation;
  }
  if (history.samples().empty()) return summary;
  const FrameSample& last = history.samples().back();
  summary.seconds = last.time;
  summary.frames = static_cast<int>(history.samples().size());
  if (!last.truth) return summary;

  const auto wrong = [](const FrameSample& sample) {
    return sample.truth && !sample.carried && !sample.truth->carried &&
           !is_correct(sample.belief.pose, sample.truth->pose);
  };
  summary.error = pose_error(last.belief.pose, last.truth->pose);
  summary.correct = is_correct(last.belief.pose, last.truth->pose);
  // The last stretch of wrong belief, interrupted at most by moments in which the belief was right for a short while.
  constexpr double kStaysRight = 5.0;  // s
  const auto& samples = history.samples();
  const auto last_wrong = std::find_if(samples.rbegin(), samples.rend(), wrong);
  if (last_wrong == samples.rend()) return summary;
  double begin = last_wrong->time;
  for (auto sample = last_wrong; sample != samples.rend() && begin - sample->time < kStaysRight; ++sample) {
    if (wrong(*sample)) begin = sample->time;
  }
  summary.belief_wrong_at = begin;
  if (summary.correct) summary.corrected_after = last_wrong->time - begin;
  return summary;
}

}  // namespace reorient
