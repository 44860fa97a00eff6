// SPDX-License-Identifier: MIT
#include "localization/reorientation.h"

#include <algorithm>
#include <utility>

namespace reorient {
namespace {

/// Squared distance of a particle from a pose, with one radian counted as one meter.
double square_distance(const ParticleSet& particles, std::size_t index, const Pose2& pose) {
  const Pose2 particle = particles.pose(index);
  const double turn = angle_difference(particle.rotation, pose.rotation);
  return (particle.position - pose.position).squaredNorm() + turn * turn;
}

}  // namespace

void flip_pose(ParticleSet& particles) {
  for (std::size_t i = 0; i < particles.size(); ++i) {
    particles.x[i] = -particles.x[i];
    particles.y[i] = -particles.y[i];
    particles.rotation[i] += kHalfTurn;
    particles.cosine[i] = -particles.cosine[i];
    particles.sine[i] = -particles.sine[i];
  }
}

PoseBelief flipped(const PoseBelief& belief) {
  PoseBelief result = belief;
  result.pose = reflect(belief.pose);
  // x and y change their signs, therefore so do their covariances with the rotation, but no others.
  result.covariance.topRightCorner<2, 1>() *= -1.0;
  result.covariance.bottomLeftCorner<1, 2>() *= -1.0;
  return result;
}

void purge_reflection(ParticleSet& particles, const Pose2& belief, ParticleSet& scratch, Random& random) {
  const Pose2 reflection = reflect(belief);
  const auto stays = [&](std::size_t i) {
    return square_distance(particles, i, belief) <= square_distance(particles, i, reflection);
  };
  double left = 0.0;
  bool all_stay = true;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (stays(i))
      left += particles.weight[i];
    else
      all_stay = false;
  }
  if (all_stay || left <= 0.0) return;
  for (std::size_t i = 0; i < particles.size(); ++i) {
    if (!stays(i)) particles.weight[i] = 0.0f;
  }
  normalize_weights(particles);
  resample_systematic(particles, scratch, random.uniform());
  std::swap(particles, scratch);
}

void reset_orientation(ParticleSet& particles, Random& random) {
  // Steps of the golden section cover the circle evenly, even for the few particles at one position, which are
  // neighbors in a resampled set.
  constexpr BinaryAngle kGoldenSection = 0x9E3779B9u;
  auto angle = static_cast<BinaryAngle>(random());
  for (std::size_t i = 0; i < particles.size(); ++i) particles.set_rotation(i, angle += kGoldenSection);
}

}  // namespace reorient
