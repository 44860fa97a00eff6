// SPDX-License-Identifier: MIT
#include "localization/pose_filter.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/pinned_math.h"
#include "localization/measurement/both_cameras.h"
#include "localization/measurement/disturbed_place.h"
#include "localization/reorientation.h"

namespace reorient {
namespace {

constexpr std::uint64_t kRandomStream = 0x706F7365;  // "pose": differs from the streams of other modules
constexpr double kFoundFraction = 0.6;               // of all particles, in one cluster: ends the global search
constexpr double kLongestStep = 0.2;                 // s; a longer gap does not count as time with a measured fit

std::size_t particle_count(const PoseFilterParameters& parameters) {
  return static_cast<std::size_t>(std::max(1, parameters.particles));
}

/// The pose or its reflection, whichever fits the view better.
Pose2 side_of_view(const Pose2& pose, const SeenView& view) {
  const double off = angle_difference(pose.rotation, heading_of_view(view, pose.position, view.azimuth));
  return std::abs(off) <= kPi / 2.0 ? pose : reflect(pose);
}

}  // namespace

PoseFilter::PoseFilter(const PoseFilterParameters& parameters, const FieldDimensions& field, std::uint64_t seed)
    : parameters_(parameters),
      half_size_(believable_half_size(field)),
      random_(seed, kRandomStream),
      measurement_(field, parameters.measurement),
      injection_(field),
      landmark_injection_(field),
      view_injection_(field),
      clusters_(field),
      particles_(particle_count(parameters)),
      scratch_(particle_count(parameters)),
      costs_(particle_count(parameters)) {
  merged_.reserve();
  initialize_globally();
}

void PoseFilter::set_initial_pose(const Pose2& pose, double position_deviation, double rotation_deviation) {
  if (!pose.position.allFinite() || !std::isfinite(pose.rotation + position_deviation + rotation_deviation)) {
    initialize_globally();
    return;
  }
  particles_ = ParticleSet(particles_.size());
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double beside = rough_normal(random_);
    const double ahead = rough_normal(random_);
    const Eigen::Vector2d position = pose.position + position_deviation * Eigen::Vector2d(ahead, beside);
    particles_.set_pose(i, {position.cwiseMax(-half_size_).cwiseMin(half_size_),
                            pose.rotation + rotation_deviation * static_cast<double>(rough_normal(random_))});
  }
  recovery_.restart();
  searching_ = false;
  belief_ = PoseBelief{.pose = pose};
  find_belief();
}

void PoseFilter::initialize_globally() {
  particles_ = ParticleSet(particles_.size());
  const Eigen::Vector2d carpet = half_size_ - Eigen::Vector2d::Constant(kBelievableBeyondCarpet);
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double x = random_.uniform(-carpet.x(), carpet.x());
    const double y = random_.uniform(-carpet.y(), carpet.y());
    particles_.set_pose(i, {x, y, random_.uniform(-kPi, kPi)});
  }
  recovery_.restart();
  searching_ = true;
  belief_ = PoseBelief();
  find_belief();
}

void PoseFilter::predict(const Pose2& odometry_step, double time_step) {
  reorient::predict(particles_, odometry_step, time_step, parameters_.motion, half_size_, random_);
  if (std::isfinite(time_step)) elapsed_ += std::max(0.0, time_step);
  belief_.pose = belief_.pose * believable_step(odometry_step);
  belief_.pose.position = belief_.pose.position.cwiseMax(-half_size_).cwiseMin(half_size_);
}

void PoseFilter::update(const FieldPercept& percept, SeenGoal seen_goal, const std::optional<SeenView>& view,
                        double bias_deviation) {
  measurement_.observe(percept, bias_deviation);
  if (measurement_.terms() > 0.0) {
    weigh();
    resample();
    inject(percept, seen_goal, view);
  }
  find_belief();
  if (belief_.cluster_weight > kFoundFraction) searching_ = false;
}

void PoseFilter::update(const FieldPercept& upper, const FieldPercept& lower, SeenGoal seen_goal,
                        const std::optional<SeenView>& view, double bias_deviation) {
  if (!lower.has_landmarks()) return update(upper, seen_goal, view, bias_deviation);
  merge(upper, lower, merged_);
  update(merged_, seen_goal, view, bias_deviation);
}

