// SPDX-License-Identifier: MIT
#include "localization/particles/particle_set.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr float kLeastWeight = 1e-12f;  // lower limit, so that no frame rules out a particle for good

/// Computed as several independent minima, for instruction-level parallelism.
float least_of(const std::vector<float>& values) {
  std::array<float, 16> least;
  least.fill(std::numeric_limits<float>::max());
  std::size_t i = 0;
  for (; i + least.size() <= values.size(); i += least.size()) {
    for (std::size_t j = 0; j < least.size(); ++j) least[j] = std::min(least[j], values[i + j]);
  }
  for (; i < values.size(); ++i) least[0] = std::min(least[0], values[i]);
  return *std::min_element(least.begin(), least.end());
}

/// Sum of term(value) over all values: as four independent sums, for instruction-level parallelism, and in the same
/// order on every machine.
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

/// Checks the state after reading: throws BadBytes if the particles are invalid.
void ParticleSet::complete() {
  check_bytes(!x.empty() && y.size() == x.size() && rotation.size() == x.size() && weight.size() == x.size(),
              "pose particles: lists of different lengths, or empty");
  cosine.resize(x.size());
  sine.resize(x.size());
  for (std::size_t i = 0; i < x.size(); ++i) {
    check_bytes(std::isfinite(x[i]) && std::isfinite(y[i]) && std::isfinite(weight[i]) && weight[i] >= 0.0f,
                "pose particles: an invalid position or weight");
    set_rotation(i, rotation[i]);
  }
}

void weigh(ParticleSet& particles, std::vector<float>& costs, float fraction) {
  const float least = least_of(costs);
  for (float& cost : costs) cost = fraction * (least - cost);
  pinned::exp(costs);
  for (std::size_t i = 0; i < particles.size(); ++i)
    particles.weight[i] = std::max(particles.weight[i] * costs[i], kLeastWeight);
  normalize_weights(particles);
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

// Without branches that depend on the weights: the processor would predict half of them wrong, which would take longer
// than everything else.
void resample_systematic(const ParticleSet& from, ParticleSet& to, double offset) {
  constexpr std::size_t kBlock = 4;  // particles with independent sums
  const std::size_t count = to.size();
  const auto most = static_cast<double>(count);
  // Until the last loop, to.rotation contains the index of a particle where its copies begin.
  std::fill(to.rotation.begin(), to.rotation.end(), BinaryAngle{0});
  std::size_t taken = 0;
  const auto begin_copies = [&](std::size_t source, double weights_to_here) {
    // A particle without copies is overwritten by the next one.
    if (from.weight[source] > 0.0f && taken < count) to.rotation[taken] = static_cast<BinaryAngle>(source);
    const double end = std::min(most, weights_to_here * most - offset);
    const auto whole = static_cast<std::int32_t>(end);
    taken = std::max(taken, static_cast<std::size_t>(std::max(0, whole + (static_cast<double>(whole) < end ? 1 : 0))));
  };
  double before = 0.0;
  std::size_t source = 0;
  for (; source + kBlock <= from.size(); source += kBlock) {
    std::array<double, kBlock> sums{};
    double sum = 0.0;
    for (std::size_t j = 0; j < kBlock; ++j) sums[j] = sum += from.weight[source + j];
    for (std::size_t j = 0; j < kBlock; ++j) begin_copies(source + j, before + sums[j]);
    before += sum;
  }
  for (; source < from.size(); ++source) begin_copies(source, before += from.weight[source]);

  std::size_t copied = 0;
  for (std::size_t i = 0; i < count; ++i) {
    copied = std::max(copied, static_cast<std::size_t>(to.rotation[i]));
    to.x[i] = from.x[copied];
    to.y[i] = from.y[copied];
    to.rotation[i] = from.rotation[copied];
    to.cosine[i] = from.cosine[copied];
    to.sine[i] = from.sine[copied];
  }
  std::fill(to.weight.begin(), to.weight.end(), static_cast<float>(1.0 / most));
}

}  // namespace reorient
