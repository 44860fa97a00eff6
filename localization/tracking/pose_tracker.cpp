#include "localization/tracking/pose_tracker.h"

#include <algorithm>
#include <cmath>

#include "geometry/field_landmarks.h"
#include "geometry/square.h"
#include "localization/tracking/tilt_geometry.h"

namespace reorient {
namespace {

constexpr std::size_t kMostLinePoints = 24;             // of one camera's image
constexpr double kIndependentOfImage = 8.0;             // points of one image share errors
constexpr double kOutlier = 3.5;                        // standard deviations
constexpr double kOwnFeet = 0.1;                        // m, what is nearer is the robot itself
constexpr double kLongestStep = 0.2;                    // s
constexpr double kKnownAfter = 5.0;                     // s, attached: what is learned of the angles then is believed
constexpr double kGoodFit = 0.6;                        // of the line points
constexpr double kLeastNoise = 0.02, kMostNoise = 4.0;  // of the parameters' variances
constexpr double kMostNormalized = 4.0;                 // of one image
constexpr double kFitTime = 1.0;                        // s
constexpr double kLeastFit = 0.5;                       // of the line points
constexpr double kMostBias = 0.35;                      // rad, 20 degrees: with more it is another camera
constexpr double kMostApart = 0.35;                     // m, of tracked pose and particles' mean, beside their spread
constexpr double kMostTurned = 0.3;                     // rad
constexpr double kLongestApart = 0.4;                   // s

}  // namespace

PoseTracker::PoseTracker(const PoseTrackerParameters& parameters, const FieldDimensions& field)
    : parameters_(parameters), lines_(field), posts_(goal_posts(field)) {
  reset_bias_covariance();
  known_covariance_ = covariance_;
}

void PoseTracker::reset_bias_covariance() {
  for (std::size_t i = kTorso; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) covariance_[i][j] = covariance_[j][i] = 0.0;
  }
  for (std::size_t i = kTorso; i < kMounts; ++i) covariance_[i][i] = square(parameters_.torso_deviation);
  for (std::size_t i = kMounts; i < kSway; ++i) covariance_[i][i] = square(parameters_.mount_deviation);
  for (std::size_t i = kSway; i < kSize; ++i) covariance_[i][i] = square(parameters_.sway_deviation);
}

void PoseTracker::forget_bias() { set_bias({}); }

void PoseTracker::set_bias(const CameraBias& bias) {
  put_bias(bias);
  if (bias.deviation > 0.0) know_sums(bias.deviation);
  known_mean_ = mean_;
  known_covariance_ = covariance_;
  attached_ = false;
}

void PoseTracker::put_bias(const CameraBias& bias) {
  mean_ = {};
  const auto put = [&](std::size_t at, const TiltBias& angles) {
    mean_[at] = angles.roll;
    mean_[at + 1] = angles.pitch;
  };
  put(kTorso, bias.torso);
  for (std::size_t i = 0; i < bias.mounts.size(); ++i) put(kMounts + 2 * i, bias.mounts[i]);
  reset_bias_covariance();
}

void PoseTracker::take_found(const TiltBias& torso, const std::array<TiltBias, 2>& mounts) {
  constexpr double kFoundDeviation = from_degrees(0.7);
  put_bias({torso, mounts, 0.0});
  know_sums(kFoundDeviation);
  attached_ = false;
}

/// How torso and mount share their sum is known less well.
void PoseTracker::know_sums(double deviation) {
  const Vector before = state();
  for (std::size_t mount = kMounts; mount < kSway; ++mount) {
    Measured sum;
    sum.row[mount] = 1.0;
    sum.row[kTorso + (mount - kMounts) % 2] = 1.0;
    sum.variance = square(deviation);
    take(sum, before);
  }
}

PoseTracker::Vector PoseTracker::state() const {
  Vector state = mean_;
  state[kX] = pose_.position.x();
  state[kY] = pose_.position.y();
  state[kRotation] = pose_.rotation;
  return state;
}

