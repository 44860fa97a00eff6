// SPDX-License-Identifier: MIT
// Points on the field's lines: where a scan line crosses a white stripe with the width of a line on the carpet.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"
#include "perception/field/carpet/carpet_color.h"
#include "perception/field/lines/scan_line.h"
#include "perception/field/percepts.h"

namespace reorient {

class LinePoints {
 public:
  LinePoints(const FieldFeatureParameters& parameters, const FieldDimensions& field);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// Reads boundary, goal posts and obstacles of the percept, and sets its line points. Reports the whiteness of the
  /// stripes to the carpet's color.
  void find(const ImageView& image, const GroundProjection& view, CarpetColor& color, FieldPercept& percept);

  /// Positions of pieces of stripes in the last image that no line continues: m, robot frame.
  const std::vector<Eigen::Vector2d>& lone() const { return lone_; }

 private:
  struct StripeColor {
    Eigen::Vector2d carpet = Eigen::Vector2d::Zero();       ///< (blue, red) beside it, without the offset of 128
    Eigen::Vector2d less_carpet = Eigen::Vector2d::Zero();  ///< (blue, red) of the stripe minus `carpet`
    double contrast = 0.0;                                  ///< of luma
  };
  struct Candidate {
    Eigen::Vector2d position;  ///< m, robot frame
    Eigen::Vector2d pixel;
    Eigen::Vector2d tangent;  ///< unit vector in the image, from the gradient
    Eigen::Vector2d normal;   ///< unit vector on the ground, from the gradient
    double distance = 0.0;    ///< m
    int reach = 1;            ///< pixels from an edge to the values that show its slope
    StripeColor color;
  };
  /// Image, geometry and color of the frame that find() works on.
  struct Frame {
    const ImageView& image;
    const GroundProjection& view;
    const CarpetColor& color;
    const FieldPercept& percept;
  };

  /// One side of a stripe, pixels.
  struct Side {
    Eigen::Vector2d edge;
    Eigen::Vector2d outside;  ///< beyond the edge's blur
  };

  void scan_columns(const Frame& frame);
  void scan_rows(const Frame& frame);
  void search(const Frame& frame, const Eigen::Vector2d& start, const Eigen::Vector2d& step, int reach);
  bool lies_on_carpet(const Frame& frame, const Side& before, const Side& after, Candidate& candidate) const;
  static Surface mean_surface(const Frame& frame, const Side& side, const Eigen::Vector2d& center);
  void consider(const Frame& frame, const Eigen::Vector2d& begin, const Eigen::Vector2d& end, Candidate& candidate);
  void add_lone(const Eigen::Vector2d& position);
  void keep_supported(FieldPercept& percept);
  std::optional<StripeColor> usual_stripe();
  void keep_white(const CarpetColor& color, double usual_contrast, FieldPercept& percept) const;

  FieldFeatureParameters parameters_;
  FieldDimensions field_;
  std::vector<std::int16_t> luma_;  ///< along one scan line; each value is the sum of two pixels
  std::vector<BrightSegment> segments_;
  std::vector<Candidate> candidates_;
  std::vector<Eigen::Vector2d> lone_;
  std::vector<StripeColor> colors_;       ///< of the line points
  std::vector<StripeColor> mean_colors_;  ///< of each of them and the points that continue it
  std::vector<double> sorted_;
};

}  // namespace reorient
