// SPDX-License-Identifier: MIT
// Goal posts: upright, bright (or yellow), and with the thickness and height of a post whose foot is on the carpet.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <Eigen/Core>

#include "geometry/field_dimensions.h"
#include "perception/field/field_image.h"
#include "perception/field/lines/scan_line.h"
#include "perception/field/percepts.h"

namespace reorient {

/// Prefers missing a post to reporting a false one, which would move particles of the pose to wrong positions.
class GoalPosts {
 public:
  GoalPosts(const FieldFeatureParameters& parameters, const FieldDimensions& field);
  void set_parameters(const FieldFeatureParameters& parameters) { parameters_ = parameters; }

  /// Reads the percept's boundary and fills in its goal posts.
  void find(const FieldImage& frame, FieldPercept& percept);

 private:
  /// A bright stretch of a row, and the extent of its color above and below.
  struct Candidate {
    Eigen::Vector2d pixel;
    double width = 0.0;  ///< pixels
    Ycbcr look;
    Eigen::Vector2d foot, top;
  };

  /// The expected post in the camera frame, m.
  struct Upright {
    Eigen::Vector3d foot, top;
  };

  void scan(const FieldImage& frame, double fraction, FieldPercept& percept);
  void consider(const FieldImage& frame, const Eigen::Vector2d& pixel, double width, FieldPercept& percept) const;
  bool may_be_post(const FieldImage& frame, const Eigen::Vector2d& pixel, const Ycbcr& look) const;
  bool is_lighter_than_carpet(const FieldImage& frame, const Ycbcr& look) const;
  bool has_post_color(const FieldImage& frame, const Candidate& candidate, const Eigen::Vector2d& pixel) const;
  Eigen::Vector2d follow(const FieldImage& frame, const Candidate& candidate, const std::vector<float>& boundary,
                         int direction) const;
  std::optional<GoalPost> post_on_carpet(const FieldImage& frame, const Candidate& candidate,
                                         const std::vector<float>& boundary) const;
  std::optional<GoalPost> post_without_foot(const FieldImage& frame, const Candidate& candidate) const;
  bool has_carpet_before(const FieldImage& frame, const Candidate& candidate, const std::vector<float>& boundary) const;
  static bool has_carpet_behind(const FieldImage& frame, const Candidate& candidate, double distance,
                                const std::vector<float>& boundary);
  bool is_thick_enough(const FieldImage& frame, const Candidate& candidate, double distance) const;
  std::optional<double> distance_from_height(const FieldImage& frame, const Candidate& candidate,
                                             double from_foot) const;
  Upright upright_at(const FieldImage& frame, const Candidate& candidate, const Eigen::Vector2d& position) const;
  Upright upright_between(const FieldImage& frame, const Candidate& candidate, double distance) const;
  bool outline_agrees(const FieldImage& frame, const Candidate& candidate, const Upright& upright) const;

  FieldFeatureParameters parameters_;
  FieldDimensions field_;
  std::vector<std::int16_t> luma_;
  std::vector<BrightSegment> segments_;
};

}  // namespace reorient
