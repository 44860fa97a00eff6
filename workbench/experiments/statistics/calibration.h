// SPDX-License-Identifier: MIT
// Compares stated probabilities with observed frequencies.
#pragma once

#include <span>
#include <vector>

namespace reorient {

/// Samples with about the same probability.
struct CalibrationBin {
  int samples = 0;
  int right = 0;      ///< number of samples whose more probable pose was the true one
  double said = 0.0;  ///< sum of the probabilities of that pose, each at least 0.5

  double certainty() const { return said / samples; }
  double accuracy() const { return static_cast<double>(right) / samples; }
};

/// `log_odds`: evidence for the truth, each; a negative value supported the wrong one of the two. From the least
/// certain bin to the most certain one, without empty bins.
std::vector<CalibrationBin> calibration_bins(std::span<const double> log_odds);

/// The expected calibration error: the mean over all samples of the difference between certainty and accuracy of
/// their bin.
double calibration_error(std::span<const CalibrationBin> bins);

}  // namespace reorient
