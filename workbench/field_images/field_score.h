// SPDX-License-Identifier: MIT
// Compares the percepts of the field vision in an image with its labels.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "perception/field/field_features.h"
#include "workbench/field_images/field_labels.h"

namespace reorient {

/// One labeled line: the number of its pieces in which a line point was found. Pieces are 0.1 m or more, and 12 pixels
/// of an image of 640 or more. Pieces beyond the range of the line search do not count.
struct LineScore {
  int pieces = 0;
  int found = 0;
  double recall() const { return pieces > 0 ? static_cast<double>(found) / pieces : 1.0; }
};

struct FieldScore {
  std::vector<LineScore> lines;  ///< in the order of the labels
  int line_points = 0;           ///< all but those in ignored areas
  int on_lines = 0;              ///< of them, those on a labeled line
  int in_masks = 0;              ///< on a ball, feet, boards, a mark, a post
  int posts = 0;                 ///< labeled
  int posts_found = 0;
  int false_posts = 0;
  int border_columns = 0;   ///< of the percept's boundary, in which boards are labeled
  int border_found = 0;     ///< of them, those in which the boundary is within 8 pixels of the boards' lower edge
  int robots = 0;           ///< labeled feet
  int robots_found = 0;     ///< of them, those with an obstacle on them
  int false_obstacles = 0;  ///< not on labeled feet
  int balls = 0;            ///< labeled, the whole of which is in the image
  int balls_found = 0;
  int false_balls = 0;
  int marks = 0;  ///< labeled, the whole of which is in the image
  int marks_found = 0;
  int false_marks = 0;
  bool shows_carpet = false;

  int elsewhere() const { return line_points - on_lines - in_masks; }  ///< on the plain carpet
};

FieldScore operator+(FieldScore a, const FieldScore& b);

/// The camera that the labels describe, at the image's resolution.
CameraModel camera_of(const FieldLabels& labels, int width, int height);

/// `line_range`: m, range of the line search. `view`: the camera pose of the percept.
FieldScore score_of(const FieldPercept& percept, const FieldLabels& labels, const GroundProjection& view,
                    double line_range);

}  // namespace reorient
