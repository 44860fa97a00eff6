// SPDX-License-Identifier: MIT
#include "perception/room/room_awareness.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "geometry/bytes.h"
#include "geometry/transform.h"
#include "perception/room/view/azimuth.h"

namespace reorient {
namespace {

constexpr double kFirstStep = 1.0 / 30.0;  // s

}  // namespace

Comparison comparison_of(const RoomParameters& parameters) {
  Comparison comparison;
  comparison.measure = parameters.distance.measure;
  comparison.cap = parameters.distance.cap;
  comparison.trusted_after = parameters.background.trusted_after;
  return comparison;
}

double evidence_weight(const RoomParameters& parameters, const Separability& separability) {
  return parameters.evidence.use_separability ? separability.weight() : 1.0;
}

RoomAwareness::RoomAwareness(const RoomParameters& parameters, std::uint64_t seed)
    : parameters_(parameters), wall_(parameters.wall), filter_(seed) {
  forget();
}

const Confidences& RoomAwareness::update(const RoomObservation& view) {
  const double elapsed = seconds_since_last(view.time);
  const double step = std::min(elapsed, kLongestLook);
  perceive(view, elapsed);
  if (view.train) train(step);
  compared_model_.prepare(model_, wall_, comparison_of(parameters_));
  separability_.observe(compared_model_, wall_);
  scores_.clear();
  if (view.evaluate) evaluate(view, step);
  confidences_.coverage = compared_model_.coverage();
  confidences_.paired = compared_model_.paired();
  confidences_.distinctiveness = compared_model_.distinctiveness();
  confidences_.separability = separability_.probability();
  views_.choose(wall_, compared_model_, view.belief, view.robot_from_camera, step, parameters_.perception.min_incidence,
                parameters_.views);
  return confidences_;
}

double RoomAwareness::seconds_since_last(double time) {
  if (!std::isfinite(time)) return 0.0;
  const double elapsed = last_time_ ? std::max(time - *last_time_, 0.0) : kFirstStep;
  last_time_ = time;
  return elapsed;
}

void RoomAwareness::perceive(const RoomObservation& view, double elapsed) {
  perceived_.find(view, wall_, parameters_.perception);
  light_.observe(perceived_.light(view.image, parameters_.light, parameters_.perception), elapsed, parameters_.light);
  const Light mean = parameters_.light.enabled ? light_.light() : Light{};
  believed_light_ = mean;
  Light reflected_light = mean;
  if (parameters_.light.enabled && parameters_.pose_light.enabled) {
    pose_lights_.observe(perceived_.lights(), mean, model_, wall_, elapsed, parameters_.pose_light);
    believed_light_ = pose_lights_.if_believed();
    reflected_light = pose_lights_.if_reflected();
  }
  perceived_.count(view.image, color_thresholds(parameters_.color, believed_light_),
                   color_thresholds(parameters_.color, reflected_light), parameters_.perception);
  if (parameters_.color.blur > 0.0) perceived_.blur(parameters_.color.blur);
  const auto tiles = perceived_.tiles();
  confidences_.visible_tiles = static_cast<int>(
      std::count_if(tiles.begin(), tiles.end(), [](const PerceivedTile& tile) { return tile.counts; }));
}

void RoomAwareness::train(double step) {
  if (step <= 0.0) return;
  const BackgroundParameters& background = parameters_.background;
  TrainingStep how;
  how.step = step;
  how.n = background.time_constant / step;
  how.true_mean_start = background.true_mean_start;
  how.prior_variance = background.prior_deviation * background.prior_deviation;
  double misfit = 0.0;
  int known = 0;
  for (const PerceivedTile& tile : perceived_.tiles()) {
    if (!tile.counts || tile.coverage() < parameters_.perception.min_learned_coverage) continue;
    const TileModel& learned = model_[tile.tile];
    if (learned.is_trained_for(background.trusted_after)) {
      misfit += distance(Distance::hellinger, tile.histogram, learned.mean);
      ++known;
    }
    model_.train(tile.tile, tile.histogram, how);
  }
  if (known > 0) separability_.note_misfit(misfit / known, step);
  for (const TileLight& tile : perceived_.lights()) {
    if (tile.counts()) model_.train_light(tile.tile, relative(tile.sums.mean(), believed_light_), how);
  }
}

void RoomAwareness::evaluate(const RoomObservation& view, double step) {
  view_center_ = view_center(wall_, view.belief, view.robot_from_camera);
  if (view_center_) view_center_ = to_azimuth(*view_center_);
  if (!view_center_ || !std::isfinite(view.odometry_rotation)) return;
  filter_.predict(turn_since_last(view), step, parameters_.view_filter);
  scores_.compute(perceived_.tiles(), compared_model_, wall_, comparison_of(parameters_),
                  tolerated_columns(parameters_.evidence, wall_));
  filter_.correct(scores_, *view_center_, step, parameters_.view_filter);
  filter_.find_clusters();
  take_shares(confidences_, filter_, *view_center_, parameters_.confidence);
  evidence_.observe(scores_.places(), compared_model_, step, parameters_.evidence);
  take_evidence();
  if (step <= 0.0) return;
  if (!scores_.places().empty()) confidences_.age += step;
  if (!scores_.evidence()) return;
  confidences_.smoothed_for += step;
  smooth(confidences_, smoothing_share(parameters_.confidence, step, confidences_.smoothed_for));
}

/// Movement of the view center along the wall due to rotations of head and body, linearized at the current view center.
/// Jumps of the belief do not count.
double RoomAwareness::turn_since_last(const RoomObservation& view) {
  const Eigen::Vector3d axis = view.robot_from_camera.linear().col(0);
  const double yaw = direction_of(axis.head<2>());
  const double direction = yaw + view.odometry_rotation;
  const double turn = last_direction_ ? angle_difference(direction, *last_direction_) : 0.0;
  last_direction_ = direction;
  const Eigen::Vector2d camera = view.belief * Eigen::Vector2d(view.robot_from_camera.translation().head<2>());
  const auto before = wall_.azimuth_seen(camera, view.belief.rotation + yaw - turn);
  return before ? angle_difference(*view_center_, *before) : turn;
}

void RoomAwareness::on_flip() {
  flip(confidences_);
  reflect_evidence();
}

void RoomAwareness::reflect_evidence() {
  evidence_.reflect(wall_);
  pose_lights_.reflect(wall_);
  views_.rotate_by_180_degrees();
  take_evidence();
}

void RoomAwareness::take_evidence() {
  confidences_.evidence = evidence_weight(parameters_, separability_) * evidence_.log_odds();
}

void RoomAwareness::tile_evidence(std::vector<double>& log_odds) const {
  if (compared_model_.is_empty()) {  // after the axes were rotated or a state was read, until the next view
    ComparedModel compared;
    compared.prepare(model_, wall_, comparison_of(parameters_));
    evidence_.contributions(compared, parameters_.evidence, log_odds);
  } else {
    evidence_.contributions(compared_model_, parameters_.evidence, log_odds);
  }
  const double weight = evidence_weight(parameters_, separability_);
  for (double& value : log_odds) value *= weight;
}

void RoomAwareness::restart_evidence() {
  evidence_.restart(wall_.tiles());
  pose_lights_.restart(wall_.tiles());
  views_.restart(wall_.columns());
  take_evidence();
}

void RoomAwareness::on_purge() {
  if (parameters_.confidence.restart_on_purge) reorient::restart(confidences_);
}

void RoomAwareness::on_reset() {
  reset(confidences_);
  restart_evidence();
}

void RoomAwareness::restart() {
  clear_views(confidences_);
  restart_evidence();
  filter_.spread(parameters_.view_filter);
  last_direction_.reset();
}

void RoomAwareness::rotate_by_180_degrees() {
  model_.rotate_by_180_degrees(wall_);
  compared_model_.clear();
  separability_.rotate_by_180_degrees();
  light_.rotate_by_180_degrees(wall_);
  pose_lights_.rotate_by_180_degrees(wall_);
  evidence_.rotate_by_180_degrees(wall_);
  views_.rotate_by_180_degrees();
  filter_.rotate_by_180_degrees();
  std::swap(confidences_.goal_own, confidences_.goal_opponent);
  if (view_center_) view_center_ = opposite(*view_center_);
}

void RoomAwareness::forget() {
  model_.forget(wall_.tiles());
  compared_model_.clear();
  separability_.restart(wall_.columns());
  scores_.clear();
  perceived_.clear();
  filter_.spread(parameters_.view_filter);
  filter_.find_clusters();
  confidences_ = {};
  restart_evidence();
  light_.restart(wall_.tiles());
  last_time_.reset();
  last_direction_.reset();
  view_center_.reset();
}

ModelBasis RoomAwareness::basis() const {
  return {wall_.parameters(), parameters_.color, parameters_.light.enabled, parameters_.pose_light.enabled};
}

void RoomAwareness::take_model(const SavedModel& saved) {
  const std::string different = differences(basis(), saved.basis);
  if (!different.empty()) throw UnfitModel("it was learned with other parameters: " + different);
  forget();
  model_ = saved.model;
}

bool RoomAwareness::set_parameters(const RoomParameters& parameters) {
  const ModelBasis before = basis();
  parameters_ = parameters;
  wall_ = Wall(parameters.wall);
  if (!differences(before, basis()).empty()) {
    forget();
    return true;
  }
  if (!filter_.is_made_for(parameters_.view_filter)) filter_.spread(parameters_.view_filter);
  return false;
}

/// Checks values after reading.
void RoomAwareness::complete() {
  for (const std::optional<double>& value : {last_time_, last_direction_, view_center_})
    check_bytes(!value || std::isfinite(*value), "room awareness: a time or an angle is not finite");
  fields(
      [](const auto&... values) {
        check_bytes((... && std::isfinite(static_cast<double>(values))), "room awareness: a confidence is not finite");
      },
      confidences_);
  check_bytes(confidences_.age >= 0.0 && confidences_.smoothed_for >= 0.0,
              "room awareness: a time is negative or not a number");
  compared_model_.clear();
  perceived_.clear();
  scores_.clear();
}

}  // namespace reorient
