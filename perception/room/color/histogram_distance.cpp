// SPDX-License-Identifier: MIT
#include "perception/room/color/histogram_distance.h"

#include <algorithm>
#include <cmath>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

std::array<int, 3> three_greatest(const ColorHistogram& histogram) {
  std::array<int, 3> greatest{};
  ColorHistogram left = histogram;
  for (int& bin : greatest) {
    const auto found = std::max_element(left.begin(), left.end());
    bin = static_cast<int>(found - left.begin());
    *found = -1.0f;
  }
  return greatest;
}

double squared(double value) { return value * value; }

double hellinger(float overlap) { return std::sqrt(std::max(0.0, 1.0 - static_cast<double>(overlap))); }

double hellinger(const ComparedHistogram& a, const ComparedHistogram& b) {
  float overlap = 0.0f;
  for (std::size_t i = 0; i < a.values.size(); ++i) overlap += a.values[i] * b.values[i];
  return hellinger(overlap);
}

/// Four sums in parallel. Each adds in the same order as a single one, but does not wait for the others.
void four_hellinger(const ComparedHistogram& a, const ComparedHistogram* const* b, double* results) {
  std::array<float, 4> overlaps{};
  for (std::size_t i = 0; i < kColorBins; ++i) {
    for (std::size_t k = 0; k < overlaps.size(); ++k) overlaps[k] += a.values[i] * b[k]->values[i];
  }
  for (std::size_t k = 0; k < overlaps.size(); ++k) results[k] = hellinger(overlaps[k]);
}

double jensen_shannon(const ComparedHistogram& a, const ComparedHistogram& b) {
  double divergence = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(kColorBins); ++i) {
    const double p = a.values[i];
    const double q = b.values[i];
    const double middle = 0.5 * (p + q);
    if (p > 0.0) divergence += 0.5 * p * pinned::log2(p / middle);
    if (q > 0.0) divergence += 0.5 * q * pinned::log2(q / middle);
  }
  return std::sqrt(std::max(0.0, divergence));
}

double chi_square(const ComparedHistogram& a, const ComparedHistogram& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(kColorBins); ++i) {
    const double p = a.values[i];
    const double q = b.values[i];
    if (p + q > 0.0) sum += squared(p - q) / (p + q);
  }
  return std::sqrt(0.5 * sum);
}

}  // namespace

ComparedHistogram prepared(Distance measure, const ColorHistogram& histogram) {
  ComparedHistogram result;
  std::copy(histogram.begin(), histogram.end(), result.values.begin());
  if (measure == Distance::ssd3) result.dominant = three_greatest(histogram);
  if (measure == Distance::hellinger) {
    for (float& value : result.values) value = std::sqrt(value);
  }
  return result;
}

double distance(Distance measure, const ComparedHistogram& perceived, const ComparedHistogram& model) {
  double sum = 0.0;
  switch (measure) {
    case Distance::ssd3:
      for (const int bin : perceived.dominant) {
        const auto i = static_cast<std::size_t>(bin);
        sum += squared(perceived.values[i] - model.values[i]);
      }
      return sum;
    case Distance::ssd14:
      for (std::size_t i = 0; i < perceived.values.size(); ++i) sum += squared(perceived.values[i] - model.values[i]);
      return sum;
    case Distance::jensen_shannon:
      return jensen_shannon(perceived, model);
    case Distance::chi_square:
      return chi_square(perceived, model);
    case Distance::hellinger:
      break;
  }
  return hellinger(perceived, model);
}

void distances(Distance measure, const ComparedHistogram& perceived, std::span<const ComparedHistogram* const> models,
               std::span<double> results) {
  std::size_t i = 0;
  if (measure == Distance::hellinger) {
    for (; i + 4 <= models.size(); i += 4) four_hellinger(perceived, &models[i], &results[i]);
  }
  for (; i < models.size(); ++i) results[i] = distance(measure, perceived, *models[i]);
}

double distance(Distance measure, const ColorHistogram& perceived, const ColorHistogram& model) {
  return distance(measure, prepared(measure, perceived), prepared(measure, model));
}

}  // namespace reorient
