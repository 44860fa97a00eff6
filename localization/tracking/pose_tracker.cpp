// SPDX-License-Identifier: MIT
#include "localization/tracking/pose_tracker.h"

#include <algorithm>
#include <cmath>

#include "geometry/field_landmarks.h"
#include "geometry/square.h"
#include "localization/tracking/tilt_geometry.h"

namespace reorient {
namespace {

constexpr std::size_t kTorso = PoseState::kTorso, kMounts = PoseState::kMounts, kSway = PoseState::kSway,
                      kSize = PoseState::kSize;

constexpr std::size_t kMostLinePoints = 24;             // of one camera's image
constexpr double kIndependentOfImage = 8.0;             // points of one image share errors
constexpr double kOutlier = 3.5;                        // standard deviations
constexpr double kOwnFeet = 0.1;                        // m; a nearer point is on the robot itself
constexpr double kLongestStep = 0.2;                    // s
constexpr double kKnownAfter = 5.0;                     // s of tracking that confirm the learned angles
constexpr double kGoodFit = 0.6;                        // of the line points
constexpr double kLeastNoise = 0.02, kMostNoise = 4.0;  // of the parameters' variances
constexpr double kMostNormalized = 4.0;                 // of one image
constexpr double kFitTime = 1.0;                        // s
constexpr double kLeastFit = 0.5;                       // of the line points
constexpr double kMostBias = 0.35;                      // rad, 20 degrees; a larger bias is impossible
constexpr double kMostApart = 0.35;                     // m, from the particles' mean, beyond their spread
constexpr double kMostTurned = 0.3;                     // rad
constexpr double kLongestApart = 0.4;                   // s

}  // namespace

PoseTracker::PoseTracker(const PoseTrackerParameters& parameters, const FieldDimensions& field)
    : parameters_(parameters), lines_(field), posts_(goal_posts(field)) {
  set_bias({});
}

void PoseTracker::set_bias(const CameraBias& bias) {
  take_bias(bias, bias.deviation);
  remember_bias();
}

void PoseTracker::take_found(const CameraBias& bias) {
  constexpr double kFoundDeviation = from_degrees(0.7);
  take_bias(bias, kFoundDeviation);
}

/// `deviation`: of the sums of torso and mounting, rad; 0: the sums are unknown. The single terms are known less well
/// than their sum.
void PoseTracker::take_bias(const CameraBias& bias, double deviation) {
  attached_ = false;
  const auto put = [&](std::size_t at, const TiltBias& angles) {
    state_.mean[at] = angles.roll;
    state_.mean[at + 1] = angles.pitch;
  };
  state_.mean = {};
  put(kTorso, bias.torso);
  for (std::size_t i = 0; i < bias.mounts.size(); ++i) put(kMounts + 2 * i, bias.mounts[i]);
  PoseState::Matrix& covariance = state_.covariance;
  for (std::size_t i = kTorso; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) covariance[i][j] = covariance[j][i] = 0.0;
  }
  for (std::size_t i = kTorso; i < kMounts; ++i) covariance[i][i] = square(parameters_.torso_deviation);
  for (std::size_t i = kMounts; i < kSway; ++i) covariance[i][i] = square(parameters_.mount_deviation);
  for (std::size_t i = kSway; i < kSize; ++i) covariance[i][i] = square(parameters_.sway_deviation);
  if (!(deviation > 0.0)) return;
  const PoseState::Vector before = state_.values();
  for (std::size_t mount = kMounts; mount < kSway; ++mount) {
    PoseState::Measurement sum;
    sum.row[mount] = 1.0;
    sum.row[kTorso + (mount - kMounts) % 2] = 1.0;
    sum.variance = square(deviation);
    state_.update(sum, before);
  }
}

void PoseTracker::take_gravity(const TiltBias& torso) {
  if (!(parameters_.gravity_deviation > 0.0)) return;
  const std::array estimated{torso.roll, torso.pitch};
  const auto correct = [&](PoseState& state) {
    const PoseState::Vector before = state.values();
    for (std::size_t i = 0; i < estimated.size(); ++i) {
      PoseState::Measurement measured;
      measured.residual = before[kTorso + i] - estimated[i];
      measured.row[kTorso + i] = 1.0;
      measured.variance = square(parameters_.gravity_deviation);
      state.update(measured, before);
    }
  };
  correct(state_);
  correct(known_);
}

