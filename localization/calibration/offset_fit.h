// SPDX-License-Identifier: MIT
// Fits a constant camera offset to residuals of many images, where many residuals are outliers: a grid for a start,
// then Gauss-Newton steps that alternate with the estimate of the noise (EM for a mixture of a normal distribution and
// a uniform one). Standard errors come from a bootstrap over the images (Efron and Tibshirani, 1993).
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
  double value = 0.0;   ///< rad; one that has no meaning under this offset is larger than the window
  double weight = 1.0;  ///< at least 0
};

struct OffsetProblem {
  std::size_t images = 0;
  /// Writes the residuals of one image under an offset: always as many, in the same order. Uses only one in `every`.
  std::function<void(std::size_t image, const CameraOffset& offset, std::size_t every,
                     std::vector<WeightedResidual>& residuals)>
      residuals;
  std::array<bool, kOffsetComponents> observable{};  ///< the others stay 0
  OffsetValues reach{};                              ///< of the grid to either side; 0: not on the grid
  OffsetValues step{};                               ///< of the grid
  OffsetValues prior{};                              ///< standard deviation of the prior around 0
  double window = 0.0;                               ///< rad; outliers are uniform in [-window, window]
  double cap = 0.0;                                  ///< rad, of a residual on the grid
  double least_noise = 0.0;                          ///< rad; the noise is never estimated smaller
  double least_inliers = 0.0;                        ///< fraction of the weight; with fewer nothing is determined
  std::size_t every = 1;                             ///< on the grid one residual in so many
};

struct OffsetEstimate {
  CameraOffset offset;
  /// Standard errors, rad and m; empty: the data do not determine this component, which is 0 in the offset.
  std::array<std::optional<double>, kOffsetComponents> deviation;
  double noise = 0.0;    ///< rad, standard deviation of the residuals that are no outliers
  double inliers = 0.0;  ///< fraction of the weight
  bool is_any_determined() const;
};

/// Components whose standard error would exceed `most`, or that lie at the end of the grid, are reported as not
/// determined, and the rest is fitted without them.
OffsetEstimate fit_offset(const OffsetProblem& problem, const OffsetValues& most);

/// The value that splits the weight in halves; 0 without values.
double weighted_median(std::vector<WeightedResidual> values);

}  // namespace reorient
