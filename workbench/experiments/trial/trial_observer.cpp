#include "workbench/experiments/trial/trial_observer.h"

#include <algorithm>

#include "workbench/run/run_summary.h"

namespace reorient {
namespace {

constexpr double kTolerance = 1e-6;      // s: frame times are sums of rounded steps
constexpr double kBetweenSamples = 0.5;  // s

/// "turned round/lost" is within "turned round".
bool is_within(std::string_view path, std::string_view state) {
  return path.starts_with(state) && (path.size() == state.size() || path[state.size()] == '/');
}

}  // namespace

bool TrialObserver::starts(const ScenarioRecord& scenario) const {
  return measurement_.from.empty() ||
         std::any_of(scenario.machines.begin(), scenario.machines.end(), [&](const MachineStatus& machine) {
           return is_within(scenario.name(machine.state), measurement_.from);
         });
}

void TrialObserver::observe(const FrameRecord& frame, const StageRecord& stage) {
  const World& world = frame.world;
  const bool is_held = !stage.truth || stage.truth->carried;
  const bool correct = !is_held && is_correct(world.pose.pose, stage.truth->pose);
  if (result_.started) {
    const double time = world.time - started_at_;
    result_.seconds = time;
    if (!is_held) judge_belief(world, correct);
    if (!correct) {
      right_since_.reset();
    } else if (!right_since_) {
      right_since_ = time;
    }
    const bool in_time = right_since_ && *right_since_ <= measurement_.limit + kTolerance;
    if (!result_.right_after && in_time && time - *right_since_ + kTolerance >= measurement_.hold)
      result_.right_after = right_since_;
    if (frame.reorientation && stage.truth) judge_reorientation(*frame.reorientation, *stage.truth, time);
    sample(world, correct, time);
    return;
  }
  // The scenario looks at a frame when it is over: what it does then is seen in the next one.
  if (!starts(stage.scenario)) return;
  result_.started = true;
  result_.correct_at_start = correct;
  started_at_ = world.time;
}

void TrialObserver::judge_belief(const World& world, bool correct) {
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
  if (result_.mended_after || was_correct || !is_correct(record.belief_after.pose, truth.pose)) return;
  result_.mended_after = time;
  result_.mended_by = record.reorientation;
}

void TrialObserver::sample(const World& world, bool correct, double time) {
  if (!result_.confidences.empty() && time + kTolerance < result_.confidences.back().time + kBetweenSamples) return;
  result_.confidences.push_back(
      {time, world.confidence.current, world.confidence.opposite, world.room_status, correct});
}

bool TrialObserver::is_over() const {
  const bool is_right = result_.right_after && !measurement_.to_the_end;
  return is_right || result_.seconds + kTolerance >= measurement_.limit + measurement_.hold;
}

}  // namespace reorient
