// SPDX-License-Identifier: MIT
#include "workbench/experiments/trial/trial_observer.h"

#include <algorithm>
#include <utility>

#include "workbench/run/run_summary.h"

namespace reorient {
namespace {

constexpr double kTolerance = 1e-6;      // s: frame times are sums of rounded steps
constexpr double kBetweenSamples = 0.5;  // s

}  // namespace

bool is_within(std::string_view path, std::string_view state) {
  return path.starts_with(state) && (path.size() == state.size() || path[state.size()] == '/');
}

bool TrialObserver::starts(const ScenarioRecord& scenario) const {
  return measurement_.from.empty() ||
         std::any_of(scenario.machines.begin(), scenario.machines.end(), [&](const MachineStatus& machine) {
           return is_within(scenario.name(machine.state), measurement_.from);
         });
}

void TrialObserver::watch_carrying(const SceneTruth& scene) {
  for (const OperatorAction& action : scene.scenario.actions) {
    if (action.kind == OperatorAction::Kind::pick_up && scene.truth) picked_up_at_ = scene.truth->pose;
    if (action.kind != OperatorAction::Kind::put_down || !picked_up_at_) continue;
    if (!is_correct(action.pose, *picked_up_at_)) result_.displaced = true;
    picked_up_at_.reset();
  }
}

void TrialObserver::observe(const FrameRecord& frame, const SceneTruth& scene) {
  watch_carrying(scene);
  threshold_.observe(frame);
  const World& world = frame.world;
  const bool is_held = !scene.truth || scene.truth->carried;
  const bool correct = !is_held && is_correct(world.pose.pose, scene.truth->pose);
  if (result_.started) {
    const double time = world.time - started_at_;
    result_.seconds = time;
    judge_start(is_held, correct);
    if (!is_held) judge_belief(world, correct);
    if (!correct) {
      right_since_.reset();
    } else if (!right_since_) {
      right_since_ = time;
    }
    const bool in_time = right_since_ && *right_since_ <= measurement_.limit + kTolerance;
    if (!result_.right_after && in_time && time - *right_since_ + kTolerance >= measurement_.hold)
      result_.right_after = right_since_;
    if (frame.reorientation && scene.truth) judge_reorientation(*frame.reorientation, *scene.truth, time);
    sample(world, correct, !is_held && is_correct(reflect(world.pose.pose), scene.truth->pose), time);
    return;
  }
  // The scenario runs after a frame: its actions take effect in the next frame.
  if (!starts(scene.scenario)) return;
  result_.started = true;
  result_.correct_at_start = false;
  started_at_ = world.time;
}

/// A robot that is still in the air is judged when it stands.
void TrialObserver::judge_start(bool is_held, bool correct) {
  if (is_held || std::exchange(is_start_judged_, true)) return;
  result_.correct_at_start = correct;
}

void TrialObserver::judge_belief(const World& world, bool correct) {
  if (!result_.usable_after && world.room_status == RoomStatus::usable) result_.usable_after = world.time - started_at_;
  result_.ended_uninformative = world.room_status == RoomStatus::symmetric;
  if (result_.ended_uninformative) result_.uninformative_seconds += world.time_step;
  if (world.upright()) (correct ? result_.right_seconds : result_.wrong_seconds) += world.time_step;
}

void TrialObserver::judge_reorientation(const ReorientationRecord& record, const GroundTruth& truth, double time) {
  const bool was_correct = is_correct(record.belief_before.pose, truth.pose);
  const bool is_flip = record.reorientation == Reorientation::flip_pose;
  const bool is_purge = record.reorientation == Reorientation::purge_reflection;
  result_.flips += is_flip ? 1 : 0;
  result_.purges += is_purge ? 1 : 0;
  result_.resets += record.reorientation == Reorientation::reset_orientation ? 1 : 0;
  result_.false_flips += is_flip && was_correct ? 1 : 0;
  result_.false_purges += is_purge && !is_correct(record.belief_after.pose, truth.pose) && was_correct ? 1 : 0;
  if (result_.corrected_after || was_correct || !is_correct(record.belief_after.pose, truth.pose)) return;
  result_.corrected_after = time;
  result_.corrected_by = record.reorientation;
}

void TrialObserver::sample(const World& world, bool correct, bool reflected, double time) {
  if (!result_.confidences.empty() && time + kTolerance < result_.confidences.back().time + kBetweenSamples) return;
  result_.confidences.push_back({time, world.confidence.current, world.confidence.opposite, world.confidence.evidence,
                                 world.room_status, correct, reflected, threshold_.value()});
}

bool TrialObserver::is_over() const {
  const bool is_right = result_.right_after && !measurement_.to_the_end;
  return is_right || result_.seconds + kTolerance >= measurement_.limit + measurement_.hold;
}

}  // namespace reorient