BiasPrior PoseTracker::prior() const {
  BiasPrior prior{bias(), 0.0, 0.0};
  if (!parameters_.enabled) return prior;
  // Where only the sum is known, both are known as well as that.
  const double usual = std::sqrt(square(parameters_.torso_deviation) + square(parameters_.mount_deviation));
  const double share = usual > 0.0 ? std::min(1.0, prior.mean.deviation / usual) : 0.0;
  prior.torso_deviation = share * parameters_.torso_deviation;
  prior.mount_deviation = share * parameters_.mount_deviation;
  return prior;
}

void PoseTracker::doubt() {
  constexpr double kKnock = from_degrees(0.5);
  for (std::size_t i = kTorso; i < kSway; ++i) known_covariance_[i][i] += square(kKnock);
  let_go();
}

void PoseTracker::let_go() {
  attached_ = false;
  mean_ = known_mean_;
  covariance_ = known_covariance_;
}

/// The longer the robot is lost, the more it may be that its angles are not what they were taken for.
void PoseTracker::widen_bias(double time) {
  constexpr double kPerSecond = from_degrees(0.5);
  for (std::size_t i = kTorso; i < kSway; ++i) {
    const double most = square(i < kMounts ? parameters_.torso_deviation : parameters_.mount_deviation);
    covariance_[i][i] = std::max(covariance_[i][i], std::min(most, covariance_[i][i] + square(kPerSecond) * time));
  }
}

void PoseTracker::flip() {
  pose_ = reflect(pose_);
  for (const std::size_t i : {kX, kY}) {
    for (std::size_t j = 0; j < kSize; ++j) {
      if (j == kX || j == kY) continue;
      covariance_[i][j] = -covariance_[i][j];
      covariance_[j][i] = -covariance_[j][i];
    }
  }
}

void PoseTracker::attach(const PoseBelief& believed) {
  attached_ = true;
  attached_for_ = apart_for_ = 0.0;
  fit_ = 1.0;
  constexpr double kMetresPerRadian = 5.0;  // by which a wrong attitude moves the particles, about
  const double attitude = bias().deviation;
  const double position = 0.03 + kMetresPerRadian * attitude, rotation = 0.02 + attitude;
  pose_ = believed.pose;
  for (std::size_t i = 0; i < kTorso; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) covariance_[i][j] = covariance_[j][i] = 0.0;
  }
  for (std::size_t i = 0; i < kTorso; ++i) {
    for (std::size_t j = 0; j < kTorso; ++j)
      covariance_[i][j] = believed.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j));
  }
  covariance_[kX][kX] += square(position);
  covariance_[kY][kY] += square(position);
  covariance_[kRotation][kRotation] += square(rotation);
}

void PoseTracker::predict(const Pose2& odometry_step, double time_step, const MotionModelParameters& motion) {
  const Pose2 step = believable_step(odometry_step);
  const double time = std::isfinite(time_step) ? std::clamp(time_step, 0.0, 1.0) : 0.0;
  const Pose2 next = pose_ * step;
  const Eigen::Vector2d way = next.position - pose_.position;
  pose_ = next;
  for (std::size_t j = 0; j < kSize; ++j) {
    covariance_[kX][j] -= way.y() * covariance_[kRotation][j];
    covariance_[kY][j] += way.x() * covariance_[kRotation][j];
  }
  for (std::size_t i = 0; i < kSize; ++i) {
    covariance_[i][kX] -= way.y() * covariance_[i][kRotation];
    covariance_[i][kY] += way.x() * covariance_[i][kRotation];
  }
  const StepNoise noise = step_noise(step, time, motion);
  covariance_[kX][kX] += square(noise.position);
  covariance_[kY][kY] += square(noise.position);
  covariance_[kRotation][kRotation] += square(noise.rotation);
  for (std::size_t i = kTorso; i < kSway; ++i) covariance_[i][i] += square(parameters_.drift) * time;
  if (!attached_) widen_bias(time);
  const double kept = pinned::exp(-time / parameters_.sway_time);
  for (std::size_t i = kSway; i < kSize; ++i) {
    mean_[i] *= kept;
    for (std::size_t j = 0; j < kSize; ++j) covariance_[i][j] *= kept;
    for (std::size_t j = 0; j < kSize; ++j) covariance_[j][i] *= kept;
    covariance_[i][i] += noise_ * square(parameters_.sway_deviation) * (1.0 - square(kept));
  }
}