void PoseTracker::remember_bias() { known_ = state_; }

BiasPrior PoseTracker::prior() const {
  BiasPrior prior{bias(), 0.0, 0.0};
  if (!parameters_.enabled) return prior;
  // Scales both deviations by how well their sum is known.
  const double usual = std::sqrt(square(parameters_.torso_deviation) + square(parameters_.mount_deviation));
  const double fraction = usual > 0.0 ? std::min(1.0, prior.mean.deviation / usual) : 0.0;
  prior.torso_deviation = fraction * parameters_.torso_deviation;
  prior.mount_deviation = fraction * parameters_.mount_deviation;
  return prior;
}

void PoseTracker::doubt() {
  constexpr double kKnock = from_degrees(0.5);
  for (std::size_t i = kTorso; i < kSway; ++i) known_.covariance[i][i] += square(kKnock);
  detach();
}

void PoseTracker::detach() {
  attached_ = false;
  state_.mean = known_.mean;
  state_.covariance = known_.covariance;
}

/// The longer the robot is lost, the less certain its former bias is.
void PoseTracker::widen_bias(double time) {
  constexpr double kPerSecond = from_degrees(0.5);
  for (std::size_t i = kTorso; i < kSway; ++i) {
    double& variance = state_.covariance[i][i];
    const double most = square(i < kMounts ? parameters_.torso_deviation : parameters_.mount_deviation);
    variance = std::max(variance, std::min(most, variance + square(kPerSecond) * time));
  }
}

void PoseTracker::attach(const PoseBelief& believed) {
  attached_ = true;
  attached_for_ = apart_for_ = 0.0;
  fit_ = 1.0;
  constexpr double kMetersPerRadian = 5.0;  // by which a wrong attitude moves the particles, roughly
  const double attitude = bias().deviation;
  const double position = 0.03 + kMetersPerRadian * attitude, rotation = 0.02 + attitude;
  state_.pose = believed.pose;
  PoseState::Matrix& covariance = state_.covariance;
  for (std::size_t i = 0; i < kTorso; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) covariance[i][j] = covariance[j][i] = 0.0;
  }
  for (std::size_t i = 0; i < kTorso; ++i) {
    for (std::size_t j = 0; j < kTorso; ++j)
      covariance[i][j] = believed.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  covariance[PoseState::kX][PoseState::kX] += square(position);
  covariance[PoseState::kY][PoseState::kY] += square(position);
  covariance[PoseState::kRotation][PoseState::kRotation] += square(rotation);
}

void PoseTracker::predict(const Pose2& odometry_step, double time_step, const MotionModelParameters& motion) {
  const double time = std::isfinite(time_step) ? std::clamp(time_step, 0.0, 1.0) : 0.0;
  state_.predict(believable_step(odometry_step), time, motion, square(parameters_.drift),
                 noise_ * square(parameters_.sway_deviation), parameters_.sway_time);
  if (!attached_) widen_bias(time);
}

bool PoseTracker::is_near(const PoseBelief& believed) const {
  const double spread = std::sqrt(std::max(0.0, believed.covariance(0, 0) + believed.covariance(1, 1)));
  return are_near(believed.pose, state_.pose, kMostApart + spread, kMostTurned);
}

