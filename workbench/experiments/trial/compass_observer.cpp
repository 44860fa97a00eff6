#include "workbench/experiments/trial/compass_observer.h"

#include "engine/covered_areas.h"
#include "workbench/run/run_summary.h"

namespace reorient {
namespace {

constexpr double kSettle = 5.0;          // s of the new light before it counts
constexpr double kLookTolerance = 1e-6;  // s: frame times are sums of rounded steps

}  // namespace

CompassObserver::CompassObserver(const CompassParameters& parameters, const TrialObserver& trial, std::uint64_t seed)
    : trial_(trial), right_(make_compasses(parameters, seed)) {}

void CompassObserver::observe(const FrameRecord& frame, const StageRecord& stage) {
  const World& world = frame.world;
  const bool is_right =
      stage.truth && !stage.truth->carried && world.upright() && is_correct(world.pose.pose, stage.truth->pose);
  is_looking_ = is_looking_ && is_right;
  if (!is_right || !frame.inputs.upper) return;
  collect_covered(frame.percepts[0], covered_);
  view_.time = world.time;
  view_.image = frame.images.upper;
  view_.camera = frame.inputs.upper->camera;
  view_.robot_from_camera = frame.inputs.upper->robot_from_camera;
  view_.belief = world.pose.pose;
  view_.odometry_rotation = frame.inputs.odometry.rotation;
  view_.covered = covered_;
  if (trial_.result().started) return compare(trial_.result().seconds);
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
  RoomObservation reflection = view_;
  reflection.belief = reflect(view_.belief);
  const bool is_asked = is_looking_ && time - look_began_ + kLookTolerance >= kLookTimes[next_time_];
  for (std::size_t i = 0; i < right_.size(); ++i) {
    const double if_right = right_[i]->compare(view_);
    const double if_reflected = reflected_[i]->compare(reflection);
    if (!is_asked) continue;
    look_[i].if_right[next_time_] = if_right;
    look_[i].if_reflected[next_time_] = if_reflected;
  }
  if (is_asked && ++next_time_ == kLookTimes.size()) looks_.push_back(look_);
}

void CompassObserver::begin_look(double time) {
  for (const Compasses* compasses : {&right_, &reflected_}) {
    for (const auto& compass : *compasses) compass->begin();
  }
  next_time_ = 0;
  look_began_ = time;
  is_looking_ = true;
}

}  // namespace reorient
