// SPDX-License-Identifier: MIT
#include "workbench/experiments/statistics/calibration.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace reorient {
namespace {

// Log-odds at which bins begin. Probabilities differ little above 5 (0.993), so wider bins are enough there.
constexpr std::array kBegins{0.0, 0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 7.0, 10.0};

}  // namespace

std::vector<CalibrationBin> calibration_bins(std::span<const double> log_odds) {
  std::vector<CalibrationBin> bins(kBegins.size());
  for (const double value : log_odds) {
    const double size = std::abs(value);
    std::size_t bin = 0;
    while (bin + 1 < kBegins.size() && size >= kBegins[bin + 1]) ++bin;
    ++bins[bin].samples;
    bins[bin].right += value > 0.0 ? 1 : 0;
    bins[bin].said += 1.0 / (1.0 + std::exp(-size));
  }
  std::erase_if(bins, [](const CalibrationBin& bin) { return bin.samples == 0; });
  return bins;
}

double calibration_error(std::span<const CalibrationBin> bins) {
  double sum = 0.0;
  int samples = 0;
  for (const CalibrationBin& bin : bins) {
    sum += std::abs(bin.right - bin.said);
    samples += bin.samples;
  }
  return samples > 0 ? sum / samples : 0.0;
}

}  // namespace reorient
