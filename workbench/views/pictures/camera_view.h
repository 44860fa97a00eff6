// The camera image with what the robot found in it and what it expected (the paper's Fig. 4b). Positions are pixels of
// the image: u right, v down, (0, 0) the centre of the top left pixel.
#pragma once

#include <string>
#include <vector>

#include <Eigen/Core>

#include "geometry/image.h"
#include "workbench/views/pictures/parts/histogram_bars.h"

namespace reorient::pictures {

/// A tile of the wall, projected back into the image from the believed pose.
struct ImageTile {
  std::vector<Eigen::Vector2d> corners;  ///< in order around the tile; more than four where the lens bends its sides
  HistogramBars perceived;
  bool counted = true;  ///< false: covered, too steep or too near; drawn dashed and without a chart
};

struct ImageLinePoint {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  Eigen::Vector2d normal = Eigen::Vector2d::Zero();  ///< across the line, of any length but 0
};

struct ImageGoalPost {
  Eigen::Vector2d base = Eigen::Vector2d::Zero();
  Eigen::Vector2d top = Eigen::Vector2d::Zero();
};

/// An intersection, a mark, the ball.
struct ImageLandmark {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double radius = 0.0;  ///< of the ball; 0: the landmark is a place
  std::string name;     ///< "L", "ball"
};

struct ImageArea {
  double left = 0.0;
  double top = 0.0;
  double right = 0.0;
  double bottom = 0.0;
};

/// A cell of the view filter's grid.
struct ImageViewCell {
  Eigen::Vector2d position = Eigen::Vector2d::Zero();
  double share = 0.0;  ///< of the belief, in [0, 1]
};

/// What is empty is not drawn.
struct CameraView {
  ImageView image;
  double time = 0.0;  ///< s
  std::vector<ImageTile> tiles;
  std::vector<Eigen::Vector2d> view_particles;
  std::vector<ImageViewCell> view_cells;
  std::vector<ImageLinePoint> line_points;
  std::vector<ImageGoalPost> goal_posts;
  std::vector<ImageArea> obstacles;
  std::vector<ImageLandmark> landmarks;
  std::vector<Eigen::Vector2d> boundary;                          ///< of the field, from left to right
  std::vector<Eigen::Vector2d> horizon;                           ///< from left to right
  std::vector<std::vector<Eigen::Vector2d>> projected_lines;      ///< field lines as the believed pose expects them
  std::vector<std::vector<Eigen::Vector2d>> edges;                ///< nearly vertical edges that the image shows
  std::vector<std::vector<Eigen::Vector2d>> projected_verticals;  ///< verticals as the camera pose expects them
};

/// 1280 pixels wide, whatever the image's size, with the legend below the image. `caption`: in a line below the legend;
/// empty: the time beside it instead.
Picture draw_camera_view(const CameraView& camera, const std::string& caption = {});

/// The same without a legend, `width` pixels wide, with marks as small as the picture.
Picture draw_camera_thumbnail(const CameraView& camera, int width);

}  // namespace reorient::pictures
