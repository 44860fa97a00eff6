#include "perception/room/room_awareness.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/bytes.h"
#include "geometry/transform.h"

namespace reorient {
namespace {

constexpr double kFirstStep = 1.0 / 30.0;  // s
constexpr double kLongestStep = 0.2;       // s; a longer gap is not time in which anything was seen

bool same(const ColorParameters& a, const ColorParameters& b) {
  return a.dark_below == b.dark_below && a.bright_above == b.bright_above && a.grey_within == b.grey_within &&
         a.blur == b.blur;
}

}  // namespace

RoomAwareness::RoomAwareness(const RoomParameters& parameters, std::uint64_t seed)
    : parameters_(parameters), wall_(parameters.wall), filter_(seed) {
  forget();
}

const Confidences& RoomAwareness::update(const RoomObservation& view) {
  const double elapsed = seconds_since_last(view.time);
  const double step = std::min(elapsed, kLongestStep);
  perceive(view, elapsed);
  if (view.train) train(step);
  compared_model_.prepare(model_, comparison());
  if (view.evaluate) evaluate(view, step);
  confidences_.coverage = compared_model_.coverage();
  confidences_.distinctiveness = distinctiveness(model_, compared_model_, wall_);
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
  const Light light = is_paper() ? Light{} : light_.light();
  perceived_.count(view.image, color_thresholds(parameters_.color, light), parameters_.perception);
  if (is_paper()) perceived_.blur(parameters_.color.blur);
  const auto tiles = perceived_.tiles();
  confidences_.visible_tiles = static_cast<int>(
      std::count_if(tiles.begin(), tiles.end(), [](const PerceivedTile& tile) { return tile.counts; }));
}

void RoomAwareness::train(double step) {
  if (step <= 0.0) return;
  const BackgroundParameters& background = parameters_.background;
  TrainingStep how;
  how.step = step;
  how.n = is_paper() ? background.frames : background.time_constant / step;
  how.true_mean_start = !is_paper();
  how.prior_variance = is_paper() ? 0.0 : background.prior_deviation * background.prior_deviation;
  for (const PerceivedTile& tile : perceived_.tiles()) {
    if (tile.counts) model_.train(tile.tile, tile.histogram, how);
  }
}

void RoomAwareness::evaluate(const RoomObservation& view, double step) {
  view_center_ = view_center(wall_, view.belief, view.robot_from_camera);
  if (!view_center_ || !std::isfinite(view.odometry_rotation)) return;
  filter_.predict(turn_since_last(view), step, parameters_.view_filter);
  scores_.compute(perceived_.tiles(), compared_model_, wall_, comparison());
  filter_.correct(scores_, *view_center_, step, correction());
  filter_.find_clusters();
  const double share = step > 0.0 ? smoothing_share(parameters_.confidence, step, is_paper()) : 0.0;
  update_confidences(confidences_, filter_, *view_center_, share, parameters_.confidence);
  confidences_.evidence = updated_evidence(confidences_.evidence, scores_, step, parameters_.evidence);
}

/// How far the view centre moved along the wall because head and body turned: the turn, linearised at the current view
/// centre. The belief's own jumps do not count.
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

Comparison RoomAwareness::comparison() const {
  Comparison comparison;
  comparison.measure = parameters_.distance.measure;
  if (comparison.measure == Distance::mode) comparison.measure = is_paper() ? Distance::ssd3 : Distance::hellinger;
  comparison.cap = is_paper() ? std::numeric_limits<double>::max() : parameters_.distance.cap;
  comparison.trusted_after = is_paper() ? 0.0 : parameters_.background.trusted_after;
  return comparison;
}

ViewCorrection RoomAwareness::correction() const {
  const ViewFilterParameters& filter = parameters_.view_filter;
  if (is_paper()) return {filter.paper_sharpness, filter.injection, 0.0};
  return {filter.sharpness, filter.injection, filter.clear_lead};
}

void RoomAwareness::on_flip() {
  confidences_.current = 0.0;
  confidences_.opposite = 0.0;
  confidences_.evidence = -confidences_.evidence;
}

void RoomAwareness::on_purge() {
  if (!is_paper()) return;
  confidences_.current = 0.0;
  confidences_.opposite = 0.0;
}

void RoomAwareness::on_reset() {
  confidences_.current = 0.0;
  confidences_.opposite = 0.0;
  confidences_.evidence = 0.0;
}

void RoomAwareness::forget() {
  model_.forget(wall_.tiles());
  scores_.clear();
  perceived_.clear();
  filter_.spread(parameters_.view_filter.particles);
  filter_.find_clusters();
  confidences_ = {};
  light_.restart(wall_.tiles());
  last_time_.reset();
  last_direction_.reset();
  view_center_.reset();
}

void RoomAwareness::set_parameters(const RoomParameters& parameters) {
  const bool model_holds = Wall(parameters.wall) == wall_ && parameters.mode == parameters_.mode &&
                           same(parameters.color, parameters_.color);
  const bool particles_hold = parameters.view_filter.particles == parameters_.view_filter.particles;
  parameters_ = parameters;
  wall_ = Wall(parameters.wall);
  if (!model_holds) return forget();
  if (!particles_hold) filter_.spread(parameters_.view_filter.particles);
}

/// After reading.
void RoomAwareness::complete() {
  for (const std::optional<double>& value : {last_time_, last_direction_, view_center_})
    check_bytes(!value || std::isfinite(*value), "a time or an angle is not a number");
  for (const double value : {confidences_.current, confidences_.opposite, confidences_.evidence})
    check_bytes(std::isfinite(value), "a confidence is not a number");
  perceived_.clear();
  scores_.clear();
}

}  // namespace reorient