bool PoseTracker::is_near(const PoseBelief& believed) const {
  const double spread = std::sqrt(std::max(0.0, believed.covariance(0, 0) + believed.covariance(1, 1)));
  return (believed.pose.position - pose_.position).norm() < kMostApart + spread &&
         std::abs(angle_difference(believed.pose.rotation, pose_.rotation)) < kMostTurned;
}

void PoseTracker::update(const std::array<CameraPercept, 2>& seen, const PoseBelief& believed, double time_step) {
  if (!parameters_.enabled) return;
  const double time = std::isfinite(time_step) ? std::clamp(time_step, 0.0, kLongestStep) : 0.0;
  if (!attached_) return;
  attached_for_ += time;
  apart_for_ = is_near(believed) ? 0.0 : apart_for_ + time;
  if (apart_for_ > kLongestApart || fit_ < kLeastFit) return let_go();
  // Errors last: frames that follow each other faster say less in proportion.
  const double weight = time < parameters_.sway_time ? time / parameters_.sway_time : 1.0;
  LineFit fit;
  for (std::size_t camera = 0; camera < seen.size(); ++camera) {
    if (seen[camera].percept != nullptr && weight > 0.0) see(seen[camera], camera, weight, fit);
  }
  if (fit.fitting + fit.odd > 0) {
    const double share = static_cast<double>(fit.fitting) / static_cast<double>(fit.fitting + fit.odd);
    fit_ += std::min(1.0, time / kFitTime) * (share - fit_);
  }
  if (fit.measured > 0) {
    const double normalized = std::min(fit.normalized_squares / fit.measured, kMostNormalized);
    noise_ = std::clamp(noise_ * (1.0 + time / parameters_.noise_time * (normalized - 1.0)), kLeastNoise, kMostNoise);
  }
  if (!is_sound(mean_, covariance_)) return forget_bias();
  if (attached_for_ > kKnownAfter && fit_ > kGoodFit) {
    known_mean_ = mean_;
    known_covariance_ = covariance_;
  }
}

PoseTracker::Vector PoseTracker::row_of(const Eigen::Vector2d& normal, const Eigen::Vector2d& point,
                                        const CameraPercept& seen, std::size_t camera) const {
  const TiltDerivative derivative = tilt_derivative(point, seen.robot_from_camera);
  const Eigen::Vector2d in_robot = rotated(normal, -pose_.rotation);
  const double roll = in_robot.dot(derivative.by_roll), pitch = in_robot.dot(derivative.by_pitch);
  Vector row{};
  row[kX] = normal.x();
  row[kY] = normal.y();
  row[kRotation] = cross(point, in_robot);
  row[kTorso] = row[kSway] = roll;
  row[kTorso + 1] = row[kSway + 1] = pitch;
  const Eigen::Vector2d axis = mount_axis(seen.robot_from_camera);
  row[kMounts + 2 * camera] = axis.x() * roll + axis.y() * pitch;
  row[kMounts + 2 * camera + 1] = axis.x() * pitch - axis.y() * roll;
  return row;
}

double PoseTracker::variance_of(const Vector& row) const {
  double variance = 0.0;
  for (std::size_t i = 0; i < kSize; ++i) {
    double sum = 0.0;
    for (std::size_t j = 0; j < kSize; ++j) sum += covariance_[i][j] * row[j];
    variance += row[i] * sum;
  }
  return variance;
}

