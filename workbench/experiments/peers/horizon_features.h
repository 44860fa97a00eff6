// SPDX-License-Identifier: MIT
// Interest points of a row of brightness, and what is around each of them: SURF (Bay et al. 2006) in one dimension, as
// Anderson, Yusmanthia, Hengst and Sowmya have it, "Robot localisation using natural landmarks" (RoboCup 2012).
#pragma once

#include <array>
#include <span>
#include <vector>

namespace reorient {

/// Sum of a Haar wavelet's responses, and sum of their absolute values, left of the point, around it and right of it;
/// of unit length.
using HorizonDescriptor = std::array<float, 6>;

struct HorizonFeature {
  int place = 0;        ///< index in the row
  int filter = 0;       ///< width of the filter that responded
  bool bright = false;  ///< brighter than what is around it
  HorizonDescriptor descriptor{};
};

/// Between 0, the same, and 2.
double distance(const HorizonDescriptor& a, const HorizonDescriptor& b);

class HorizonFeatureFinder {
 public:
  /// `contrast`: how much brighter or darker than around it a point must be, as a share of the row's mean. A feature
  /// whose surroundings reach beyond the row does not count. Valid until the next call.
  std::span<const HorizonFeature> find(std::span<const float> row, double contrast);

 private:
  void respond(int filter, std::vector<float>& responses) const;
  bool describe(HorizonFeature& feature) const;
  float sum(int begin, int end) const {
    return sums_[static_cast<std::size_t>(end)] - sums_[static_cast<std::size_t>(begin)];
  }
  float mean(int begin, int end) const { return sum(begin, end) / static_cast<float>(end - begin); }
  int size() const { return static_cast<int>(sums_.size()) - 1; }

  std::vector<float> sums_;  // of the row up to each place
  std::vector<float> responses_;
  std::vector<HorizonFeature> features_;
};

}  // namespace reorient
