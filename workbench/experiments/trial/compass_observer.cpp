// SPDX-License-Identifier: MIT
#include "workbench/experiments/trial/compass_observer.h"

#include "engine/covered_areas.h"
#include "workbench/run/run_summary.h"

namespace reorient {
namespace {

constexpr double kSettle = 5.0;          // s of the new light before it counts
constexpr double kLookTolerance = 1e-6;  // s: frame times are sums of rounded steps

}  // namespace

CompassObserver::CompassObserver(const CompassParameters& parameters, const TrialObserver& trial, std::uint64_t seed)
    : trial_(trial), comparison_(parameters.comparison), right_(make_compasses(parameters, seed)) {}

void CompassObserver::observe(const FrameRecord& frame, const SceneTruth& scene) {
  const World& world = frame.world;
  const bool stands = scene.truth && !scene.truth->carried && world.upright();
  const std::optional<Pose2> pose = stands ? right_pose(world.pose.pose, scene.truth->pose) : std::nullopt;
  is_looking_ = is_looking_ && pose;
  if (!pose || !frame.inputs.upper) return;
  collect_covered(frame.percepts[0], covered_);
  view_.time = world.time;
  view_.image = frame.images.upper;
  view_.camera = frame.inputs.upper->camera;
  view_.robot_from_camera = frame.inputs.upper->robot_from_camera;
  view_.belief = *pose;
  view_.odometry_rotation = frame.inputs.odometry.rotation;
  view_.covered = covered_;
  if (trial_.result().started) return compare(trial_.result().seconds);
  learn();
}

/// The belief if it is right; after the start of the clock also its reflection, if that is right.
std::optional<Pose2> CompassObserver::right_pose(const Pose2& belief, const Pose2& truth) const {
  if (is_correct(belief, truth)) return belief;
  if (trial_.result().started && is_correct(reflect(belief), truth)) return reflect(belief);
  return std::nullopt;
}

void CompassObserver::learn() {
  if (!learning_began_) learning_began_ = view_.time;
  const bool is_mirrored = view_.time - *learning_began_ < comparison_.learn_mirrored;
  if (is_mirrored) view_.belief = reflect(view_.belief);
  for (const auto& compass : right_) compass->learn(view_);
}

void CompassObserver::compare(double time) {
  if (reflected_.empty()) {
    for (const auto& compass : right_) reflected_.push_back(compass->clone());
    begin_look(time);
    is_looking_ = false;
  }
  const bool is_over = next_time_ == kLookTimes.size() || !is_looking_;
  if (is_over && time + kLookTolerance >= kSettle) begin_look(time);
  const double looked_for = time - look_began_ + kLookTolerance - comparison_.mirrored_after;
  const bool counts = looked_for >= 0.0;
  RoomObservation reflection = view_;
  if (counts) reflection.belief = reflect(view_.belief);
  const bool is_asked = is_looking_ && looked_for >= kLookTimes[next_time_];
  for (std::size_t i = 0; i < right_.size(); ++i) {
    const double if_right = right_[i]->compare(view_);
    const double if_reflected = reflected_[i]->compare(reflection);
    flips_[i].if_right |= counts && right_[i]->wants_flip().value_or(false);
    flips_[i].if_reflected |= counts && reflected_[i]->wants_flip().value_or(false);
    if (!is_asked) continue;
    look_[i].if_right[next_time_] = if_right;
    look_[i].if_reflected[next_time_] = if_reflected;
    look_[i].flips_if_right[next_time_] = flips_[i].if_right ? 1.0 : 0.0;
    look_[i].flips_if_reflected[next_time_] = flips_[i].if_reflected ? 1.0 : 0.0;
  }
  if (is_asked && ++next_time_ == kLookTimes.size()) looks_.push_back(look_);
}

void CompassObserver::begin_look(double time) {
  for (const Compasses* compasses : {&right_, &reflected_}) {
    for (const auto& compass : *compasses) compass->begin();
  }
  flips_ = {};
  next_time_ = 0;
  look_began_ = time;
  is_looking_ = true;
}

}  // namespace reorient
