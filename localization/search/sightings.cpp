// SPDX-License-Identifier: MIT
#include "localization/search/sightings.h"

#include <algorithm>
#include <cmath>

#include "localization/measurement/spread_points.h"
#include "localization/tracking/tilt_geometry.h"

namespace reorient {
namespace {

constexpr std::uint32_t kFewestLines = 3;          // smallest number of points of a useful image
constexpr double kNearest = 0.1, kFarthest = 5.0;  // m

bool is_in_range(const Eigen::Vector2d& place) {
  const double distance = place.norm();  // not finite where the place is not
  return distance >= kNearest && distance <= kFarthest;
}

/// Variance across the line, from the errors of its position and of the line of sight.
double variance_of(const LinePoint& point, const Isometry3& robot_from_camera) {
  constexpr double kPlaceDeviation = 0.05, kSightDeviation = 0.008;  // m, rad
  const double reach = meters_per_radian(point.position, unit_vector(point.normal), robot_from_camera);
  return kPlaceDeviation * kPlaceDeviation + kSightDeviation * kSightDeviation * reach * reach;
}

}  // namespace

void Sightings::forget_before(double time) {
  const auto end = all_.begin() + count_;
  const auto first = std::find_if(all_.begin(), end, [time](const Sighting& one) { return one.time >= time; });
  count_ = static_cast<std::uint32_t>(std::move(first, end, all_.begin()) - all_.begin());
}

void Sightings::add(const FieldPercept& percept, std::size_t camera, const Isometry3& robot_from_camera,
                    const TiltBias& used, const Pose2& odometry, double time) {
  forget_before(time - kOldest);
  if (time < last_[camera] + kBetween && time >= last_[camera]) return;
  Sighting sighting;
  sighting.time = time;
  sighting.odometry = odometry;
  sighting.camera = static_cast<std::uint32_t>(camera);
  sighting.robot_from_camera = robot_from_camera;
  sighting.used = used;
  const auto usable = [](const LinePoint& point) { return std::isfinite(point.normal) && is_in_range(point.position); };
  for_some(percept.line_points, Sighting::kMostLines, usable, [&](const LinePoint& point) {
    sighting.lines[sighting.line_count++] = {point.position, point.normal, variance_of(point, robot_from_camera)};
  });
  for (const GoalPost& post : percept.goal_posts) {
    if (post.base_visible && is_in_range(post.position) && sighting.post_count < Sighting::kMostPosts)
      sighting.posts[sighting.post_count++] = post.position;
  }
  const auto add_landmark = [&](const Eigen::Vector2d& place, double direction, std::optional<IntersectionKind> kind) {
    if (is_in_range(place) && std::isfinite(direction) && sighting.landmark_count < Sighting::kMostLandmarks)
      sighting.landmarks[sighting.landmark_count++] = {place, direction, kind};
  };
  if (percept.center_circle && percept.center_circle->halfway_direction)
    add_landmark(percept.center_circle->center, *percept.center_circle->halfway_direction, std::nullopt);
  for (const Intersection& one : percept.intersections) add_landmark(one.position, one.direction, one.kind);
  if (sighting.line_count < kFewestLines && sighting.post_count == 0) return;
  last_[camera] = time;
  if (count_ == kMost) {
    std::move(all_.begin() + 1, all_.end(), all_.begin());
    --count_;
  }
  all_[count_++] = sighting;
}

std::size_t Sightings::points() const {
  std::size_t points = 0;
  for (std::size_t i = 0; i < count_; ++i) points += all_[i].line_count + all_[i].post_count;
  return points;
}

std::size_t Sightings::landmarks() const {
  std::size_t landmarks = 0;
  for (std::size_t i = 0; i < count_; ++i) landmarks += all_[i].landmark_count;
  return landmarks;
}

/// Checks the state after reading.
void Sightings::complete() const {
  check_bytes(count_ <= kMost, "sightings: more than possible");
  for (const Sighting& one : all_) {
    check_bytes(one.camera < 2 && one.line_count <= Sighting::kMostLines && one.post_count <= Sighting::kMostPosts &&
                    one.landmark_count <= Sighting::kMostLandmarks,
                "sightings: a count is out of range");
    check_bytes(one.robot_from_camera.matrix().allFinite() && one.odometry.position.allFinite(),
                "sightings: a pose is not finite");
    bool is_finite = std::isfinite(one.time + one.odometry.rotation + one.used.roll + one.used.pitch);
    for (const Sighting::Line& line : one.lines)
      is_finite = is_finite && line.place.allFinite() && std::isfinite(line.normal) && line.variance > 0.0;
    for (const Eigen::Vector2d& post : one.posts) is_finite = is_finite && post.allFinite();
    for (const Sighting::Landmark& landmark : one.landmarks)
      is_finite = is_finite && landmark.place.allFinite() && std::isfinite(landmark.direction);
    check_bytes(is_finite, "sightings: a value is not finite or not positive");
  }
}

}  // namespace reorient
