// SPDX-License-Identifier: MIT
// One image with its geometry and carpet color, in one value.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>

#include <Eigen/Core>

#include "geometry/angle.h"
#include "geometry/image.h"
#include "geometry/transform.h"
#include "perception/field/carpet/carpet_color.h"
#include "perception/field/ground_projection.h"

namespace reorient {

/// The nearest pixel's index. `place`: at least -0.5, pixels. std::lround is a function call on many processors.
inline int nearest_index(double place) { return static_cast<int>(std::floor(place + 0.5)); }

struct FieldImage {
  const ImageView& image;
  const GroundProjection& view;
  const CarpetColor& color;  ///< has observed this image

  /// The nearest pixel. Empty outside of the image.
  std::optional<Eigen::Vector2i> nearest(const Eigen::Vector2d& pixel) const {
    // Projected points may be too far outside for integers.
    if (!(pixel.x() > -0.5 && pixel.y() > -0.5 && pixel.x() < image.width - 0.5 && pixel.y() < image.height - 0.5))
      return std::nullopt;
    return Eigen::Vector2i(nearest_index(pixel.x()), nearest_index(pixel.y()));
  }
  /// The same at a position on the ground, m.
  std::optional<Eigen::Vector2i> nearest_to_ground(const Eigen::Vector2d& place) const {
    const auto pixel = view.pixel({place.x(), place.y(), 0.0});
    return pixel ? nearest(*pixel) : std::nullopt;
  }
  Ycbcr at(const Eigen::Vector2i& pixel) const { return image.at(pixel.x(), pixel.y()); }
  Surface surface(const Eigen::Vector2i& pixel) const { return color.surface(pixel.x(), pixel.y(), at(pixel)); }
};

/// Unit vectors, evenly distributed over a full turn.
template <std::size_t kCount>
const std::array<Eigen::Vector2d, kCount>& directions_around() {
  static const auto all = [] {
    std::array<Eigen::Vector2d, kCount> vectors;
    for (std::size_t i = 0; i < kCount; ++i) vectors[i] = unit_vector(2.0 * kPi * static_cast<double>(i) / kCount);
    return vectors;
  }();
  return all;
}

}  // namespace reorient
