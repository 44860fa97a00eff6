// SPDX-License-Identifier: MIT
// Fits a constant camera offset to residuals of many images, of which many are outliers. Starts with a grid. Then
// Gauss-Newton steps alternate with the estimate of the noise (EM for a mixture of a normal and a uniform
// distribution). Standard errors come from a bootstrap over the images (Efron and Tibshirani, 1993).
#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "geometry/camera_offset.h"

namespace reorient {

/// The components of an offset: tilt, pan, roll (rad), height (m).
inline constexpr std::size_t kOffsetComponents = 4;
enum class OffsetComponent : std::size_t { tilt, pan, roll, height };
using OffsetValues = std::array<double, kOffsetComponents>;

OffsetValues values_of(const CameraOffset& offset);
CameraOffset offset_of(const OffsetValues& values);

struct WeightedResidual {
  double value = 0.0;   ///< rad; larger than the window if it is meaningless for this offset
  double weight = 1.0;  ///< non-negative
};

struct OffsetProblem {
  std::size_t images = 0;
  /// Writes the residuals of one image for an offset: always the same number, in the same order. Uses one in `every`.
  std::function<void(std::size_t image, const CameraOffset& offset, std::size_t every,
                     std::vector<WeightedResidual>& residuals)>
      residuals;
  std::array<bool, kOffsetComponents> observable{};  ///< the others stay 0
  OffsetValues reach{};                              ///< of the grid to both sides; 0: not on the grid
  OffsetValues step{};                               ///< of the grid
  OffsetValues prior{};                              ///< standard deviation of the prior around 0
  double window = 0.0;                               ///< rad; outliers are uniform in [-window, window]
  double cap = 0.0;                                  ///< rad; larger residuals on the grid are reduced to it
  double least_noise = 0.0;                          ///< rad, smallest estimate of the noise
  double least_inliers = 0.0;  ///< smallest fraction of the weight; with less, nothing is determined
  std::size_t every = 1;       ///< on the grid, one in this many residuals is used
};

struct OffsetEstimate {
  CameraOffset offset;
  /// Standard errors, rad and m. Empty if the data do not determine this component, which is 0 in the offset then.
  std::array<std::optional<double>, kOffsetComponents> deviation;
  double noise = 0.0;    ///< rad, standard deviation of the inliers
  double inliers = 0.0;  ///< fraction of the weight
  bool is_any_determined() const;
};

/// Reports components whose standard error would exceed `most`, or that are at the end of the grid, as not determined,
/// and fits the rest without them.
OffsetEstimate fit_offset(const OffsetProblem& problem, const OffsetValues& most);

/// The value at which half of the weight is reached; 0 without values.
double weighted_median(std::vector<WeightedResidual> values);

}  // namespace reorient