void PoseFilter::feature_fits(const FieldPercept& percept, const Pose2& pose, FeatureFits& fits) {
  one_.set_pose(0, pose);
  measurement_.fits(percept, one_, fits);
}

void PoseFilter::see_nothing(double time_step) {
  if (time_step > 0.0) recovery_.see_nothing(std::min(time_step, kLongestStep), parameters_.injection.blind_time);
}

void PoseFilter::weigh() {
  measurement_.costs(particles_, costs_);
  double mean_cost = 0.0;
  for (std::size_t i = 0; i < particles_.size(); ++i)
    mean_cost += static_cast<double>(particles_.weight[i]) * costs_[i];
  const InjectionParameters& p = parameters_.injection;
  // A frame with few features counts less, since one that is false would make them all false.
  const double fraction = std::min(1.0, measurement_.terms() / parameters_.measurement.independent_points);
  recovery_.update(pinned::exp(-mean_cost / measurement_.terms()), fraction * std::min(elapsed_, kLongestStep),
                   p.slow_time, p.fast_time);

  const double correlation_time = parameters_.measurement.correlation_time;
  const auto frame_weight = elapsed_ < correlation_time ? static_cast<float>(elapsed_ / correlation_time) : 1.0f;
  elapsed_ = 0.0;
  reorient::weigh(particles_, costs_, frame_weight);
}

void PoseFilter::resample() {
  const double count = static_cast<double>(particles_.size());
  if (effective_sample_size(particles_) >= parameters_.resample_below * count) return;
  resample_systematic(particles_, scratch_, random_.uniform());
  std::swap(particles_, scratch_);
}

void PoseFilter::inject(const FieldPercept& percept, SeenGoal seen_goal, const std::optional<SeenView>& view) {
  const InjectionParameters& p = parameters_.injection;
  if (!p.enabled) return;
  const double lost = lost_probability();
  const bool use_view = view && p.use_view && lost > 0.0 &&
                        measurement_.line_points() >= static_cast<std::size_t>(p.line_points_with_view);
  const bool use_landmarks = p.use_landmarks && lost > 0.0 && LandmarkInjection::landmarks(percept) > 0;
  const std::optional<GoalSighting> goal = injection_.find_goal(percept, measurement_, p);
  if (!goal && !use_view && !use_landmarks) return;
  double rate = p.lost_rate * lost;
  if (goal) rate += seen_goal == SeenGoal::unknown ? p.unknown_goal_rate : p.known_goal_rate;
  // Rounds the count at random, so that rates below one particle per frame have an effect.
  const auto count = static_cast<int>(rate * static_cast<double>(particles_.size()) + random_.uniform());
  for (int i = 0; i < count; ++i) {
    // Each source of poses that is available gives a part of the particles.
    const bool by_landmark = use_landmarks && ((!goal && !use_view) || random_.below(2) == 0);
    const bool by_goal = goal && !by_landmark;
    std::optional<Pose2> pose = by_landmark ? landmark_injection_.draw(percept, measurement_, p, random_)
                                : by_goal   ? injection_.draw(*goal, seen_goal, measurement_, p, random_)
                                            : view_injection_.draw(*view, measurement_, p, random_);
    if (!pose) continue;
    if (by_landmark || (by_goal && seen_goal == SeenGoal::unknown)) {
      if (use_view) {
        pose = side_of_view(*pose, *view);
      } else if (!searching_) {
        pose = keep_sides(*pose);
      }
    }
    const std::size_t replaced = random_.below(particles_.size());
    particles_.set_pose(replaced, *pose);
    particles_.weight[replaced] = 1.0f / static_cast<float>(particles_.size());
  }
  if (count > 0) normalize_weights(particles_);
}

double PoseFilter::lost_probability() const {
  return searching_ ? 1.0 : recovery_.recovery_probability(parameters_.injection.lost_margin);
}

