// SPDX-License-Identifier: MIT
// Interest points of a row of brightness, with descriptors: SURF (Bay et al. 2006) in one dimension, as
// Anderson, Yusmanthia, Hengst and Sowmya published it at RoboCup 2012 (docs/peers.md has the title).
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
  bool bright = false;  ///< brighter than its surroundings
  HorizonDescriptor descriptor{};
};

/// Distance from 0 (the same) to 2.
double distance(const HorizonDescriptor& a, const HorizonDescriptor& b);

class HorizonFeatureFinder {
 public:
  /// `contrast`: smallest difference between a point and its surroundings, as a fraction of the row's mean. Leaves out
  /// features whose surroundings reach beyond the row. Valid until the next call.
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
