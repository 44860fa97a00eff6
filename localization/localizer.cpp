// SPDX-License-Identifier: MIT
#include "localization/localizer.h"

#include <algorithm>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

/// Assumed probability that a pose that is not tracked is wrong. With one half, 96 to 99 % of the true poses of robots
/// that were placed anywhere were within the 95 % region of their belief (docs/evidence/localization.md).
constexpr double kUntrackedIsWrong = 0.5;
/// The same for a pose that the search has just found. Each second in which the field is in view decreases it.
constexpr double kFoundIsWrong = 0.05;
constexpr double kConfirmed = 2.0;    // s, time constant
constexpr double kLeastDoubt = 1e-6;  // a smaller one is ignored

}  // namespace

Localizer::Localizer(const LocalizerParameters& parameters, const FieldDimensions& field, std::uint64_t seed)
    : parameters_(parameters),
      field_size_(field.length, field.width),
      lines_(field),
      filter_(parameters.filter, field, seed),
      tracker_(parameters.tracker, field),
      search_(parameters.search, field, seed) {}

void Localizer::set_parameters(const LocalizerParameters& parameters) {
  parameters_ = parameters;
  filter_.set_parameters(parameters.filter);
  tracker_.set_parameters(parameters.tracker);
  search_.set_parameters(parameters.search);
}

void Localizer::set_initial_pose(const Pose2& pose, double position_deviation, double rotation_deviation) {
  filter_.set_initial_pose(pose, position_deviation, rotation_deviation);
  tracker_.attach(filter_.belief());
  doubt_ = 0.0;
}

void Localizer::continue_from(const PoseBelief& believed) {
  constexpr double kLeastPosition = 0.1, kMostPosition = 2.0;  // m
  const double least_rotation = from_degrees(5.0);
  const Eigen::Vector3d deviation = believed.covariance.diagonal().cwiseMax(0.0).cwiseSqrt();
  filter_.set_initial_pose(believed.pose, std::clamp(deviation.head<2>().maxCoeff(), kLeastPosition, kMostPosition),
                           std::clamp(deviation.z(), least_rotation, kPi));
  tracker_.detach();
}

void Localizer::feel_gravity(bool upright, const Eigen::Vector3d& acceleration, const TorsoAttitude& torso,
                             double time) {
  if (!upright) return gravity_.interrupt();
  if (const auto bias = gravity_.add_sample(acceleration, torso, time)) tracker_.take_gravity(*bias);
}

void Localizer::doubt(double time) {
  filter_.doubt();
  tracker_.doubt();
  search_.forget_before(time);
}

SensedBelief Localizer::update(const LocalizerInputs& inputs) {
  filter_.predict(inputs.odometry_step, inputs.time_step);
  tracker_.predict(inputs.odometry_step, inputs.time_step, parameters_.filter.motion);
  const FieldPercept nothing;
  const auto [upper, lower] = inputs.seen;
  const FieldPercept& above = upper.percept != nullptr ? *upper.percept : nothing;
  const FieldPercept& below = lower.percept != nullptr ? *lower.percept : nothing;
  filter_.update(above, below, inputs.goal, inputs.view, bias_deviation(inputs.seen));
  search(inputs);
  tracker_.update(inputs.seen, filter_.belief(), inputs.time_step);
  const bool sees_field = above.has_landmarks() || below.has_landmarks();
  SensedBelief sensed{belief(), is_pose_known()};
  if (!sensed.tracked) {
    doubt_ = kUntrackedIsWrong;
  } else if (sees_field && inputs.time_step > 0.0) {
    doubt_ *= pinned::exp(-inputs.time_step / kConfirmed);
    if (doubt_ < kLeastDoubt) doubt_ = 0.0;
  }
  sensed.belief.covariance = doubted_covariance(sensed.belief, doubt_, field_size_);
  if (inputs.upright && !sees_field && expects_lines(inputs.seen)) filter_.see_nothing(inputs.time_step);
  sensed.recovery_probability = filter_.recovery().recovery_probability(parameters_.filter.injection.lost_margin);
  return sensed;
}

/// Standard deviation of the tilt of the less certain camera, rad.
double Localizer::bias_deviation(const std::array<CameraPercept, 2>& seen) const {
  double deviation = 0.0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (seen[i].percept != nullptr)
      deviation = std::max(deviation, tracker_.bias_deviation(seen[i].robot_from_camera, i));
  }
  return deviation;
}

/// Whether lines would be in view if the believed pose was right. They would be if its reflection was, too.
bool Localizer::expects_lines(const std::array<CameraPercept, 2>& seen) const {
  constexpr double kFarthest = 3.0;     // m; small images show lines up to there
  constexpr double kLeastLength = 1.0;  // m; shorter ones are easily hidden
  const Pose2 believed = belief().pose;
  return std::any_of(seen.begin(), seen.end(), [&](const CameraPercept& one) {
    return one.percept != nullptr && one.camera != nullptr &&
           lines_.length_in_view(believed, *one.camera, one.robot_from_camera, kFarthest) >= kLeastLength;
  });
}

/// Whether the pose or its reflection is known.
bool Localizer::is_pose_known() const {
  return parameters_.tracker.enabled ? tracker_.is_attached() : !filter_.is_lost();
}

/// While the pose is unknown, matches the percepts of the last seconds with the field.
void Localizer::search(const LocalizerInputs& inputs) {
  constexpr double kNoticedAfter = 1.0;  // s
  const CameraBias bias = tracker_.bias();
  for (std::size_t i = 0; i < inputs.seen.size(); ++i) {
    const CameraPercept& seen = inputs.seen[i];
    if (seen.percept != nullptr)
      search_.see(*seen.percept, i, seen.robot_from_camera, bias_of(bias, i, seen.robot_from_camera), inputs.odometry,
                  inputs.time);
  }
  if (filter_.is_lost() && tracker_.is_attached()) tracker_.detach();
  const bool is_known = is_pose_known();
  if (!is_known && was_known_) search_.forget_before(inputs.time - kNoticedAfter);
  was_known_ = is_known;
  if (is_known || !inputs.upright) return search_.stop();
  const std::optional<PoseHypothesis> found =
      search_.search(filter_.map(), tracker_.prior(), inputs.odometry, filter_.belief().pose);
  if (!found) return;
  filter_.take_found(found->field_from_odometry * inputs.odometry, inputs.view);
  tracker_.take_found(found->bias);
  tracker_.attach(filter_.belief());
  doubt_ = kFoundIsWrong;
}

void Localizer::flip_pose() {
  filter_.flip_pose();
  tracker_.flip();
}

void Localizer::reset_orientation() {
  filter_.reset_orientation();
  tracker_.detach();
}

}  // namespace reorient
