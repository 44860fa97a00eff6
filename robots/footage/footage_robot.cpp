// SPDX-License-Identifier: MIT
#include "robots/footage/footage_robot.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace reorient {
namespace {

constexpr double kPositionDeviation = 0.1;                // m, of the recorded poses
constexpr double kRotationDeviation = from_degrees(5.0);  // rad
constexpr double kBodyRate = 50.0;                        // Hz
constexpr int kMostBodySamples = 100;

/// Rounds to a resolution that is finer than any measurement. Then a pose is the same to the last bit, whether it was
/// recorded as decimal numbers, as a quaternion or as a matrix.
double rounded(double value) {
  constexpr double kSteps = 1 << 30;                 // per m, s, rad, pixel
  return std::round(value * kSteps) / kSteps + 0.0;  // + 0.0 removes the sign of -0.0
}
Pose2 rounded(const Pose2& pose) {
  return {rounded(pose.position.x()), rounded(pose.position.y()), rounded(pose.rotation)};
}
Isometry3 rounded(const Isometry3& pose) {
  Isometry3 result = pose;
  result.matrix() = pose.matrix().unaryExpr([](double value) { return rounded(value); });
  return result;
}

Eigen::Matrix3d belief_covariance() {
  const Eigen::Vector3d deviation(kPositionDeviation, kPositionDeviation, kRotationDeviation);
  return deviation.cwiseAbs2().asDiagonal();
}

}  // namespace

void FootageBelief::apply(const BeliefChange& change) {
  is_mirrored_ = change.mirrored;
  turned_by_ = change.turned_by;
  is_ambiguous_ = false;
}

void FootageBelief::apply(Reorientation reorientation) {
  switch (reorientation) {
    case Reorientation::flip_pose:
      is_mirrored_ = !is_mirrored_;
      break;
    case Reorientation::purge_reflection:
      is_ambiguous_ = false;
      break;
    case Reorientation::reset_orientation:
      is_ambiguous_ = true;
      break;
  }
}

Pose2 FootageBelief::of(const Pose2& recorded) const {
  const Pose2 turned(recorded.position, recorded.rotation + turned_by_);
  return is_mirrored_ ? reflect(turned) : turned;
}

FootageRobot::FootageRobot(std::unique_ptr<FootageSource> source, const FootageOptions& options)
    : source_(std::move(source)), options_(options) {
  body_samples_.reserve(kMostBodySamples);
  do {
    if (next_frame()) continue;
    throw BadFootage(failure_.empty() ? "expected more than " + std::to_string(options.skipped) +
                                            " images in the footage, found " + std::to_string(frames_)
                                      : failure_);
  } while (frames_ <= options.skipped);
  is_next_read_ = true;
}

/// False: the end of the footage, or an error (failure_).
bool FootageRobot::next_frame() {
  try {
    if (!failure_.empty() || is_over_) return false;
    is_over_ = !source_->next(frame_);
    if (is_over_) return false;
  } catch (const BadFootage& damage) {
    failure_ = damage.what();
    return false;
  }
  if (frames_ == 0) first_time_ = frame_.time;
  time_before_ = time_;
  time_ = rounded(options_.images_per_second ? static_cast<double>(frames_) / *options_.images_per_second
                                             : frame_.time - first_time_);
  if (frame_.pose) frame_.pose = rounded(*frame_.pose);
  if (frame_.odometry) frame_.odometry = rounded(*frame_.odometry);
  if (frame_.heading) frame_.heading = rounded(*frame_.heading);
  frame_.torso = {rounded(frame_.torso.roll), rounded(frame_.torso.pitch)};
  frame_.robot_from_camera = rounded(frame_.robot_from_camera);
  ++frames_;
  if (!frame_.pose && frame_.heading)
    frame_.pose = Pose2(options_.start ? options_.start->position : Eigen::Vector2d::Zero(), *frame_.heading);
  if (frame_.odometry) {
    odometry_ = *frame_.odometry;
  } else if (frame_.pose) {
    odometry_ = *frame_.pose;
  }
  truth_ = frame_.pose;
  return true;
}

bool FootageRobot::observe(Observation& observation) {
  if (!std::exchange(is_next_read_, false) && !next_frame()) return false;
  observation = {};
  observation.time = time_;
  observation.odometry = odometry_;
  const BeliefChange* const change = options_.change ? &*options_.change : nullptr;
  // A time from the command line has at most microseconds.
  const auto is_reached = [this](double moment) { return time_ > moment - 1e-6; };
  const bool is_due = change != nullptr && is_reached(change->at);
  is_carried_ = is_due && change->kind == BeliefChange::Kind::lifted && !is_reached(change->at + change->lifted_for);
  update_posture(observation);
  // A lifted robot does not change its belief until it is placed.
  if (is_due && !is_carried_ && !std::exchange(is_changed_, true)) {
    belief_.apply(*change);
    if (change->kind == BeliefChange::Kind::told && truth_)
      observation.external.initial_pose = InitialPose{belief_.of(*truth_)};
  }
  if (!std::exchange(is_started_, true) && !truth_ && options_.start)
    observation.external.initial_pose = InitialPose{*options_.start};
  report_belief(observation);
  if (is_carried_) return true;
  observation.upper = CameraFrame{.time = time_,
                                  .image = frame_.image.view(),
                                  .camera = frame_.camera,
                                  .odometry = odometry_,
                                  .robot_from_camera = frame_.robot_from_camera};
  return true;
}

/// Footage contains no load on the feet. So they have load unless the robot is lifted.
void FootageRobot::update_posture(Observation& observation) {
  BodySample sample;
  sample.torso = frame_.torso;
  if (is_carried_) sample.foot_load = 0.0;
  body_samples_.clear();
  const double gap = time_ - time_before_;
  const int samples = std::clamp(static_cast<int>(gap * kBodyRate), 0, kMostBodySamples);
  for (int i = samples; i > 0; --i) {
    sample.time = time_ - i / kBodyRate;
    if (sample.time > time_before_) body_samples_.push_back(sample);
  }
  sample.time = time_;
  observation.body = sample;
  observation.body_samples = body_samples_;
}

void FootageRobot::report_belief(Observation& observation) {
  if (!truth_) return;
  const Pose2 believed = belief_.of(*truth_);
  ExternalBelief& belief = observation.belief.emplace();
  belief.pose = believed;
  belief.covariance = belief_covariance();
  if (!belief_.is_ambiguous()) return;
  hypotheses_ = {{{believed, 1.0}, {reflect(believed), 1.0}}};
  belief.particles = hypotheses_;
}

void FootageRobot::answer(const Answer& answer) {
  if (answer.reorientation && truth_) belief_.apply(*answer.reorientation);
}

}  // namespace reorient
