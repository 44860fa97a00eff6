// SPDX-License-Identifier: MIT
#include "engine/world/external_belief.h"

#include <algorithm>
#include <cmath>

#include "localization/measurement/field_map.h"
#include "localization/reorientation.h"

namespace reorient {
namespace {

constexpr double kKnownRotation = 0.6;  // rad, standard deviation
constexpr double kKnownPosition = 1.5;  // m
constexpr double kFarthest = 1e3;       // m; farther away is outside of any field

bool is_pose(const Pose2& pose) {
  return std::isfinite(pose.rotation) && pose.position.allFinite() && pose.position.cwiseAbs().maxCoeff() < kFarthest;
}

bool is_covariance(const Eigen::Matrix3d& covariance) {
  return covariance.allFinite() && covariance.diagonal().minCoeff() >= 0.0;
}

}  // namespace

ExternalBeliefReader::ExternalBeliefReader(const FieldDimensions& field)
    : half_size_(believable_half_size(field)), clusters_(field) {}

/// False: no particle has weight.
bool ExternalBeliefReader::take_particles(std::span<const ExternalBelief::Particle> particles) {
  particles = particles.first(std::min(particles.size(), kMostExternalParticles));
  if (particles_.size() != particles.size()) particles_ = ParticleSet(particles.size());
  double heaviest = 0.0;
  for (const ExternalBelief::Particle& particle : particles) {
    if (is_pose(particle.pose) && std::isfinite(particle.weight)) heaviest = std::max(heaviest, particle.weight);
  }
  if (heaviest <= 0.0) return false;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    const ExternalBelief::Particle& particle = particles[i];
    const bool counts = is_pose(particle.pose) && std::isfinite(particle.weight) && particle.weight > 0.0;
    const Pose2 pose = counts ? particle.pose : Pose2();
    particles_.set_pose(i, {pose.position.cwiseMax(-half_size_).cwiseMin(half_size_), pose.rotation});
    particles_.weight[i] = counts ? static_cast<float>(particle.weight / heaviest) : 0.0f;
  }
  normalize_weights(particles_);
  return true;
}

std::optional<PoseBelief> ExternalBeliefReader::read(const std::optional<ExternalBelief>& external,
                                                     const PoseBelief& last, const PoseClusterParameters& parameters) {
  poses_.clear();
  if (!external) return std::nullopt;
  if (!external->particles.empty()) {
    if (!take_particles(external->particles)) return std::nullopt;
    for (std::size_t i = 0; i < particles_.size(); ++i) {
      if (particles_.weight[i] > 0.0f) poses_.push_back(particles_.pose(i));
    }
    return clusters_.find(particles_, last, parameters);
  }
  if (!is_pose(external->pose) || !is_covariance(external->covariance)) return std::nullopt;
  const Pose2 pose(external->pose.position.cwiseMax(-half_size_).cwiseMin(half_size_), external->pose.rotation);
  poses_.push_back(pose);
  return PoseBelief{.pose = pose, .covariance = external->covariance, .cluster_weight = 1.0, .reflected_weight = 0.0};
}

bool is_known(const PoseBelief& belief) {
  const Eigen::Vector3d variance = belief.covariance.diagonal();
  return belief.cluster_weight > 0.5 && variance.z() < kKnownRotation * kKnownRotation &&
         variance.head<2>().maxCoeff() < kKnownPosition * kKnownPosition;
}

PoseBelief expected_after(Reorientation reorientation, const PoseBelief& belief) {
  PoseBelief expected = belief;
  switch (reorientation) {
    case Reorientation::flip_pose:
      expected = flipped(belief);
      break;
    case Reorientation::purge_reflection:
      expected.reflected_weight = 0.0;
      break;
    case Reorientation::reset_orientation:
      expected.covariance.row(2).setZero();
      expected.covariance.col(2).setZero();
      expected.covariance(2, 2) = kPi * kPi / 3.0;  // uniform over all directions
      break;
  }
  return expected;
}

}  // namespace reorient