void PoseFilter::take_found(const Pose2& found, const std::optional<SeenView>& view) {
  constexpr std::uint64_t kOneStaysOf = 5;
  constexpr double kPosition = 0.1, kRotation = 0.05;  // m, rad
  const PoseClusterParameters& cluster = parameters_.clusters;
  const auto is_believed = [&](const Pose2& pose) {
    return are_near(pose, belief_.pose, 0.5 * cluster.radius, 0.5 * cluster.max_rotation_difference);
  };
  const bool was_lost = is_lost();
  recovery_.restart();
  if (belief_.cluster_weight > kFoundFraction && (is_believed(found) || is_believed(reflect(found)))) {
    searching_ = false;
    return;
  }
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double ahead = rough(kPosition, random_), aside = rough(kPosition, random_);
    Pose2 pose = found * Pose2(ahead, aside, rough(kRotation, random_));
    pose.position = pose.position.cwiseMax(-half_size_).cwiseMin(half_size_);
    if (view && was_lost) {
      pose = side_of_view(pose, *view);
    } else if (!searching_) {
      pose = keep_sides(pose);
    }
    if (random_.below(kOneStaysOf) != 0) particles_.set_pose(i, pose);
  }
  std::fill(particles_.weight.begin(), particles_.weight.end(), 1.0f / static_cast<float>(particles_.size()));
  searching_ = false;
  find_belief();
}

/// An unknown goal gives no evidence about the side of the field. So the new particles are divided between the pose and
/// its reflection in the same ratio as the present ones. With equal halves, a robot that was placed again slightly
/// rotated would soon have two clusters of equal weight, and noise would choose.
Pose2 PoseFilter::keep_sides(const Pose2& drawn) {
  const double both = belief_.cluster_weight + belief_.reflected_weight;
  const double believed_fraction = both > 0.0 ? belief_.cluster_weight / both : 0.5;
  const bool is_believed_side = std::abs(angle_difference(drawn.rotation, belief_.pose.rotation)) < kPi / 2.0;
  return is_believed_side == (random_.uniform() < believed_fraction) ? drawn : reflect(drawn);
}

void PoseFilter::flip_pose() {
  reorient::flip_pose(particles_);
  belief_ = flipped(belief_);
}

void PoseFilter::purge_reflection() {
  reorient::purge_reflection(particles_, belief_.pose, scratch_, random_);
  find_belief();
}

void PoseFilter::reset_orientation() {
  reorient::reset_orientation(particles_, random_);
  recovery_.restart();
  find_belief();
}

void PoseFilter::set_parameters(const PoseFilterParameters& parameters) {
  parameters_ = parameters;
  measurement_.set_parameters(parameters.measurement);
  const std::size_t count = particle_count(parameters);
  if (count == particles_.size()) return;
  scratch_ = ParticleSet(count);
  resample_systematic(particles_, scratch_, random_.uniform());
  std::swap(particles_, scratch_);
  scratch_ = ParticleSet(count);
  costs_.resize(count);
  find_belief();
}

void PoseFilter::append_poses(std::vector<Pose2>& poses) const {
  for (std::size_t i = 0; i < particles_.size(); ++i) poses.push_back(particles_.pose(i));
}

/// Checks the state after reading.
void PoseFilter::complete() {
  check_bytes(particles_.size() == particle_count(parameters_),
              "pose filter: the number of particles differs from the parameters");
  const auto is_inside = [this](double x, double y) {
    constexpr double kRounding = 1e-3;  // m, of single precision
    return std::abs(x) <= half_size_.x() + kRounding && std::abs(y) <= half_size_.y() + kRounding;
  };
  for (std::size_t i = 0; i < particles_.size(); ++i)
    check_bytes(is_inside(particles_.x[i], particles_.y[i]), "pose filter: a particle is outside of the field");
  check_bytes(is_inside(belief_.pose.position.x(), belief_.pose.position.y()) && std::abs(belief_.pose.rotation) <= kPi,
              "pose filter: the believed pose is outside of the field");
  check_bytes(std::isfinite(elapsed_) && elapsed_ >= 0.0, "pose filter: a time is negative or not finite");
  costs_.resize(particles_.size());
  scratch_ = ParticleSet(particles_.size());
}

}  // namespace reorient
