// SPDX-License-Identifier: MIT
#include "workbench/run/frame_times.h"

#include <algorithm>
#include <cmath>

namespace reorient {
namespace {

const double kClassWidth = std::log(1.01);

}  // namespace

void TimeHistogram::add(double seconds) {
  const double place = seconds > kShortest ? std::log(seconds / kShortest) / kClassWidth : 0.0;
  ++counts_[std::min(static_cast<std::size_t>(place), kClasses - 1)];
  ++count_;
  longest_ = std::max(longest_, seconds);
}

/// The nearest rank: the class of the smallest value that is not less than this fraction of all.
double TimeHistogram::rank(double share) const {
  const double wanted = std::max(1.0, std::ceil(share * static_cast<double>(count_)));
  std::uint64_t passed = 0;
  for (std::size_t i = 0; i < kClasses; ++i) {
    passed += counts_[i];
    if (static_cast<double>(passed) >= wanted)
      return std::min(kShortest * std::exp((static_cast<double>(i) + 0.5) * kClassWidth), longest_);
  }
  return longest_;
}

TimeQuantiles TimeHistogram::quantiles() const {
  if (count_ == 0) return {};
  return {rank(0.5), rank(0.99), longest_};
}

}  // namespace reorient