/// One step of the filter. `before`: what the state was where the residual was computed.
void PoseTracker::take(const Measured& measured, const Vector& before) {
  Vector gain{};
  double variance = measured.variance;
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) gain[i] += covariance_[i][j] * measured.row[j];
    variance += measured.row[i] * gain[i];
  }
  const double rotation_step = angle_difference(pose_.rotation, before[kRotation]);
  double residual = measured.residual;
  residual += measured.row[kX] * (pose_.position.x() - before[kX]);
  residual += measured.row[kY] * (pose_.position.y() - before[kY]);
  residual += measured.row[kRotation] * rotation_step;
  for (std::size_t i = kTorso; i < kSize; ++i) residual += measured.row[i] * (mean_[i] - before[i]);
  const double inverse = 1.0 / variance;
  const double correction = -residual * inverse;
  pose_ = Pose2(pose_.position.x() + gain[kX] * correction, pose_.position.y() + gain[kY] * correction,
                pose_.rotation + gain[kRotation] * correction);
  for (std::size_t i = kTorso; i < kSize; ++i) mean_[i] += gain[i] * correction;
  for (std::size_t i = 0; i < kSize; ++i) {
    for (std::size_t j = 0; j < kSize; ++j) covariance_[i][j] -= gain[i] * gain[j] * inverse;
  }
}

void PoseTracker::see(const CameraPercept& seen, std::size_t camera, double weight, LineFit& fit) {
  see_lines(seen, camera, weight, fit);
  see_posts(seen, camera, weight);
}

void PoseTracker::see_lines(const CameraPercept& seen, std::size_t camera, double weight, LineFit& fit) {
  const std::vector<LinePoint>& points = seen.percept->line_points;
  const double height = std::max(seen.robot_from_camera.translation().z(), kLeastCameraHeight);
  std::array<Measured, kMostLinePoints> measured;
  std::size_t count = 0;
  const std::size_t every = (points.size() + kMostLinePoints - 1) / kMostLinePoints;
  for (std::size_t i = 0; i < points.size() && count < measured.size(); i += std::max<std::size_t>(1, every)) {
    const LinePoint& point = points[i];
    const double distance = point.position.norm();
    if (!(distance >= kOwnFeet && distance <= parameters_.farthest_line_point) || !std::isfinite(point.normal))
      continue;
    const Eigen::Vector2d place = pose_ * point.position;
    const Eigen::Vector2d direction = unit_vector(point.normal + 0.5 * kPi + pose_.rotation);
    const std::optional<NearestFieldLine> line = lines_.nearest(place, direction);
    if (!line) {
      ++fit.odd;
      continue;
    }
    Measured& one = measured[count];
    one.residual = line->distance;
    one.row = row_of(line->normal, point.position, seen, camera);
    const double along = std::abs(rotated(line->normal, -pose_.rotation).dot(point.position)) / distance;
    const double reach = along * (height + square(distance) / height) + (1.0 - along) * distance;
    one.variance = square(parameters_.line_deviation) + square(parameters_.pixel_deviation * reach);
    const double state_variance = variance_of(one.row);
    // By the parameters' noise, however little there is: what is too sure of itself must notice it.
    const double expected = std::sqrt(one.variance + state_variance);
    if (std::abs(one.residual) > kOutlier * expected) {
      ++fit.odd;
      continue;
    }
    ++fit.fitting;
    // Which of two lines it is must be known.
    if (line->next - std::abs(one.residual) < 2.0 * expected) continue;
    fit.normalized_squares += square(one.residual) / (noise_ * one.variance + state_variance);
    ++fit.measured;
    ++count;
  }
  const double shared = std::max(1.0, static_cast<double>(count) / kIndependentOfImage) / weight;
  const Vector before = state();
  for (std::size_t i = 0; i < count; ++i) {
    measured[i].variance *= noise_ * shared;
    take(measured[i], before);
  }
}

