// SPDX-License-Identifier: MIT
#include "perception/room/view/view_particles.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/angle.h"
#include "geometry/bytes.h"
#include "geometry/pinned_math.h"
#include "perception/room/view/azimuth.h"

namespace reorient {
namespace {

/// Circular mean and standard deviation of azimuths, from their sines and cosines.
ViewCluster cluster_of(std::span<const double> azimuths, std::span<const double> sines, std::span<const double> cosines,
                       std::size_t of) {
  const double x = std::accumulate(cosines.begin(), cosines.end(), 0.0);
  const double y = std::accumulate(sines.begin(), sines.end(), 0.0);
  ViewCluster cluster;
  cluster.azimuth = to_azimuth(pinned::atan2(y, x));
  double squares = 0.0;
  for (const double azimuth : azimuths) {
    const double difference = angle_difference(azimuth, cluster.azimuth);
    squares += difference * difference;
  }
  cluster.spread = std::sqrt(squares / static_cast<double>(azimuths.size()));
  cluster.share = static_cast<double>(azimuths.size()) / static_cast<double>(of);
  return cluster;
}

}  // namespace

void ViewParticles::spread(int particles) {
  const auto count = static_cast<std::size_t>(particles);
  particles_.resize(count);
  resampled_.reserve(count);
  weights_.resize(count);
  sorted_.reserve(2 * count);
  sines_.resize(count);
  cosines_.resize(count);
  const double width = 2.0 * kPi / static_cast<double>(count);
  for (std::size_t i = 0; i < count; ++i) {
    particles_[i] = {to_azimuth((static_cast<double>(i) + random_.uniform()) * width),
                     1.0 / static_cast<double>(count)};
  }
}

void ViewParticles::rotate_by_180_degrees() {
  for (ViewParticle& particle : particles_) particle.azimuth = opposite(particle.azimuth);
}

/// Checks values after reading.
void ViewParticles::check(std::size_t count) const {
  check_bytes(particles_.size() == count, "view filter: the number of particles differs from the parameters");
  for (const ViewParticle& particle : particles_)
    check_bytes(std::abs(particle.azimuth) <= kPi && std::isfinite(particle.weight),
                "view filter: a particle has an invalid azimuth or weight");
}

void ViewParticles::predict(double motion, double step, const ViewFilterParameters& parameters) {
  const double deviation = parameters.noise * std::sqrt(step);
  for (ViewParticle& particle : particles_) {
    particle.azimuth = to_azimuth(particle.azimuth + motion + deviation * random_.normal());
  }
}

void ViewParticles::correct(const ViewpointScores& scores, double view_center, double step,
                            const ViewFilterParameters& parameters) {
  const double count = static_cast<double>(particles_.size());
  if (!scores.evidence()) {
    for (ViewParticle& particle : particles_) particle.weight = 1.0 / count;
    return;
  }
  const double column_width = 2.0 * kPi / scores.columns();
  for (std::size_t i = 0; i < particles_.size(); ++i) {
    const double turn = angle_difference(particles_[i].azimuth, view_center) / column_width;
    weights_[i] = -parameters.sharpness * step * (scores.distance(turn) - scores.least());
  }
  pinned::exp(weights_);
  const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  // If all weights underflow, no particle is near. Then all have the same weight.
  for (std::size_t i = 0; i < particles_.size(); ++i)
    particles_[i].weight = sum > 0.0 ? weights_[i] / sum : 1.0 / count;
  resample();
  // If all viewpoints have the same score, the best one is random, so nothing is injected.
  const double clear = parameters.clear_lead > 0.0 ? std::clamp(scores.lead() / parameters.clear_lead, 0.0, 1.0) : 1.0;
  inject(view_center + scores.best() * column_width, 0.5 * column_width, clear * parameters.injection * step * count);
}

void ViewParticles::resample() {
  resampled_.clear();
  const double spacing = 1.0 / static_cast<double>(particles_.size());
  double pointer = random_.uniform() * spacing;
  double passed = 0.0;
  std::size_t source = 0;
  while (resampled_.size() < particles_.size()) {
    while (source + 1 < particles_.size() && passed + particles_[source].weight < pointer) {
      passed += particles_[source++].weight;
    }
    resampled_.push_back(particles_[source]);
    pointer += spacing;
  }
  particles_.swap(resampled_);
}

void ViewParticles::inject(double azimuth, double half_width, double expected) {
  const auto injected = static_cast<std::size_t>(std::max(0.0, std::floor(expected + random_.uniform())));
  for (std::size_t i = 0; i < std::min(injected, particles_.size()); ++i) {
    const auto replaced = static_cast<std::size_t>(random_.below(particles_.size()));
    particles_[replaced].azimuth = to_azimuth(azimuth + random_.uniform(-half_width, half_width));
  }
}

double ViewParticles::share_near(double azimuth, double half_width) const {
  if (particles_.empty()) return 0.0;
  const auto near = std::count_if(particles_.begin(), particles_.end(), [&](const ViewParticle& particle) {
    return std::abs(angle_difference(particle.azimuth, azimuth)) <= half_width;
  });
  return static_cast<double>(near) / static_cast<double>(particles_.size());
}

void ViewParticles::find_clusters(std::vector<ViewCluster>& clusters) {
  constexpr double kGap = from_degrees(12.0);
  sorted_.clear();
  for (const ViewParticle& particle : particles_) sorted_.push_back(particle.azimuth);
  std::sort(sorted_.begin(), sorted_.end());
  const std::size_t count = sorted_.size();
  // The circle is opened at its first gap and laid out as two turns, so that no cluster is cut.
  for (std::size_t i = 0; i < count; ++i) sorted_.push_back(sorted_[i] + 2.0 * kPi);
  std::size_t start = 0;
  while (start < count && sorted_[start + 1] - sorted_[start] < kGap) ++start;
  start = start < count ? start + 1 : 0;
  pinned::sincos(std::span(sorted_).subspan(start, count), sines_, cosines_);
  std::size_t begin = start;
  for (std::size_t i = start; i < start + count; ++i) {
    const bool last = i + 1 == start + count;
    if (!last && sorted_[i + 1] - sorted_[i] < kGap) continue;
    const std::size_t size = i + 1 - begin;
    clusters.push_back(cluster_of(std::span(sorted_).subspan(begin, size),
                                  std::span(sines_).subspan(begin - start, size),
                                  std::span(cosines_).subspan(begin - start, size), count));
    begin = i + 1;
  }
}

}  // namespace reorient