void PoseTracker::update(const std::array<CameraPercept, 2>& seen, const PoseBelief& believed, double time_step) {
  if (!is_attached()) return;
  const double time = std::isfinite(time_step) ? std::clamp(time_step, 0.0, kLongestStep) : 0.0;
  attached_for_ += time;
  apart_for_ = is_near(believed) ? 0.0 : apart_for_ + time;
  if (apart_for_ > kLongestApart || fit_ < kLeastFit) return detach();
  // Errors last for some time, so frames at shorter intervals weigh proportionally less.
  const double weight = time < parameters_.sway_time ? time / parameters_.sway_time : 1.0;
  LineFit fit;
  for (std::size_t camera = 0; camera < seen.size(); ++camera) {
    if (seen[camera].percept == nullptr || weight <= 0.0) continue;
    see_lines(seen[camera], camera, weight, fit);
    see_posts(seen[camera], camera, weight);
  }
  if (fit.fitting + fit.odd > 0) {
    const double fraction = static_cast<double>(fit.fitting) / static_cast<double>(fit.fitting + fit.odd);
    fit_ += std::min(1.0, time / kFitTime) * (fraction - fit_);
  }
  if (fit.measured > 0) {
    const double normalized = std::min(fit.normalized_squares / fit.measured, kMostNormalized);
    noise_ = std::clamp(noise_ * (1.0 + time / parameters_.noise_time * (normalized - 1.0)), kLeastNoise, kMostNoise);
  }
  if (!is_sound(state_)) return set_bias({});
  if (attached_for_ > kKnownAfter && fit_ > kGoodFit) remember_bias();
}

void PoseTracker::see_lines(const CameraPercept& seen, std::size_t camera, double weight, LineFit& fit) {
  const std::vector<LinePoint>& points = seen.percept->line_points;
  std::array<PoseState::Measurement, kMostLinePoints> measured;
  std::size_t count = 0;
  const std::size_t every = (points.size() + kMostLinePoints - 1) / kMostLinePoints;
  for (std::size_t i = 0; i < points.size() && count < measured.size(); i += std::max<std::size_t>(1, every)) {
    const LinePoint& point = points[i];
    const double distance = point.position.norm();
    if (!(distance >= kOwnFeet && distance <= parameters_.farthest_line_point) || !std::isfinite(point.normal))
      continue;
    const Eigen::Vector2d place = state_.pose * point.position;
    const Eigen::Vector2d direction = unit_vector(point.normal + 0.5 * kPi + state_.pose.rotation);
    const std::optional<NearestFieldLine> line = lines_.nearest(place, direction);
    if (!line) {
      ++fit.odd;
      continue;
    }
    PoseState::Measurement& one = measured[count];
    one.residual = line->distance;
    one.row = state_.row_of(line->normal, point.position, seen.robot_from_camera, camera);
    const double reach =
        meters_per_radian(point.position, rotated(line->normal, -state_.pose.rotation), seen.robot_from_camera);
    one.variance = square(parameters_.line_deviation) + square(parameters_.pixel_deviation * reach);
    const double state_variance = state_.variance_of(one.row);
    // Uses the parameters' noise, not the learned one, so that an overconfident state still accepts correct points.
    const double expected = std::sqrt(one.variance + state_variance);
    if (std::abs(one.residual) > kOutlier * expected) {
      ++fit.odd;
      continue;
    }
    ++fit.fitting;
    // Skips a point that could belong to two lines.
    if (line->next - std::abs(one.residual) < 2.0 * expected) continue;
    fit.normalized_squares += square(one.residual) / (noise_ * one.variance + state_variance);
    ++fit.measured;
    ++count;
  }
  const double shared = std::max(1.0, static_cast<double>(count) / kIndependentOfImage) / weight;
  const PoseState::Vector before = state_.values();
  for (std::size_t i = 0; i < count; ++i) {
    measured[i].variance *= noise_ * shared;
    state_.update(measured[i], before);
  }
}

