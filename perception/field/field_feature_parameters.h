// SPDX-License-Identifier: MIT
// Parameters of the field features.
#pragma once

namespace reorient {

/// Luma and chroma in the image's units (0 to 255), lengths on the ground in meters.
struct FieldFeatureParameters {
  double carpet_memory = 0.7;
  int carpet_patience = 300;
  double carpet_saturation = 0.3;
  double line_contrast = 7.0;
  double noise_factor = 3.5;
  double line_range = 4.5;
  double line_spacing = 0.03;
  int line_support = 2;
  double post_contrast = 14.0;
  double post_range = 9.0;
  double post_agreement = 0.8;
  double attitude_deviation = 0.01;
  double pixel_deviation = 0.7;
  double obstacle_range = 4.0;
  double obstacle_width = 0.11;
  double obstacle_height = 0.6;
};

inline constexpr int kMostCarpetPatience = 100000;

template <typename Visit>
void describe(FieldFeatureParameters& p, Visit&& visit) {
  visit("carpet_memory", p.carpet_memory, 0.0, 0.99, "",
        "fraction of the learned carpet color that remains after a new image");
  visit(
      "carpet_patience", p.carpet_patience, 1, kMostCarpetPatience, "images",
      "number of images without carpet after which a color other than green is learned as carpet (it may be a floor)");
  visit("carpet_saturation", p.carpet_saturation, 0.1, 0.9, "",
        "smallest fraction of the carpet's usual saturation at which a pixel counts as carpet");
  visit("line_contrast", p.line_contrast, 2.0, 100.0, "luma",
        "smallest difference in luma between a line and the carpet");
  visit("noise_factor", p.noise_factor, 1.0, 10.0, "",
        "smallest strength of an edge, as a multiple of the carpet's texture");
  visit("line_range", p.line_range, 0.5, 30.0, "m", "largest distance of line points");
  visit("line_spacing", p.line_spacing, 0.005, 0.5, "m",
        "smallest distance between scan lines on the ground; closer ones are skipped");
  visit("line_support", p.line_support, 0, 10, "",
        "number of other line points that must continue the line of a line point");
  visit("post_contrast", p.post_contrast, 2.0, 100.0, "luma",
        "smallest difference in luma between a goal post and its surroundings");
  visit("post_range", p.post_range, 0.5, 30.0, "m", "largest distance of goal posts");
  visit("post_agreement", p.post_agreement, 0.3, 1.0, "",
        "smallest fraction of a goal post's expected outline that must be visible");
  visit("attitude_deviation", p.attitude_deviation, 0.0, 0.2, "rad",
        "standard deviation of the camera's tilt and of its yaw, used for the covariance of percepts");
  visit("pixel_deviation", p.pixel_deviation, 0.0, 20.0, "pixels",
        "standard deviation of a percept's position in the image");
  visit("obstacle_range", p.obstacle_range, 0.5, 30.0, "m", "largest distance of obstacles");
  visit("obstacle_width", p.obstacle_width, 0.05, 1.0, "m", "smallest width of an obstacle");
  visit("obstacle_height", p.obstacle_height, 0.1, 4.0, "m", "assumed height of an obstacle");
}

}  // namespace reorient
