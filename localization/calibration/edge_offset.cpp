// SPDX-License-Identifier: MIT
#include "localization/calibration/edge_offset.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/pinned_math.h"
#include "geometry/random.h"

namespace reorient {
namespace {

/// An edge on the plane at distance 1 in front of the camera: y to the left, z up.
struct PlaneEdge {
  Eigen::Vector2d middle, along;
  double weight = 0.0;  // pixels
};

std::vector<PlaneEdge> on_plane(const EdgeView& view) {
  std::vector<PlaneEdge> edges;
  edges.reserve(view.edges.size());
  for (const ImageEdge& edge : view.edges) {
    const Eigen::Vector2d upper = view.camera.ray(edge.upper).tail<2>(), lower = view.camera.ray(edge.lower).tail<2>();
    edges.push_back({0.5 * (upper + lower), upper - lower, edge.length()});
  }
  return edges;
}

/// From the projected vertical to the edge, rad, in (-pi/2, pi/2].
double angle_of(const PlaneEdge& edge, const Eigen::Vector3d& up_in_camera) {
  const Eigen::Vector2d vertical = up_in_camera.tail<2>() - up_in_camera.x() * edge.middle;
  const double cross = vertical.x() * edge.along.y() - vertical.y() * edge.along.x();
  const double dot = vertical.dot(edge.along);
  return dot < 0.0 ? pinned::atan2(-cross, -dot) : pinned::atan2(cross, dot);
}

Eigen::Vector3d up_in_camera(const EdgeView& view, const CameraOffset& offset) {
  return turned(view.robot_from_camera, offset).linear().row(2).transpose();
}

EdgeView every_second_edge(const EdgeView& view, std::size_t first) {
  EdgeView half{view.camera, view.robot_from_camera, {}};
  for (std::size_t i = first; i < view.edges.size(); i += 2) half.edges.push_back(view.edges[i]);
  return half;
}

/// The tilt and roll of one image, with a weak prior.
CameraOffset own_offset(const EdgeView& view, double noise) {
  constexpr double kOwnReach = 8.0, kOwnStep = 0.5;  // degrees; the reach is also the prior's standard deviation
  const std::vector<PlaneEdge> edges = on_plane(view);
  double length = 0.0;
  for (const PlaneEdge& edge : edges) length += edge.weight;
  const double count = static_cast<double>(edges.size()), cap = 2.0 * noise;
  CameraOffset best;
  double least = std::numeric_limits<double>::max();
  for (double tilt = -kOwnReach; tilt <= kOwnReach; tilt += kOwnStep) {
    for (double roll = -kOwnReach; roll <= kOwnReach; roll += kOwnStep) {
      const CameraOffset tried{.tilt = from_degrees(tilt), .roll = from_degrees(roll)};
      const Eigen::Vector3d up = up_in_camera(view, tried);
      double cost = (tilt * tilt + roll * roll) / (kOwnReach * kOwnReach);
      for (const PlaneEdge& edge : edges) {
        const double angle = std::min(std::abs(angle_of(edge, up)), cap) / noise;
        cost += count * edge.weight / length * angle * angle;
      }
      if (cost >= least) continue;
      least = cost;
      best = tried;
    }
  }
  return best;
}

OffsetEstimate offset_from_edges(std::span<const EdgeView> views) {
  std::vector<std::vector<PlaneEdge>> edges;
  edges.reserve(views.size());
  double length = 0.0;
  std::size_t count = 0;
  for (const EdgeView& view : views) {
    edges.push_back(on_plane(view));
    for (const PlaneEdge& edge : edges.back()) length += edge.weight;
    count += edges.back().size();
  }
  if (count == 0) return {};
  // The end of an edge of mean length has an error of at least a quarter of a pixel.
  const double least_noise = 0.25 * static_cast<double>(count) / length;
  OffsetProblem problem;
  problem.images = views.size();
  problem.residuals = [&](std::size_t image, const CameraOffset& offset, std::size_t every,
                          std::vector<WeightedResidual>& residuals) {
    residuals.clear();
    const Eigen::Vector3d up = up_in_camera(views[image], offset);
    for (std::size_t i = 0; i < edges[image].size(); i += every)
      residuals.push_back({angle_of(edges[image][i], up), edges[image][i].weight});
  };
  problem.observable = {true, false, true, false};
  problem.reach = {from_degrees(15.0), 0.0, from_degrees(12.0), 0.0};
  problem.step = {from_degrees(1.0), 1.0, from_degrees(1.0), 1.0};
  problem.prior = {from_degrees(15.0), 1.0, from_degrees(15.0), 1.0};
  problem.window = kNearlyVertical;
  problem.cap = from_degrees(4.0);
  problem.least_noise = least_noise;
  return fit_offset(problem, {from_degrees(1.0), 1.0, from_degrees(1.0), 1.0});
}

}  // namespace

EdgeMounting mounting_from_edges(std::span<const EdgeView> views) {
  constexpr int kSamples = 100, kMostOften = 95;
  constexpr double kBetter = 0.99;  // of the median angle, so that rounding does not count as better
  EdgeMounting mounting{{}, offset_from_edges(views)};
  for (const auto component : {&RecordedAttitude::roll, &RecordedAttitude::pitch}) {
    RecordedAttitude without = mounting.recorded;
    without.*component = false;
    const OffsetEstimate estimate = offset_from_edges(corrected(views, without, {}));
    if (!estimate.is_any_determined()) continue;
    const std::vector<EdgeView> before = corrected(views, mounting.recorded, mounting.estimate.offset),
                                after = corrected(views, without, estimate.offset);
    std::vector<EdgeAngles> angles;
    angles.reserve(views.size());
    for (std::size_t i = 0; i < views.size(); ++i)
      angles.push_back(edge_angles(std::span(&before[i], 1), std::span(&after[i], 1)));
    Random random(1, views.size());
    int better = 0;
    for (int sample = 0; sample < kSamples; ++sample) {
      EdgeAngles all;
      for (std::size_t i = 0; i < angles.size(); ++i) {
        const EdgeAngles& one = angles[random.below(angles.size())];
        all.before.insert(all.before.end(), one.before.begin(), one.before.end());
        all.after.insert(all.after.end(), one.after.begin(), one.after.end());
      }
      if (weighted_median(std::move(all.after)) < kBetter * weighted_median(std::move(all.before))) ++better;
    }
    if (better < kMostOften) continue;
    mounting = {without, estimate};
  }
  return mounting;
}

std::vector<EdgeView> corrected(std::span<const EdgeView> views, const RecordedAttitude& recorded,
                                const CameraOffset& offset) {
  std::vector<EdgeView> all(views.begin(), views.end());
  for (EdgeView& view : all) view.robot_from_camera = turned(with_recorded(view.robot_from_camera, recorded), offset);
  return all;
}

EdgeAngles edge_angles(std::span<const EdgeView> before, std::span<const EdgeView> after) {
  EdgeAngles angles;
  for (std::size_t i = 0; i < before.size(); ++i) {
    const Eigen::Vector3d up_before = up_in_camera(before[i], {}), up_after = up_in_camera(after[i], {});
    for (const PlaneEdge& edge : on_plane(before[i])) {
      const double first = std::abs(angle_of(edge, up_before)), second = std::abs(angle_of(edge, up_after));
      if (std::min(first, second) > kNearlyVertical) continue;
      angles.before.push_back({first, edge.weight});
      angles.after.push_back({second, edge.weight});
    }
  }
  return angles;
}

std::vector<WeightedResidual> angles_with_own_offsets(std::span<const EdgeView> views, double noise) {
  std::vector<WeightedResidual> all;
  if (!(noise > 0.0)) return all;
  for (const EdgeView& view : views) {
    const std::array halves{every_second_edge(view, 0), every_second_edge(view, 1)};
    for (std::size_t i = 0; i < halves.size(); ++i) {
      const std::span other(&halves[1 - i], 1);
      const std::vector<WeightedResidual> angles =
          edge_angles(other, corrected(other, {}, own_offset(halves[i], noise))).after;
      all.insert(all.end(), angles.begin(), angles.end());
    }
  }
  return all;
}

}  // namespace reorient
