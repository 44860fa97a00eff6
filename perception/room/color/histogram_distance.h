// SPDX-License-Identifier: MIT
// Distances between two color histograms (the paper's Section 3.4). Hellinger, Jensen-Shannon and chi-square
// distinguish poses best under changed light. The sum of squares over three bins is the paper's measure.
#pragma once

#include <array>
#include <span>

#include "perception/room/color/color_histogram.h"

namespace reorient {

enum class Distance {
  ssd3,            ///< sum of squared differences over the three largest bins of the perceived histogram
  ssd14,           ///< the same over all bins
  hellinger,       ///< sqrt(1 - sum sqrt(p q)), in [0, 1]
  jensen_shannon,  ///< sqrt of the divergence in bits, in [0, 1]
  /// sqrt(1/2 sum (p - q)^2 / (p + q)), in [0, 1]. This is the symmetric chi-square, since neither histogram is the
  /// expected one and bins of both may be empty. Its root is a metric (Le Cam, 1986), so that a cap has the same
  /// meaning as for the measures above.
  chi_square
};

struct DistanceParameters {
  Distance measure = Distance::hellinger;
  double cap = 0.5;
};
template <typename Visit>
void describe(DistanceParameters& p, Visit&& visit) {
  visit("measure", p.measure, {"ssd3", "ssd14", "hellinger", "jensen_shannon", "chi_square"},
        "distance measure between histograms");
  visit("cap", p.cap, 0.01, 2.0, "", "largest distance of a tile; greater distances are reduced to it");
}

/// A histogram prepared for many comparisons by one measure.
struct ComparedHistogram {
  std::array<float, 16> values{};  ///< the bins, or their roots for hellinger; the last two values are 0
  std::array<int, 3> dominant{};   ///< ssd3: the three greatest bins
};

ComparedHistogram prepared(Distance measure, const ColorHistogram& histogram);

/// The distance of two histograms that were prepared for the same measure. 0 for equal histograms.
double distance(Distance measure, const ComparedHistogram& perceived, const ComparedHistogram& model);

/// The distances of one histogram to many, faster than one by one. As many distances as models.
void distances(Distance measure, const ComparedHistogram& perceived, std::span<const ComparedHistogram* const> models,
               std::span<double> results);

/// For single comparisons, without preparation.
double distance(Distance measure, const ColorHistogram& perceived, const ColorHistogram& model);

}  // namespace reorient
