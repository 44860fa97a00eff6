// SPDX-License-Identifier: MIT
#include "localization/measurement/measurement_model.h"

#include <algorithm>
#include <cmath>

#include "geometry/square.h"
#include "geometry/transform.h"
#include "localization/measurement/spread_points.h"

namespace reorient {
namespace {

constexpr double kNearest = 0.1;           // m; a nearer point is on the robot itself
constexpr std::size_t kMostGoalPosts = 4;  // of a field

bool in_range(const Eigen::Vector2d& position, double farthest) {
  const double distance = position.norm();  // not finite where the position is not
  return distance >= kNearest && distance <= farthest;
}

}  // namespace

MeasurementModel::MeasurementModel(const FieldDimensions& field, const MeasurementModelParameters& parameters)
    : map_(field), posts_(reorient::goal_posts(field)) {
  goal_posts_.reserve(kMostGoalPosts);
  set_parameters(parameters);
}

void MeasurementModel::set_parameters(const MeasurementModelParameters& parameters) {
  parameters_ = parameters;
  tilt_variance_ = square(parameters.tilt_deviation);
  line_points_.reserve(static_cast<std::size_t>(std::max(1, parameters.line_points)));
}

double MeasurementModel::variance_along(double distance) const {
  const double height = parameters_.camera_height;
  const double meters_per_radian = height + distance * distance / height;
  return square(parameters_.position_deviation) + tilt_variance_ * square(meters_per_radian);
}

double MeasurementModel::variance_across(double distance) const {
  return square(parameters_.position_deviation) + square(parameters_.bearing_deviation * distance);
}

bool MeasurementModel::is_usable(const LinePoint& point) const {
  return std::isfinite(point.normal) && in_range(point.position, parameters_.farthest_line_point);
}

bool MeasurementModel::is_usable(const GoalPost& post) const {
  return in_range(post.position, parameters_.farthest_goal_post);
}

MeasurementModel::ObservedLinePoint MeasurementModel::observed(const LinePoint& point) const {
  const double distance = point.position.norm();
  const Eigen::Vector2d sight = point.position / distance;
  const double along = sight.dot(unit_vector(point.normal));
  // Only the error across the line is observable.
  const double variance = square(along) * variance_along(distance) + (1.0 - square(along)) * variance_across(distance);
  return {static_cast<float>(point.position.x()), static_cast<float>(point.position.y()), to_binary_angle(point.normal),
          static_cast<float>(square(FieldMap::kStep) / (2.0 * variance))};
}

MeasurementModel::ObservedGoalPost MeasurementModel::observed(const GoalPost& post) const {
  const double distance = post.position.norm();
  const Eigen::Vector2d sight = post.position / distance;
  const double along =
      post.base_visible ? variance_along(distance) : square(parameters_.rough_distance_deviation * distance);
  return {static_cast<float>(post.position.x()), static_cast<float>(post.position.y()),
          static_cast<float>(sight.x()),         static_cast<float>(sight.y()),
          static_cast<float>(0.5 / along),       static_cast<float>(0.5 / variance_across(distance))};
}

void MeasurementModel::observe(const FieldPercept& percept, double bias_deviation) {
  tilt_variance_ = square(parameters_.tilt_deviation) + square(bias_deviation);
  line_points_.clear();
  goal_posts_.clear();
  for_some(
      percept.line_points, static_cast<std::size_t>(std::max(1, parameters_.line_points)),
      [this](const LinePoint& point) { return is_usable(point); },
      [this](const LinePoint& point) { line_points_.push_back(observed(point)); });
  for (const GoalPost& post : percept.goal_posts) {
    if (goal_posts_.size() < kMostGoalPosts && is_usable(post)) goal_posts_.push_back(observed(post));
  }
}

double MeasurementModel::terms() const {
  return static_cast<double>(goal_posts_.size()) +
         std::min(static_cast<double>(line_points_.size()), parameters_.independent_points);
}

void MeasurementModel::costs(const ParticleSet& particles, std::vector<float>& costs) const {
  costs.assign(particles.size(), 0.0f);
  for (const ObservedLinePoint& point : line_points_) add_costs(point, particles, costs);
  if (static_cast<double>(line_points_.size()) > parameters_.independent_points) {
    const auto fraction = static_cast<float>(parameters_.independent_points / static_cast<double>(line_points_.size()));
    for (float& cost : costs) cost *= fraction;
  }
  for (const ObservedGoalPost& post : goal_posts_) add_costs(post, particles, costs);
}

void MeasurementModel::fits(const FieldPercept& percept, const ParticleSet& pose, FeatureFits& fits) const {
  std::array<float, 1> cost;
  const auto fit = [&](const auto& feature, double limit) {
    if (!is_usable(feature)) return FeatureFits::kIgnored;
    cost.fill(0.0f);
    add_costs(observed(feature), pose, cost);
    return cost[0] / static_cast<float>(limit);
  };
  fits.clear();
  for (const LinePoint& point : percept.line_points)
    fits.line_points.push_back(fit(point, parameters_.line_point_cost_limit));
  for (const GoalPost& post : percept.goal_posts)
    fits.goal_posts.push_back(fit(post, parameters_.goal_post_cost_limit));
}

void MeasurementModel::add_costs(const ObservedLinePoint& point, const ParticleSet& particles,
                                 std::span<float> costs) const {
  const auto limit = static_cast<float>(parameters_.line_point_cost_limit);
  // In blocks: first the arithmetic, which the compiler vectorizes, then the look-ups, which it cannot.
  std::array<std::int32_t, 64> indices;
  for (std::size_t begin = 0; begin < particles.size(); begin += indices.size()) {
    const std::size_t count = std::min(indices.size(), particles.size() - begin);
    const float* const particle_x = particles.x.data() + begin;
    const float* const particle_y = particles.y.data() + begin;
    const float* const cosine = particles.cosine.data() + begin;
    const float* const sine = particles.sine.data() + begin;
    const BinaryAngle* const rotation = particles.rotation.data() + begin;
    for (std::size_t i = 0; i < count; ++i) {
      const float x = particle_x[i] + (cosine[i] * point.x - sine[i] * point.y);
      const float y = particle_y[i] + (sine[i] * point.x + cosine[i] * point.y);
      indices[i] = map_.index(x, y, rotation[i] + point.normal);
    }
    for (std::size_t i = 0; i < count; ++i) {
      const auto distance = static_cast<float>(map_.steps_at(indices[i]));
      costs[begin + i] += std::min(distance * distance * point.precision, limit);
    }
  }
}

void MeasurementModel::add_costs(const ObservedGoalPost& post, const ParticleSet& particles,
                                 std::span<float> costs) const {
  const auto limit = static_cast<float>(parameters_.goal_post_cost_limit);
  const auto goal_x = static_cast<float>(posts_[0].x());
  const auto post_y = static_cast<float>(posts_[0].y());
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const float cosine = particles.cosine[i];
    const float sine = particles.sine[i];
    const float x = particles.x[i] + (cosine * post.x - sine * post.y);
    const float y = particles.y[i] + (sine * post.x + cosine * post.y);
    const float sight_x = cosine * post.sight_x - sine * post.sight_y;
    const float sight_y = sine * post.sight_x + cosine * post.sight_y;
    // The four posts are (+-goal_x, +-post_y): takes the nearer goal, and the better of its two posts.
    const float off_x = x - std::copysign(goal_x, x);
    float least = limit;
    for (const float side : {post_y, -post_y}) {
      const float off_y = y - side;
      const float along = off_x * sight_x + off_y * sight_y;
      const float across = off_x * sight_y - off_y * sight_x;
      least = std::min(least, along * along * post.precision_along + across * across * post.precision_across);
    }
    costs[i] += least;
  }
}

}  // namespace reorient