void PoseTracker::see_posts(const CameraPercept& seen, std::size_t camera, double weight) {
  constexpr double kFarthestPost = 10.0;  // m
  const double height = std::max(seen.robot_from_camera.translation().z(), kLeastCameraHeight);
  for (const GoalPost& post : seen.percept->goal_posts) {
    const double distance = post.position.norm();
    if (!(distance >= 3.0 * kOwnFeet && distance <= kFarthestPost)) continue;
    const Eigen::Vector2d place = pose_ * post.position;
    // The post of the field in about this direction; a second one as near would be a guess.
    const Eigen::Vector2d sight = (place - pose_.position) / distance;
    const Eigen::Vector2d across(-sight.y(), sight.x());
    const Vector before = state();
    const auto measure = [&](const Eigen::Vector2d& normal, const Eigen::Vector2d& from_post, double deviation) {
      Measured one;
      one.residual = normal.dot(from_post);
      one.row = row_of(normal, post.position, seen, camera);
      one.variance = square(parameters_.line_deviation) + square(deviation);
      return one;
    };
    const double along_deviation =
        post.base_visible ? parameters_.pixel_deviation * (height + square(distance) / height) : 0.5 * distance;
    std::optional<Measured> best_across, best_along;
    double best = kOutlier * kOutlier;
    int candidates = 0;
    for (const Eigen::Vector2d& known : posts_) {
      const Eigen::Vector2d from_post = place - known;
      const Measured aside = measure(across, from_post, 2.0 * parameters_.pixel_deviation * distance);
      const Measured along = measure(sight, from_post, along_deviation);
      const double far = square(aside.residual) / (aside.variance + variance_of(aside.row)) +
                         square(along.residual) / (along.variance + variance_of(along.row));
      if (far > kOutlier * kOutlier) continue;
      ++candidates;
      if (far >= best) continue;
      best = far;
      best_across = aside;
      best_along = along;
    }
    if (candidates != 1) continue;
    for (Measured* one : {&*best_across, &*best_along}) {
      one->variance *= noise_ / weight;
      take(*one, before);
    }
  }
}

PoseBelief PoseTracker::belief(const PoseBelief& believed) const {
  if (!is_attached()) return believed;
  PoseBelief belief = believed;
  belief.pose = pose_;
  for (std::size_t i = 0; i < kTorso; ++i) {
    for (std::size_t j = 0; j < kTorso; ++j)
      belief.covariance(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = covariance_[i][j];
  }
  return belief;
}

CameraBias PoseTracker::bias() const {
  if (!parameters_.enabled) return {};
  const auto angles = [this](std::size_t at) { return TiltBias{mean_[at], mean_[at + 1]}; };
  CameraBias bias{angles(kTorso), {angles(kMounts), angles(kMounts + 2)}, 0.0};
  const auto sum = [this](std::size_t i, std::size_t j) {
    return covariance_[i][i] + covariance_[j][j] + 2.0 * covariance_[i][j];
  };
  bias.deviation = std::sqrt(std::max(0.0, 0.5 * (sum(kTorso, kMounts) + sum(kTorso + 1, kMounts + 1))));
  return bias;
}

double PoseTracker::bias_deviation(const Isometry3& robot_from_camera, std::size_t camera) const {
  if (!parameters_.enabled) return 0.0;
  const Eigen::Vector2d axis = mount_axis(robot_from_camera);
  Vector row{};
  row[kTorso] = -axis.y();
  row[kTorso + 1] = axis.x();
  row[kMounts + 2 * camera + 1] = 1.0;
  return std::sqrt(std::max(0.0, variance_of(row)));
}

bool PoseTracker::is_sound(const Vector& mean, const Matrix& covariance) {
  for (std::size_t i = 0; i < kSize; ++i) {
    if (!(std::abs(mean[i]) <= kMostBias) || !(covariance[i][i] >= 0.0)) return false;
    for (const double value : covariance[i]) {
      if (!std::isfinite(value)) return false;
    }
  }
  return true;
}

/// After reading.
void PoseTracker::complete() {
  const bool is_pose = pose_.position.allFinite() && std::isfinite(pose_.rotation + attached_for_ + apart_for_ + fit_);
  check_bytes(is_pose && noise_ >= kLeastNoise && noise_ <= kMostNoise, "the tracked pose is none");
  check_bytes(is_sound(mean_, covariance_) && is_sound(known_mean_, known_covariance_), "the camera's bias is none");
}

}  // namespace reorient
