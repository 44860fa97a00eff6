// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/color_classes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "geometry/pinned_math.h"
#include "geometry/random.h"

namespace reorient {
namespace {

constexpr int kMostClasses = 64;
using Place = std::array<double, 3>;

Place place_of(const Ycbcr& color, double chroma) {
  return {static_cast<double>(color.y), chroma * color.cb, chroma * color.cr};
}

double squared_distance(const Place& a, const Place& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

std::size_t nearest(const Place& place, const std::vector<Place>& centers) {
  std::size_t best = 0;
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < centers.size(); ++i) {
    const double distance = squared_distance(place, centers[i]);
    if (distance >= least) continue;
    least = distance;
    best = i;
  }
  return best;
}

/// Draws each center with a probability proportional to the squared distance from the centers drawn before.
std::vector<Place> first_centers(const std::vector<Place>& places, std::size_t count, Random& random) {
  std::vector<Place> centers{places[random.below(places.size())]};
  std::vector<double> distances(places.size(), std::numeric_limits<double>::infinity());
  while (centers.size() < count) {
    double sum = 0.0;
    for (std::size_t i = 0; i < places.size(); ++i) {
      distances[i] = std::min(distances[i], squared_distance(places[i], centers.back()));
      sum += distances[i];
    }
    if (sum <= 0.0) break;
    double drawn = random.uniform() * sum;
    std::size_t chosen = 0;
    while (chosen + 1 < places.size() && (drawn -= distances[chosen]) >= 0.0) ++chosen;
    centers.push_back(places[chosen]);
  }
  return centers;
}

std::uint8_t byte(double value) { return static_cast<std::uint8_t>(std::clamp(std::lround(value), 0L, 255L)); }

}  // namespace

ColorClasses ColorClasses::of(std::span<const Ycbcr> colors, int classes, double chroma, std::uint64_t seed) {
  ColorClasses result;
  result.table_.assign(static_cast<std::size_t>(kCells * kCells * kCells), 0);
  if (colors.empty()) return result;
  std::vector<Place> places;
  places.reserve(colors.size());
  for (const Ycbcr& color : colors) places.push_back(place_of(color, chroma));
  Random random(seed, 0xC1A55);
  std::vector<Place> centers =
      first_centers(places, static_cast<std::size_t>(std::clamp(classes, 1, kMostClasses)), random);
  constexpr int kRounds = 20;
  for (int round = 0; round < kRounds; ++round) {
    std::vector<Place> sums(centers.size(), Place{});
    std::vector<int> counts(centers.size(), 0);
    for (const Place& place : places) {
      const std::size_t mine = nearest(place, centers);
      for (std::size_t i = 0; i < place.size(); ++i) sums[mine][i] += place[i];
      ++counts[mine];
    }
    for (std::size_t c = 0; c < centers.size(); ++c) {
      if (counts[c] == 0) continue;
      for (std::size_t i = 0; i < centers[c].size(); ++i) centers[c][i] = sums[c][i] / counts[c];
    }
  }
  result.count_ = static_cast<int>(centers.size());
  constexpr int kMiddle = 1 << (kShift - 1);
  for (int y = 0; y < 256; y += 1 << kShift) {
    for (int cb = 0; cb < 256; cb += 1 << kShift) {
      for (int cr = 0; cr < 256; cr += 1 << kShift) {
        const Ycbcr color{static_cast<std::uint8_t>(y + kMiddle), static_cast<std::uint8_t>(cb + kMiddle),
                          static_cast<std::uint8_t>(cr + kMiddle)};
        result.table_[cell_of(color)] = static_cast<std::uint8_t>(nearest(place_of(color, chroma), centers));
      }
    }
  }
  return result;
}

void RunningLight::add(const Ycbcr& color) {
  constexpr int kDark = 15, kBright = 245;  // beyond these the camera saturates
  if (color.y <= kDark || color.y >= kBright) return;
  sum_luma_ += color.y;
  sum_cb_ += color.cb;
  sum_cr_ += color.cr;
  ++pixels_;
}

void RunningLight::next_frame(double time, double memory) {
  if (!std::isfinite(time)) return;
  constexpr int kLeast = 50;
  if (memory > 0.0 && pixels_ >= kLeast) {
    const double elapsed = std::max(0.0, time - last_time_);
    const double share = known_ ? 1.0 - pinned::exp(-elapsed / memory) : 1.0;
    luma_ += share * (sum_luma_ / pixels_ - luma_);
    cb_ += share * (sum_cb_ / pixels_ - cb_);
    cr_ += share * (sum_cr_ / pixels_ - cr_);
    last_time_ = time;
    known_ = true;
  }
  sum_luma_ = sum_cb_ = sum_cr_ = 0.0;
  pixels_ = 0;
}

Ycbcr RunningLight::without_light(const Ycbcr& color) const {
  if (!known_) return color;
  const double gain = 115.0 / std::max(luma_, 1.0);
  return {byte(gain * color.y), byte(color.cb - cb_ + 128.0), byte(color.cr - cr_ + 128.0)};
}

}  // namespace reorient
