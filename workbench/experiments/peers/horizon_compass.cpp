// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/horizon_compass.h"

#include <algorithm>
#include <cmath>

namespace reorient {
namespace {

constexpr int kRowPlaces = 160;  // samples of the row, over the whole width of the image
constexpr int kMapSectors = 144;
constexpr int kLeastLooks = 10;  // frames; a sector with fewer is not used

}  // namespace

HorizonCompass::HorizonCompass(const HorizonCompassParameters& parameters)
    : parameters_(parameters), wall_(bare_wall(parameters.radius)), sectors_(kMapSectors) {}

/// The row and its features. False: the whole strip is not in view.
bool HorizonCompass::look(const RoomObservation& view) {
  features_ = {};
  const std::optional<HorizonCamera> camera = HorizonCamera::of(view, wall_);
  if (!camera) return false;
  camera->find(kRowPlaces, columns_);
  if (columns_.size() < 2) return false;
  row_.clear();
  const int block = std::max(1, camera->width() / kRowPlaces);
  for (const HorizonColumn& column : columns_) {
    const std::optional<double> top = camera->row_at(column.x, 0.5 * parameters_.band);
    const std::optional<double> bottom = camera->row_at(column.x, -0.5 * parameters_.band);
    if (!top || !bottom || *top < 0.0 || *bottom > camera->height() - 1.0 || *top > *bottom) return false;
    const int first = static_cast<int>(*top), last = static_cast<int>(*bottom);
    const int left = std::clamp(column.x - block / 2, 0, camera->width() - block);
    int sum = 0;
    for (int y = first; y <= last; ++y) {
      for (int x = left; x < left + block; ++x) sum += view.image.luma(x, y);
    }
    row_.push_back(static_cast<float>(sum) / static_cast<float>(block * (last - first + 1)));
  }
  features_ = finder_.find(row_, parameters_.contrast);
  return true;
}

HorizonCompass::Sector& HorizonCompass::sector_at(double azimuth) {
  return sectors_[static_cast<std::size_t>(sector_of(azimuth, kMapSectors))];
}

/// The most similar landmark near an azimuth, in its own sector and those beside it.
HorizonCompass::Match HorizonCompass::nearest(double azimuth, const HorizonFeature& feature, int least_seen) {
  Match best{nullptr, parameters_.cap};
  const int middle = sector_of(azimuth, kMapSectors);
  const int reach = 1 + static_cast<int>(parameters_.tolerance * kMapSectors / (2.0 * kPi));
  for (int i = -reach; i <= reach; ++i) {
    for (Landmark& landmark : sectors_[static_cast<std::size_t>((middle + i + kMapSectors) % kMapSectors)].landmarks) {
      const bool fits = landmark.bright == feature.bright && landmark.seen >= least_seen &&
                        std::abs(angle_difference(landmark.azimuth, azimuth)) <= parameters_.tolerance;
      if (!fits) continue;
      const double difference = distance(landmark.descriptor, feature.descriptor);
      if (difference < best.distance) best = {&landmark, difference};
    }
  }
  return best;
}

void HorizonCompass::add(double azimuth, const HorizonFeature& feature) {
  std::vector<Landmark>& landmarks = sector_at(azimuth).landmarks;
  const Landmark landmark{azimuth, feature.bright, feature.descriptor, 1};
  if (landmarks.size() < static_cast<std::size_t>(parameters_.landmarks)) {
    landmarks.push_back(landmark);
    return;
  }
  *std::min_element(landmarks.begin(), landmarks.end(),
                    [](const Landmark& a, const Landmark& b) { return a.seen < b.seen; }) = landmark;
}

void HorizonCompass::learn(const RoomObservation& view) {
  if (!look(view)) return;
  for (const HorizonColumn& column : columns_) {
    if (!column.covered) ++sector_at(column.azimuth).looked_at;
  }
  for (const HorizonFeature& feature : features_) {
    const HorizonColumn& column = columns_[static_cast<std::size_t>(feature.place)];
    if (column.covered) continue;
    const Match match = nearest(column.azimuth, feature, 1);
    if (match.landmark == nullptr || match.distance > parameters_.same) {
      add(column.azimuth, feature);
      continue;
    }
    Landmark& landmark = *match.landmark;
    constexpr int kLongest = 100;  // looks in the running mean
    const auto share = 1.0f / static_cast<float>(std::min(++landmark.seen, kLongest));
    for (std::size_t i = 0; i < landmark.descriptor.size(); ++i)
      landmark.descriptor[i] += share * (feature.descriptor[i] - landmark.descriptor[i]);
  }
}

double HorizonCompass::compare(const RoomObservation& view) {
  if (!look(view)) return score_;
  for (const HorizonFeature& feature : features_) {
    const HorizonColumn& column = columns_[static_cast<std::size_t>(feature.place)];
    const double reflected = normalize_angle(column.azimuth + kPi);
    if (column.covered || sector_at(column.azimuth).looked_at < kLeastLooks ||
        sector_at(reflected).looked_at < kLeastLooks)
      continue;
    score_ += nearest(column.azimuth, feature, parameters_.least_seen).distance -
              nearest(reflected, feature, parameters_.least_seen).distance;
  }
  return score_;
}

}  // namespace reorient
