// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/horizon_features.h"

#include <algorithm>
#include <cmath>

namespace reorient {
namespace {

/// Widths in samples of the row: those of SURF's first two octaves that lie between two others.
constexpr std::array<int, 4> kFilters{15, 21, 27, 39};
constexpr int kPartSamples = 5;  // in each of the three parts of a descriptor

}  // namespace

double distance(const HorizonDescriptor& a, const HorizonDescriptor& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double difference = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += difference * difference;
  }
  return std::sqrt(sum);
}

std::span<const HorizonFeature> HorizonFeatureFinder::find(std::span<const float> row, double contrast) {
  features_.clear();
  sums_.assign(1, 0.0f);
  for (const float value : row) sums_.push_back(sums_.back() + value);
  if (row.empty() || !(sums_.back() > 0.0f)) return {};
  const float least = static_cast<float>(contrast) * sums_.back() / static_cast<float>(row.size());
  for (const int filter : kFilters) {
    respond(filter, responses_);
    for (int i = filter / 2 + 1; i + filter / 2 + 1 < size(); ++i) {
      const auto at = [&](int place) { return std::abs(responses_[static_cast<std::size_t>(place)]); };
      if (at(i) < least || at(i - 1) >= at(i) || at(i + 1) > at(i)) continue;
      HorizonFeature feature{i, filter, responses_[static_cast<std::size_t>(i)] > 0.0f, {}};
      if (describe(feature)) features_.push_back(feature);
    }
  }
  return features_;
}

/// The middle third's mean less that of the whole filter: a second derivative.
void HorizonFeatureFinder::respond(int filter, std::vector<float>& responses) const {
  const int half = filter / 2, lobe = filter / 6;  // to either side of the middle
  responses.assign(static_cast<std::size_t>(size()), 0.0f);
  for (int i = half; i + half < size(); ++i) {
    const float whole = mean(i - half, i + half + 1);
    const float middle = mean(i - lobe, i + lobe + 1);
    responses[static_cast<std::size_t>(i)] = middle - whole;
  }
}

bool HorizonFeatureFinder::describe(HorizonFeature& feature) const {
  const double scale = 1.2 * feature.filter / 9.0;  // SURF's: its smallest filter is of 1.2
  const int arm = std::max(1, static_cast<int>(std::lround(scale)));
  float length = 0.0f;
  for (int part = 0; part < 3; ++part) {
    float signed_sum = 0.0f, absolute_sum = 0.0f;
    for (int k = 0; k < kPartSamples; ++k) {
      const int step = (part - 1) * kPartSamples + k - kPartSamples / 2;
      const int at = feature.place + static_cast<int>(std::lround(step * scale));
      if (at - arm < 0 || at + arm > size()) return false;
      const float response = sum(at, at + arm) - sum(at - arm, at);
      signed_sum += response;
      absolute_sum += std::abs(response);
    }
    feature.descriptor[static_cast<std::size_t>(2 * part)] = signed_sum;
    feature.descriptor[static_cast<std::size_t>(2 * part + 1)] = absolute_sum;
    length += signed_sum * signed_sum + absolute_sum * absolute_sum;
  }
  if (!(length > 0.0f)) return false;
  for (float& value : feature.descriptor) value /= std::sqrt(length);
  return true;
}

}  // namespace reorient