void PoseTracker::see_posts(const CameraPercept& seen, std::size_t camera, double weight) {
  constexpr double kFarthestPost = 10.0;  // m
  const double height = std::max(seen.robot_from_camera.translation().z(), kLeastCameraHeight);
  for (const GoalPost& post : seen.percept->goal_posts) {
    const double distance = post.position.norm();
    if (!(distance >= 3.0 * kOwnFeet && distance <= kFarthestPost)) continue;
    const Eigen::Vector2d place = state_.pose * post.position;
    // Uses the post only if exactly one post of the field fits.
    const Eigen::Vector2d sight = (place - state_.pose.position) / distance;
    const Eigen::Vector2d across(-sight.y(), sight.x());
    const PoseState::Vector before = state_.values();
    const auto measure = [&](const Eigen::Vector2d& normal, const Eigen::Vector2d& from_post, double deviation) {
      PoseState::Measurement one;
      one.residual = normal.dot(from_post);
      one.row = state_.row_of(normal, post.position, seen.robot_from_camera, camera);
      one.variance = square(parameters_.line_deviation) + square(deviation);
      return one;
    };
    const double along_deviation =
        post.base_visible ? parameters_.pixel_deviation * (height + square(distance) / height) : 0.5 * distance;
    std::optional<PoseState::Measurement> best_across, best_along;
    double best = kOutlier * kOutlier;
    int candidates = 0;
    for (const Eigen::Vector2d& known : posts_) {
      const Eigen::Vector2d from_post = place - known;
      const PoseState::Measurement aside = measure(across, from_post, 2.0 * parameters_.pixel_deviation * distance);
      const PoseState::Measurement along = measure(sight, from_post, along_deviation);
      const double far = square(aside.residual) / (aside.variance + state_.variance_of(aside.row)) +
                         square(along.residual) / (along.variance + state_.variance_of(along.row));
      if (far > kOutlier * kOutlier) continue;
      ++candidates;
      if (far >= best) continue;
      best = far;
      best_across = aside;
      best_along = along;
    }
    if (candidates != 1) continue;
    for (PoseState::Measurement* one : {&*best_across, &*best_along}) {
      one->variance *= noise_ / weight;
      state_.update(*one, before);
    }
  }
}

PoseBelief PoseTracker::belief(const PoseBelief& believed) const {
  if (!is_attached()) return believed;
  PoseBelief belief = believed;
  belief.pose = state_.pose;
  for (std::size_t i = 0; i < kTorso; ++i) {
    for (std::size_t j = 0; j < kTorso; ++j)
      belief.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = state_.covariance[i][j];
  }
  return belief;
}

CameraBias PoseTracker::bias() const {
  if (!parameters_.enabled) return {};
  const auto angles = [this](std::size_t at) { return TiltBias{state_.mean[at], state_.mean[at + 1]}; };
  CameraBias bias{angles(kTorso), {angles(kMounts), angles(kMounts + 2)}, 0.0};
  const auto sum = [&covariance = state_.covariance](std::size_t i, std::size_t j) {
    return covariance[i][i] + covariance[j][j] + 2.0 * covariance[i][j];
  };
  bias.deviation = std::sqrt(std::max(0.0, 0.5 * (sum(kTorso, kMounts) + sum(kTorso + 1, kMounts + 1))));
  return bias;
}

double PoseTracker::bias_deviation(const Isometry3& robot_from_camera, std::size_t camera) const {
  if (!parameters_.enabled) return 0.0;
  const Eigen::Vector2d axis = mount_axis(robot_from_camera);
  PoseState::Vector row{};
  row[kTorso] = -axis.y();
  row[kTorso + 1] = axis.x();
  row[kMounts + 2 * camera + 1] = 1.0;
  return std::sqrt(std::max(0.0, state_.variance_of(row)));
}

/// Whether the biases are possible.
bool PoseTracker::is_sound(const PoseState& state) {
  for (std::size_t i = 0; i < kSize; ++i) {
    if (!(std::abs(state.mean[i]) <= kMostBias) || !(state.covariance[i][i] >= 0.0)) return false;
    for (const double value : state.covariance[i]) {
      if (!std::isfinite(value)) return false;
    }
  }
  return true;
}

/// Checks the state after reading.
void PoseTracker::complete() {
  const Pose2& pose = state_.pose;
  const bool is_pose = pose.position.allFinite() && std::isfinite(pose.rotation + attached_for_ + apart_for_ + fit_);
  check_bytes(is_pose && noise_ >= kLeastNoise && noise_ <= kMostNoise,
              "pose tracker: the pose, a time or the noise is invalid");
  check_bytes(is_sound(state_) && is_sound(known_), "pose tracker: the camera's bias is invalid");
}

}  // namespace reorient
