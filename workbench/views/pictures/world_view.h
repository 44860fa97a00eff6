// SPDX-License-Identifier: MIT
// The robot's inner view of the world, from above (the paper's Fig. 4a).
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "geometry/field_dimensions.h"
#include "geometry/pose2.h"
#include "workbench/views/pictures/canvas/picture.h"
#include "workbench/views/scene/histogram.h"

namespace reorient::pictures {

/// A tile of the wall around the field. Azimuths are seen from the field's center: rad, 0 toward +x, counterclockwise.
struct WallTile {
  double from = 0.0;  ///< its right side
  double to = 0.0;    ///< its left side, greater than `from`
  int row = 0;        ///< 0 is the lowest; at most 5 are drawn
  scene::HistogramBars histogram;
  std::optional<double> evidence = std::nullopt;  ///< log-odds that color it: positive for the mirrored pose
};

/// A cell of the view filter's grid.
struct ViewCell {
  double from = 0.0;   ///< its right side, rad
  double to = 0.0;     ///< its left side, greater than `from`
  double share = 0.0;  ///< fraction of the belief, in [0, 1]
};

/// A cluster of view particles or cells.
struct ViewCluster {
  double azimuth = 0.0;  ///< rad
  double spread = 0.0;   ///< rad, standard deviation
};

/// All in the field frame. Empty members are not drawn.
struct WorldView {
  FieldDimensions field;
  std::string title = "The robot's view of its world";
  std::optional<double> time;  ///< s
  std::string note;            ///< additional line below the title
  std::optional<Pose2> truth;
  std::optional<Pose2> belief;
  std::vector<Pose2> pose_particles;

  double wall_radius = 8.0;            ///< m
  std::vector<WallTile> model;         ///< trained tiles
  std::vector<WallTile> untrained;     ///< drawn as empty plates
  std::vector<WallTile> perceived;     ///< tiles of this frame, without deviations, with their evidence
  std::vector<double> view_particles;  ///< azimuths, rad
  std::vector<ViewCell> view_cells;    ///< drawn as bars; height: square root of the share, relative to the ring
  std::vector<ViewCluster> view_clusters;
  std::optional<double>
      view_azimuth;  ///< rad, where on the wall the believed pose looks; the opposite view is rotated by 180 degrees
  double view_half_width = 0.5235987755982988;       ///< rad, half width of the sectors that count for the confidences
  double goal_area_half_width = 0.2181661564992912;  ///< rad, half width of the areas behind the goals; 0: not drawn
};

Picture draw_world_view(const WorldView& world);

}  // namespace reorient::pictures
