// SPDX-License-Identifier: MIT
#include "workbench/run/run_history.h"

#include <algorithm>

#include "workbench/run/run_summary.h"

namespace reorient {

void RunHistory::observe(const FrameRecord& frame, const SceneTruth& scene) {
  const World& world = frame.world;
  threshold_.observe(frame);
  if (frames_++ % stride_ == 0) {
    const Confidences& c = world.confidence;
    points_.push_back({world.time, c.current, c.opposite, c.raw_current, c.raw_opposite, c.evidence, world.room_status,
                       threshold_.value()});
  }
  if (points_.size() >= kMostPoints) {
    for (std::size_t i = 0; 2 * i < points_.size(); ++i) points_[i] = points_[2 * i];
    points_.resize((points_.size() + 1) / 2);
    stride_ *= 2;
  }
  note_condition(RunCondition::training, world.training, world.time);
  note_condition(RunCondition::evaluation_paused, !world.evaluating, world.time);
  note_condition(RunCondition::belief_reflected, scene.truth && is_correct(reflect(world.pose.pose), scene.truth->pose),
                 world.time);
  note_condition(RunCondition::lifted, world.posture == Posture::lifted, world.time);
  note_condition(RunCondition::down, is_down(world.posture), world.time);
  for (const CommandRecord& command : frame.commands) {
    if (commands_.size() >= kMostCommands) {
      commands_.erase(commands_.begin(), commands_.begin() + kMostCommands / 2);
      commands_left_out_ += kMostCommands / 2;
    }
    commands_.push_back({world.time, command.request.reorientation, command.verdict == Verdict::granted});
  }
  if (frame.reorientation) keep_snapshot(frame, scene);
}

void RunHistory::note_condition(RunCondition condition, bool holds, double time) {
  std::size_t& open = open_[static_cast<std::size_t>(condition)];
  if (!holds) {
    open = kClosed;
    return;
  }
  if (open == kClosed) {
    if (intervals_.size() >= kMostIntervals) join_intervals();
    open = intervals_.size();
    intervals_.push_back({condition, time, time});
  }
  intervals_[open].to = time;
}

/// Joins intervals until half of them are left, because gaps below the resolution of a picture are invisible.
void RunHistory::join_intervals() {
  const double duration = intervals_.back().to - intervals_.front().from;
  gap_ = std::max(2.0 * gap_, duration / 4000.0);
  while (true) {
    std::vector<ConditionInterval> joined;
    std::vector<std::size_t> last(kRunConditions, kClosed);
    for (const ConditionInterval& interval : intervals_) {
      std::size_t& before = last[static_cast<std::size_t>(interval.condition)];
      if (before != kClosed && interval.from - joined[before].to <= gap_) {
        joined[before].to = interval.to;
        continue;
      }
      before = joined.size();
      joined.push_back(interval);
    }
    for (std::size_t i = 0; i < open_.size(); ++i) open_[i] = open_[i] == kClosed ? kClosed : last[i];
    intervals_ = std::move(joined);
    if (intervals_.size() <= kMostIntervals / 2) return;
    gap_ *= 2.0;
  }
}

void RunHistory::keep_snapshot(const FrameRecord& frame, const SceneTruth& scene) {
  if (reorientations_.size() >= kMostReorientations) {
    ++reorientations_left_out_;
    return;
  }
  const ReorientationRecord& record = *frame.reorientation;
  reorientations_.push_back({frame.world.time, record.reorientation,
                             scene.truth ? std::optional<Pose2>(scene.truth->pose) : std::nullopt,
                             record.belief_before.pose, record.belief_after.pose, frame.pose_particles.before,
                             frame.pose_particles.particles});
}

}  // namespace reorient
