// SPDX-License-Identifier: MIT
#include "localization/search/pose_search.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <Eigen/Cholesky>

#include "geometry/angle.h"
#include "geometry/square.h"
#include "geometry/transform.h"
#include "localization/measurement/disturbed_place.h"
#include "localization/tracking/tilt_geometry.h"

namespace reorient {
namespace {

constexpr std::uint64_t kRandomStream = 0x736561726368;  // "search": differs from the streams of other modules
constexpr double kCostLimit = 3.0;                       // of one point
constexpr double kIndependentPoints = 4.0;               // of one image, since its points share errors
constexpr int kParts = 3;                                // of the poses tried; the best of each part is refined
constexpr double kOnLine = 2.0;                          // standard deviations
constexpr double kSamePosition = 0.5;                    // m
constexpr double kSameRotation = 0.35;                   // rad
constexpr std::uint32_t kFewestFrames = 12;              // of a search
constexpr double kPostDeviation = 0.1;                   // m, near the robot
constexpr double kPostSight = 0.01;                      // rad

bool is_same(const Pose2& one, const Pose2& other) { return are_near(one, other, kSamePosition, kSameRotation); }

/// The rotation from the camera of the sighting to the camera of the hypothesis.
TiltBias turn_of(const PoseHypothesis& one, const Sighting& sighting) {
  const TiltBias sum = bias_of(one.bias, sighting.camera, sighting.robot_from_camera);
  return {sum.roll - sighting.used.roll, sum.pitch - sighting.used.pitch};
}

double independent_fraction(const Sighting& sighting) {
  return std::min(1.0, kIndependentPoints / static_cast<double>(std::max(1U, sighting.line_count)));
}

TiltBias disturbed(const TiltBias& mean, double deviation, Random& random) {
  const double roll = rough(deviation, random);
  return {mean.roll + roll, mean.pitch + rough(deviation, random)};
}

double prior_cost(const TiltBias& bias, const TiltBias& mean, double deviation) {
  if (!(deviation > 0.0)) return 0.0;
  return (square(bias.roll - mean.roll) + square(bias.pitch - mean.pitch)) / (2.0 * square(deviation));
}

/// Variance of the position of a post along each axis, m^2.
double post_variance(const Eigen::Vector2d& place) {
  return square(kPostDeviation) + square(kPostSight * place.squaredNorm());
}

bool is_cheaper(const PoseHypothesis& one, const PoseHypothesis& other) { return one.cost < other.cost; }

}  // namespace

PoseSearch::PoseSearch(const PoseSearchParameters& parameters, const FieldDimensions& field, std::uint64_t seed)
    : parameters_(parameters),
      lines_(field),
      posts_(goal_posts(field)),
      intersections_(field),
      carpet_(carpet_half_size(field)),
      random_(seed, kRandomStream) {}

void PoseSearch::forget_before(double time) {
  sightings_.forget_before(time);
  stop();
}

/// Draws a pose from a landmark, or anywhere without one, with angles from the prior.
PoseHypothesis PoseSearch::draw(const BiasPrior& prior, const Pose2& odometry) {
  PoseHypothesis one;
  one.bias.torso = disturbed(prior.mean.torso, prior.torso_deviation, random_);
  for (std::size_t i = 0; i < one.bias.mounts.size(); ++i)
    one.bias.mounts[i] = disturbed(prior.mean.mounts[i], prior.mount_deviation, random_);
  const auto anywhere = [&] {
    const double x = random_.uniform(-carpet_.x(), carpet_.x());
    const double y = random_.uniform(-carpet_.y(), carpet_.y());
    one.field_from_odometry = Pose2(x, y, random_.uniform(-kPi, kPi)) * odometry.inverse();
    return one;
  };
  const std::size_t landmarks = sightings_.landmarks();
  // Landmarks may be false positives, so a part of the poses is drawn without one.
  if (landmarks == 0 || random_.below(4) == 0) return anywhere();
  std::size_t skipped = random_.below(landmarks);
  std::size_t i = 0;
  while (skipped >= sightings_[i].landmark_count) skipped -= sightings_[i++].landmark_count;
  const Sighting& sighting = sightings_[i];
  const Sighting::Landmark& seen = sighting.landmarks[skipped];
  Eigen::Vector2d known = Eigen::Vector2d::Zero();
  double known_direction = draw_halfway_direction(random_);
  if (seen.kind) {
    const FieldIntersection* const intersection = intersections_.draw(*seen.kind, random_);
    if (intersection == nullptr) return anywhere();
    known = intersection->position;
    known_direction = intersection->direction + draw_turn(*seen.kind, random_);
  }
  const Eigen::Vector2d place = moved_by_tilt(seen.place, sighting.robot_from_camera, turn_of(one, sighting));
  one.field_from_odometry =
      pose_from_landmark(known, known_direction, place, seen.direction) * sighting.odometry.inverse();
  return one;
}

/// The cost of some of the points by the map: fast, and good enough to choose which pose to refine.
double PoseSearch::rough_cost(const PoseHypothesis& one, const FieldMap& map) const {
  constexpr std::size_t kEvery = 3;
  double cost = 0.0;
  for (std::size_t i = 0; i < sightings_.size(); ++i) {
    const Sighting& sighting = sightings_[i];
    const TiltBias turn = turn_of(one, sighting);
    const Pose2 robot = one.field_from_odometry * sighting.odometry;
    const auto [sine, cosine] = pinned::sincos(robot.rotation);
    for (std::size_t j = 0; j < sighting.line_count; j += kEvery) {
      const Sighting::Line& line = sighting.lines[j];
      const Eigen::Vector2d place = moved_by_tilt(line.place, sighting.robot_from_camera, turn);
      const Eigen::Vector2d on_field(robot.position.x() + cosine * place.x() - sine * place.y(),
                                     robot.position.y() + sine * place.x() + cosine * place.y());
      const double distance = map.distance(on_field, line.normal + robot.rotation);
      cost += std::min(square(distance) / (2.0 * line.variance), kCostLimit);
    }
  }
  return cost;
}

/// Gauss-Newton steps with decreasing tolerance for outliers.
void PoseSearch::refine(PoseHypothesis& one, const BiasPrior& prior, const Pose2& odometry) const {
  constexpr int kSize = 9, kTorso = 3;  // x, y, rotation; roll and pitch of torso and of both mounts
  constexpr std::array kMounts{5, 7};
  constexpr std::array kTolerances{4.0, 2.5, 1.5, 1.0, 1.0};
  for (const double tolerance : kTolerances) {
    Eigen::Matrix<double, kSize, kSize> information = Eigen::Matrix<double, kSize, kSize>::Zero();
    Eigen::Matrix<double, kSize, 1> gradient = Eigen::Matrix<double, kSize, 1>::Zero();
    const auto add_prior = [&](int at, const TiltBias& bias, const TiltBias& mean, double deviation) {
      const double precision = 1.0 / square(std::max(deviation, 1e-4));
      information(at, at) += precision;
      information(at + 1, at + 1) += precision;
      gradient(at) += precision * (bias.roll - mean.roll);
      gradient(at + 1) += precision * (bias.pitch - mean.pitch);
    };
    add_prior(kTorso, one.bias.torso, prior.mean.torso, prior.torso_deviation);
    for (std::size_t i = 0; i < one.bias.mounts.size(); ++i)
      add_prior(kMounts[i], one.bias.mounts[i], prior.mean.mounts[i], prior.mount_deviation);
    const Pose2 now = one.field_from_odometry * odometry;
    for (std::size_t i = 0; i < sightings_.size(); ++i) {
      const Sighting& sighting = sightings_[i];
      const TiltBias turn = turn_of(one, sighting);
      const Pose2 robot = one.field_from_odometry * sighting.odometry;
      const Eigen::Vector2d axis = mount_axis(sighting.robot_from_camera);
      const double fraction = independent_fraction(sighting);
      const auto add = [&](const Eigen::Vector2d& place, const Eigen::Vector2d& on_field, const Eigen::Vector2d& normal,
                           double residual, double variance) {
        const double weight = fraction / (variance * (1.0 + square(residual) / (square(tolerance) * variance)));
        const TiltRow tilt = tilt_row(rotated(normal, -robot.rotation), place, sighting.robot_from_camera, axis);
        Eigen::Matrix<double, kSize, 1> row = Eigen::Matrix<double, kSize, 1>::Zero();
        row.head<3>() << normal.x(), normal.y(), cross(on_field - now.position, normal);
        row.segment<2>(kTorso) << tilt.roll, tilt.pitch;
        row.segment<2>(kMounts[sighting.camera]) << tilt.mount_roll, tilt.mount_pitch;
        information += weight * row * row.transpose();
        gradient += weight * residual * row;
      };
      for (std::size_t j = 0; j < sighting.line_count; ++j) {
        const Sighting::Line& line = sighting.lines[j];
        const Eigen::Vector2d place = moved_by_tilt(line.place, sighting.robot_from_camera, turn);
        const Eigen::Vector2d on_field = robot * place;
        const auto nearest = lines_.nearest(on_field, unit_vector(line.normal + 0.5 * kPi + robot.rotation));
        if (nearest) add(place, on_field, nearest->normal, nearest->distance, line.variance);
      }
      for (std::size_t j = 0; j < sighting.post_count; ++j) {
        const Eigen::Vector2d place = moved_by_tilt(sighting.posts[j], sighting.robot_from_camera, turn);
        const Eigen::Vector2d on_field = robot * place;
        const Eigen::Vector2d off = on_field - nearest_post(on_field);
        const double variance = post_variance(place);
        add(place, on_field, Eigen::Vector2d::UnitX(), off.x(), variance);
        add(place, on_field, Eigen::Vector2d::UnitY(), off.y(), variance);
      }
    }
    information.diagonal() += Eigen::Matrix<double, kSize, 1>::Constant(1e-3);
    const Eigen::Matrix<double, kSize, 1> step = -information.ldlt().solve(gradient);
    if (!step.allFinite()) return;
    const Pose2 moved(now.position.x() + std::clamp(step(0), -0.5, 0.5),
                      now.position.y() + std::clamp(step(1), -0.5, 0.5), now.rotation + std::clamp(step(2), -0.3, 0.3));
    one.field_from_odometry = moved * odometry.inverse();
    const auto turned = [&](TiltBias& bias, int at) {
      bias.roll += std::clamp(step(at), -0.05, 0.05);
      bias.pitch += std::clamp(step(at + 1), -0.05, 0.05);
    };
    turned(one.bias.torso, kTorso);
    for (std::size_t i = 0; i < one.bias.mounts.size(); ++i) turned(one.bias.mounts[i], kMounts[i]);
  }
}

const Eigen::Vector2d& PoseSearch::nearest_post(const Eigen::Vector2d& place) const {
  return *std::min_element(posts_.begin(), posts_.end(), [&](const auto& a, const auto& b) {
    return (a - place).squaredNorm() < (b - place).squaredNorm();
  });
}

void PoseSearch::evaluate(PoseHypothesis& one, const FieldMap& map, const BiasPrior& prior) const {
  one.cost = prior_cost(one.bias.torso, prior.mean.torso, prior.torso_deviation);
  for (std::size_t i = 0; i < one.bias.mounts.size(); ++i)
    one.cost += prior_cost(one.bias.mounts[i], prior.mean.mounts[i], prior.mount_deviation);
  std::size_t points = 0, fitting = 0;
  for (std::size_t i = 0; i < sightings_.size(); ++i) {
    const Sighting& sighting = sightings_[i];
    const TiltBias turn = turn_of(one, sighting);
    const Pose2 robot = one.field_from_odometry * sighting.odometry;
    const double fraction = independent_fraction(sighting);
    for (std::size_t j = 0; j < sighting.line_count; ++j) {
      const Sighting::Line& line = sighting.lines[j];
      const Eigen::Vector2d on_field = robot * moved_by_tilt(line.place, sighting.robot_from_camera, turn);
      const double distance = map.distance(on_field, line.normal + robot.rotation);
      const double squared = square(distance) / line.variance;
      one.cost += fraction * std::min(0.5 * squared, kCostLimit);
      ++points;
      fitting += squared <= square(kOnLine) ? 1 : 0;
    }
    for (std::size_t j = 0; j < sighting.post_count; ++j) {
      const Eigen::Vector2d place = moved_by_tilt(sighting.posts[j], sighting.robot_from_camera, turn);
      const Eigen::Vector2d on_field = robot * place;
      const double squared = (on_field - nearest_post(on_field)).squaredNorm() / post_variance(place);
      one.cost += std::min(0.5 * squared, kCostLimit);
    }
  }
  one.fit = points == 0 ? 0.0 : static_cast<double>(fitting) / static_cast<double>(points);
}

/// Stores a hypothesis if it is among the best. A pose and its reflection count as the same.
void PoseSearch::store(const PoseHypothesis& one, const Pose2& odometry) {
  const Pose2 pose = one.field_from_odometry * odometry;
  if ((pose.position.cwiseAbs().array() > carpet_.array()).any()) return;
  const auto end = best_.begin() + count_;
  const auto same = std::find_if(best_.begin(), end, [&](const PoseHypothesis& other) {
    const Pose2 where = other.field_from_odometry * odometry;
    return is_same(where, pose) || is_same(reflect(where), pose);
  });
  if (same != end) {
    if (one.cost < same->cost) *same = one;
    return;
  }
  if (count_ < kMostHypotheses) {
    best_[count_++] = one;
    return;
  }
  const auto worst = std::max_element(best_.begin(), end, is_cheaper);
  if (one.cost < worst->cost) *worst = one;
}

std::optional<PoseHypothesis> PoseSearch::search(const FieldMap& map, const BiasPrior& prior, const Pose2& odometry,
                                                 const Pose2& believed) {
  if (!parameters_.enabled || sightings_.points() < static_cast<std::size_t>(parameters_.fewest_points))
    return std::nullopt;
  if (sightings_[sightings_.size() - 1].time - sightings_[0].time < parameters_.least_time) return std::nullopt;
  // Refines one of the hypotheses of earlier frames, and computes the costs of all with the new sightings.
  if (count_ > 0) refine(best_[next_++ % count_], prior, odometry);
  std::array<PoseHypothesis, kMostHypotheses> before = best_;
  const std::uint32_t count = std::exchange(count_, 0);
  for (std::uint32_t i = 0; i < count; ++i) {
    evaluate(before[i], map, prior);
    store(before[i], odometry);
  }
  const auto try_one = [&](PoseHypothesis one) {
    refine(one, prior, odometry);
    evaluate(one, map, prior);
    store(one, odometry);
  };
  for (int part = 0; part < kParts; ++part) {
    PoseHypothesis best = draw(prior, odometry);
    double least = rough_cost(best, map);
    for (int i = 1; i < parameters_.candidates / kParts; ++i) {
      const PoseHypothesis candidate = draw(prior, odometry);
      const double cost = rough_cost(candidate, map);
      if (cost >= least) continue;
      least = cost;
      best = candidate;
    }
    try_one(best);
  }
  try_one({believed * odometry.inverse(), {prior.mean.torso, prior.mean.mounts, 0.0}});
  if (++searched_ < kFewestFrames || count_ == 0) return std::nullopt;
  const auto end = best_.begin() + count_;
  std::sort(best_.begin(), end, is_cheaper);
  const PoseHypothesis& best = best_[0];
  const double lead = count_ > 1 ? best_[1].cost - best.cost : std::numeric_limits<double>::infinity();
  if (best.fit < parameters_.least_fit || lead < parameters_.lead) return std::nullopt;
  const PoseHypothesis found = best;
  stop();
  return found;
}

/// Checks the state after reading.
void PoseSearch::complete() const {
  check_bytes(count_ <= kMostHypotheses, "pose search: more hypotheses than possible");
  for (const PoseHypothesis& one : best_) {
    bool is_finite = one.field_from_odometry.position.allFinite() && std::isfinite(one.field_from_odometry.rotation);
    for (const TiltBias& bias : {one.bias.torso, one.bias.mounts[0], one.bias.mounts[1]})
      is_finite = is_finite && std::isfinite(bias.roll + bias.pitch);
    check_bytes(is_finite && std::isfinite(one.cost + one.fit), "pose search: a value of a hypothesis is not finite");
  }
}

}  // namespace reorient
