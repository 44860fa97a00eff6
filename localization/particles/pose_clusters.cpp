// SPDX-License-Identifier: MIT
#include "localization/particles/pose_clusters.h"

#include <algorithm>
#include <cmath>

namespace reorient {
namespace {

constexpr double kBinStep = 0.5;  // m; a bin is two steps wide, so that neighbors overlap by half
constexpr int kTurnSteps = 8;     // steps of rotation in a full turn; again a bin is two of them wide
const PoseClusterParameters kBin{
    .radius = 1.5 * kBinStep, .max_rotation_difference = 2.0 * kPi / kTurnSteps, .lead_to_switch = 1.0};
constexpr int kMostShifts = 5;
constexpr double kShiftEnds = 1e-3;  // m and rad

struct Cluster {
  Pose2 mean;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  double fraction = 0.0;
};

/// Calls take(offset, weight) for each particle near `center`; the offset from it is in m, m and rad.
template <typename Take>
void for_each_near(const ParticleSet& particles, const Pose2& center, const PoseClusterParameters& p,
                   const Take& take) {
  const auto x = static_cast<float>(center.position.x());
  const auto y = static_cast<float>(center.position.y());
  const BinaryAngle rotation = to_binary_angle(center.rotation);
  const auto square_radius = static_cast<float>(p.radius * p.radius);
  const auto max_rotation_difference = static_cast<float>(p.max_rotation_difference * kBinaryAnglesPerRadian);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const float dx = particles.x[i] - x;
    const float dy = particles.y[i] - y;
    const auto turn = static_cast<float>(static_cast<std::int32_t>(particles.rotation[i] - rotation));
    if (dx * dx + dy * dy <= square_radius && std::abs(turn) <= max_rotation_difference) {
      take(Eigen::Vector3d(dx, dy, turn / kBinaryAnglesPerRadian), static_cast<double>(particles.weight[i]));
    }
  }
}

Cluster cluster_around(const ParticleSet& particles, const Pose2& center, const PoseClusterParameters& parameters) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
  double fraction = 0.0;
  for_each_near(particles, center, parameters, [&](const Eigen::Vector3d& offset, double weight) {
    sum += weight * offset;
    squares += weight * offset * offset.transpose();
    fraction += weight;
  });
  if (fraction <= 0.0) return {center, Eigen::Matrix3d::Zero(), 0.0};
  const Eigen::Vector3d mean = sum / fraction;
  return {Pose2(center.position + mean.head<2>(), center.rotation + mean.z()),
          squares / fraction - mean * mean.transpose(), fraction};
}

Cluster shift_mean(const ParticleSet& particles, const Pose2& start, const PoseClusterParameters& parameters) {
  Cluster cluster = cluster_around(particles, start, parameters);
  Pose2 before = start;
  for (int i = 1; i < kMostShifts; ++i) {
    const double shift = (cluster.mean.position - before.position).norm() +
                         std::abs(angle_difference(cluster.mean.rotation, before.rotation));
    if (shift < kShiftEnds) break;
    before = cluster.mean;
    cluster = cluster_around(particles, before, parameters);
  }
  return cluster;
}

}  // namespace

double weight_near(const ParticleSet& particles, const Pose2& mean, const PoseClusterParameters& parameters) {
  double fraction = 0.0;
  for_each_near(particles, mean, parameters, [&](const Eigen::Vector3d&, double weight) { fraction += weight; });
  return std::min(fraction, 1.0);
}

PoseClusters::PoseClusters(const FieldDimensions& field) {
  const Eigen::Vector2d half_size = believable_half_size(field);
  half_length_ = half_size.x();
  half_width_ = half_size.y();
  columns_ = static_cast<int>(std::ceil(2.0 * half_length_ / kBinStep)) + 2;
  rows_ = static_cast<int>(std::ceil(2.0 * half_width_ / kBinStep)) + 2;
  bins_.resize(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) * kTurnSteps);
}

Pose2 PoseClusters::center_of_fullest_bin(const ParticleSet& particles) {
  std::fill(bins_.begin(), bins_.end(), 0.0f);
  std::size_t fullest = 0;
  const auto steps = static_cast<float>(1.0 / kBinStep);
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const auto column = static_cast<int>((particles.x[i] + static_cast<float>(half_length_)) * steps);
    const auto row = static_cast<int>((particles.y[i] + static_cast<float>(half_width_)) * steps);
    const auto turn = static_cast<int>(particles.rotation[i] >> 29);
    // Bin k reaches from step k - 1 to step k + 1: each particle is in two of them along each axis.
    for (const int t : {turn, (turn + 1) % kTurnSteps}) {
      for (const int r : {row, row + 1}) {
        for (const int c : {column, column + 1}) {
          const int index = (t * rows_ + r) * columns_ + c;
          const auto bin = static_cast<std::size_t>(index);
          bins_[bin] += particles.weight[i];
          if (bins_[bin] > bins_[fullest]) fullest = bin;
        }
      }
    }
  }
  const int bin = static_cast<int>(fullest);
  const int column = bin % columns_;
  const int row = bin / columns_ % rows_;
  const int turn = bin / columns_ / rows_;
  return {column * kBinStep - half_length_, row * kBinStep - half_width_, turn * 2.0 * kPi / kTurnSteps};
}

PoseBelief PoseClusters::find(const ParticleSet& particles, const PoseBelief& last,
                              const PoseClusterParameters& parameters) {
  Cluster believed = shift_mean(particles, last.pose, parameters);
  // If this cluster is heavy enough, no other one can lead.
  if (believed.fraction * (1.0 + parameters.lead_to_switch) < 1.0) {
    const Cluster bin = cluster_around(particles, center_of_fullest_bin(particles), kBin);
    const Cluster heaviest = shift_mean(particles, bin.mean, parameters);
    if (heaviest.fraction > parameters.lead_to_switch * believed.fraction) believed = heaviest;
  }
  return {believed.mean, believed.covariance, believed.fraction,
          weight_near(particles, reflect(believed.mean), parameters)};
}

}  // namespace reorient
