// SPDX-License-Identifier: MIT
#include "perception/room/view/view_grid.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/angle.h"
#include "geometry/bytes.h"
#include "geometry/pinned_math.h"
#include "perception/room/view/azimuth.h"

namespace reorient {

void ViewGrid::spread(int cells) {
  const auto count = static_cast<std::size_t>(cells);
  first_ = 0.0;
  fractions_.assign(count, 1.0 / static_cast<double>(count));
  weights_.resize(count);
}

double ViewGrid::width() const { return 2.0 * kPi / static_cast<double>(fractions_.size()); }

ViewCell ViewGrid::cell(std::size_t i) const {
  return {to_azimuth(first_ + static_cast<double>(i) * width()), fractions_[i]};
}

void ViewGrid::rotate_by_180_degrees() { first_ = opposite(first_); }

/// Checks values after reading.
void ViewGrid::check(std::size_t count) const {
  check_bytes(fractions_.size() == count, "view filter: the number of cells differs from the parameters");
  check_bytes(std::abs(first_) <= kPi, "view filter: the azimuth of the first cell is invalid");
  for (const double fraction : fractions_) check_bytes(fraction >= 0.0, "view filter: the weight of a cell is invalid");
  const double sum = std::accumulate(fractions_.begin(), fractions_.end(), 0.0);
  check_bytes(count == 0 || std::abs(sum - 1.0) < 1e-6, "view filter: the weights of the cells do not sum up to 1");
}

void ViewGrid::predict(double motion, double step, const ViewFilterParameters& parameters) {
  first_ = to_azimuth(first_ + motion);
  const double deviation = parameters.noise / width();
  blur(deviation * deviation * step);
}

/// A random walk with a variance in cells squared, in steps to the neighboring cells.
void ViewGrid::blur(double variance) {
  constexpr double kMost = 0.5;  // variance of a step: a quarter to each side
  const double steps = std::ceil(variance / kMost);
  const double aside = steps > 0.0 ? 0.5 * variance / steps : 0.0;
  for (int step = 0; step < static_cast<int>(steps); ++step) {
    const double first = fractions_.front();
    double right = fractions_.back();
    for (std::size_t i = 0; i < fractions_.size(); ++i) {
      const double here = fractions_[i];
      const double left = i + 1 < fractions_.size() ? fractions_[i + 1] : first;
      fractions_[i] = (1.0 - 2.0 * aside) * here + aside * (right + left);
      right = here;
    }
  }
}

void ViewGrid::correct(const ViewpointScores& scores, double view_center, double step,
                       const ViewFilterParameters& parameters) {
  if (!scores.evidence()) return;
  const double column_width = 2.0 * kPi / scores.columns();
  const double first = angle_difference(first_, view_center) / column_width;
  for (std::size_t i = 0; i < fractions_.size(); ++i) {
    const double turn = first + static_cast<double>(i) * width() / column_width;
    weights_[i] = -parameters.sharpness * step * (scores.distance(turn) - scores.least());
  }
  pinned::exp(weights_);
  for (std::size_t i = 0; i < fractions_.size(); ++i) weights_[i] *= fractions_[i];
  const double sum = std::accumulate(weights_.begin(), weights_.end(), 0.0);
  // If all weights underflow, the belief is far from the truth. Then only the leak applies.
  if (sum > 0.0) {
    for (std::size_t i = 0; i < fractions_.size(); ++i) fractions_[i] = weights_[i] / sum;
  }
  const double leaked = -pinned::expm1(-step / parameters.leak);
  const double even = 1.0 / static_cast<double>(fractions_.size());
  for (double& fraction : fractions_) fraction += leaked * (even - fraction);
}

double ViewGrid::share_near(double azimuth, double half_width) const {
  const auto count = static_cast<double>(fractions_.size());
  // In cells from the right edge of the first cell.
  double position = angle_difference(azimuth - half_width, first_) / width() + 0.5;
  if (position < 0.0) position += count;
  double left = std::min(2.0 * half_width / width(), count);
  double sum = 0.0;
  while (left > 0.0) {
    const double cell = std::min(std::floor(position), count - 1.0);
    const double part = std::min(left, cell + 1.0 - position);
    sum += part * fractions_[static_cast<std::size_t>(cell)];
    left = part < left ? left - part : 0.0;
    position = cell + 1.0 < count ? cell + 1.0 : 0.0;
  }
  return sum;
}

void ViewGrid::find_clusters(std::vector<ViewCluster>& clusters) const {
  const std::size_t count = fractions_.size();
  const double least = 2.0 / static_cast<double>(count);
  const auto stands_out = [&](std::size_t i) { return fractions_[i % count] > least; };
  // The circle is opened at a cell with little weight, so that no cluster is cut. At least half of the circle has such
  // cells.
  std::size_t begin = 0;
  while (begin < count && stands_out(begin)) ++begin;
  for (const std::size_t stop = begin + count; begin < stop;) {
    std::size_t end = begin;
    double fraction = 0.0, first_moment = 0.0, second_moment = 0.0;
    for (; end < stop && stands_out(end); ++end) {
      const auto at = static_cast<double>(end - begin);
      fraction += fractions_[end % count];
      first_moment += at * fractions_[end % count];
      second_moment += at * at * fractions_[end % count];
    }
    if (end > begin) {
      const double mean = first_moment / fraction;
      const double variance = std::max(0.0, second_moment / fraction - mean * mean);
      clusters.push_back({to_azimuth(first_ + (static_cast<double>(begin) + mean) * width()),
                          std::sqrt(variance + 1.0 / 12.0) * width(), fraction});  // variance within a cell: 1/12
    }
    begin = end + 1;
  }
}

}  // namespace reorient
