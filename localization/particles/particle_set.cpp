#include "localization/particles/particle_set.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace reorient {
namespace {

/// Of term(value) over all: as four sums, which do not wait for each other, and on every machine in the same order.
template <typename Term>
double sum_of(const std::vector<float>& values, const Term& term) {
  std::array<double, 4> sums{};
  std::size_t i = 0;
  for (; i + sums.size() <= values.size(); i += sums.size()) {
    for (std::size_t j = 0; j < sums.size(); ++j) sums[j] += term(static_cast<double>(values[i + j]));
  }
  for (; i < values.size(); ++i) sums[0] += term(static_cast<double>(values[i]));
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

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
  const double sum = sum_of(particles.weight, [](double weight) { return weight; });
  if (!(sum > 0.0) || !std::isfinite(sum)) {
    std::fill(particles.weight.begin(), particles.weight.end(), 1.0f / static_cast<float>(particles.size()));
    return;
  }
  const auto factor = static_cast<float>(1.0 / sum);
  for (float& weight : particles.weight) weight *= factor;
}

double effective_sample_size(const ParticleSet& particles) {
  return 1.0 / sum_of(particles.weight, [](double weight) { return weight * weight; });
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
