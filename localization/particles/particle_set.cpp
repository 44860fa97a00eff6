#include "localization/particles/particle_set.h"

#include <algorithm>
#include <cmath>

namespace reorient {

ParticleSet::ParticleSet(std::size_t count)
    : x(count), y(count), rotation(count), cosine(count, 1.0f), sine(count), weight(count) {
  normalize_weights(*this);
}

void ParticleSet::set_pose(std::size_t index, const Pose2& pose) {
  x[index] = static_cast<float>(pose.position.x());
  y[index] = static_cast<float>(pose.position.y());
  set_rotation(index, to_binary_angle(pose.rotation));
}

void ParticleSet::set_rotation(std::size_t index, BinaryAngle angle) {
  rotation[index] = angle;
  cosine[index] = reorient::cosine(angle);
  sine[index] = reorient::sine(angle);
}

/// After reading: throws BadBytes where these are no particles.
void ParticleSet::complete() {
  check_bytes(!x.empty() && y.size() == x.size() && rotation.size() == x.size() && weight.size() == x.size(),
              "the pose particles are incomplete");
  cosine.resize(x.size());
  sine.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    check_bytes(std::isfinite(x[i]) && std::isfinite(y[i]) && std::isfinite(weight[i]) && weight[i] >= 0.0f,
                "a pose particle is nowhere");
    set_rotation(i, rotation[i]);
  }
}

void normalize_weights(ParticleSet& particles) {
  double sum = 0.0;
  for (const float weight : particles.weight) sum += weight;
  if (!(sum > 0.0) || !std::isfinite(sum)) {
    std::fill(particles.weight.begin(), particles.weight.end(), 1.0f / static_cast<float>(particles.size()));
    return;
  }
  const auto factor = static_cast<float>(1.0 / sum);
  for (float& weight : particles.weight) weight *= factor;
}

double effective_sample_size(const ParticleSet& particles) {
  double squares = 0.0;
  for (const float weight : particles.weight) squares += static_cast<double>(weight) * weight;
  return 1.0 / squares;
}

void resample_systematic(const ParticleSet& from, ParticleSet& to, double offset) {
  const std::size_t count = to.size();
  const double step = 1.0 / static_cast<double>(count);
  std::size_t source = 0;
  double reached = from.weight[0];
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = (static_cast<double>(i) + offset) * step;
    // The last particle with a weight ends the search: rounding may leave the sum just short of 1.
    while (reached <= wanted && source + 1 < from.size()) reached += from.weight[++source];
    while (from.weight[source] <= 0.0f && source > 0) --source;
    to.x[i] = from.x[source];
    to.y[i] = from.y[source];
    to.rotation[i] = from.rotation[source];
    to.cosine[i] = from.cosine[source];
    to.sine[i] = from.sine[source];
  }
  std::fill(to.weight.begin(), to.weight.end(), static_cast<float>(step));
}

}  // namespace reorient
