// SPDX-License-Identifier: MIT
// What can be tuned about the field features.
#pragma once

namespace reorient {

/// Luma and chroma in the image's own units (0 to 255), lengths on the ground in metres.
struct FieldFeatureParameters {
  double carpet_memory = 0.7;
  int carpet_patience = 300;
  double carpet_saturation = 0.3;
  double line_contrast = 8.0;
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
        "share of the carpet's old colour kept when a new image comes");
  visit("carpet_patience", p.carpet_patience, 1, kMostCarpetPatience, "images",
        "so many images must show no carpet before a color that is no green is taken for it: it may be a floor");
  visit("carpet_saturation", p.carpet_saturation, 0.1, 0.9, "",
        "a pixel is carpet with at least this share of the carpet's usual saturation");
  visit("line_contrast", p.line_contrast, 2.0, 100.0, "luma", "how much brighter than the carpet a line is at least");
  visit("noise_factor", p.noise_factor, 1.0, 10.0, "", "an edge is stronger than the carpet's texture times this");
  visit("line_range", p.line_range, 0.5, 30.0, "m", "line points farther away are not looked for");
  visit("line_spacing", p.line_spacing, 0.005, 0.5, "m",
        "scan lines closer together on the ground than this are left out");
  visit("line_support", p.line_support, 0, 10, "", "how many other points must continue the line of a line point");
  visit("post_contrast", p.post_contrast, 2.0, 100.0, "luma", "how much brighter than its surroundings a goal post is");
  visit("post_range", p.post_range, 0.5, 30.0, "m", "goal posts farther away are not looked for");
  visit("post_agreement", p.post_agreement, 0.3, 1.0, "", "share of a post's expected outline that must be seen");
  visit("attitude_deviation", p.attitude_deviation, 0.0, 0.2, "rad",
        "error of the camera's tilt and of its yaw, of which percepts know");
  visit("pixel_deviation", p.pixel_deviation, 0.0, 20.0, "pixels", "error of a percept's place in the image");
  visit("obstacle_range", p.obstacle_range, 0.5, 30.0, "m", "obstacles farther away are not looked for");
  visit("obstacle_width", p.obstacle_width, 0.05, 1.0, "m", "what is narrower is no obstacle");
  visit("obstacle_height", p.obstacle_height, 0.1, 4.0, "m", "how tall an obstacle is taken to be");
}

}  // namespace reorient
