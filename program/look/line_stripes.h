// SPDX-License-Identifier: MIT
// Bright stripes on the carpet in an image, found without an assumption about the camera's pitch.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Core>

#include "geometry/camera.h"
#include "geometry/field_dimensions.h"
#include "geometry/image.h"
#include "geometry/transform.h"
#include "perception/field/field_feature_parameters.h"

namespace reorient {

/// A point on the center line of a stripe.
struct LineStripe {
  Eigen::Vector2d pixel = Eigen::Vector2d::Zero();
  Eigen::Vector2d tangent = Eigen::Vector2d::UnitX();  ///< along the stripe, of unit length
  double width = 0.0;                                  ///< pixels, across the tangent
};

struct LineStripes {
  std::vector<LineStripe> stripes;
  /// Whether the contrast of white was measured on stripes that are wider than the image's blur. Otherwise it is that
  /// of the clearest thin stripes, which is lower, and all widths may be too large by one factor.
  bool contrast_is_known = false;
};

/// The stripes that the field vision detects as a field line for at least one of the camera's attitudes, each once. The
/// width of a stripe that is thinner than the blur is its added light divided by the contrast of wider stripes.
LineStripes find_line_stripes(const ImageView& image, const CameraModel& camera, std::span<const Isometry3> attitudes,
                              const FieldFeatureParameters& parameters, const FieldDimensions& field);

}  // namespace reorient
