// SPDX-License-Identifier: MIT
// Directions for the camera: where the wall best distinguishes the two poses, and where it is least known.
#pragma once

#include <vector>

#include "geometry/const_or.h"
#include "geometry/pose2.h"
#include "geometry/transform.h"
#include "perception/room/compared_model.h"
#include "perception/room/wall/wall.h"

namespace reorient {

struct ViewParameters {
  double reach = 1.6;
  double half_width = 0.4;
  double speed = 2.0;
  double dwell = 0.3;
  double look = 0.1;
  double memory = 4.0;
  double half_known = 0.1;
};
template <typename Visit>
void describe(ViewParameters& p, Visit&& visit) {
  visit("reach", p.reach, 0.1, 3.1, "rad", "largest angle to either side to which the camera can turn");
  visit("half_width", p.half_width, 0.05, 1.2, "rad", "half of the horizontal angle of a view that shows whole tiles");
  visit("speed", p.speed, 0.1, 20.0, "rad/s", "speed at which the camera turns; a slow camera favors near views");
  visit("dwell", p.dwell, 0.05, 5.0, "s", "time for which the camera looks at a view");
  visit("look", p.look, 0.01, 10.0, "s", "recent viewing time after which a part of the wall has half of its score");
  visit("memory", p.memory, 0.1, 600.0, "s", "time constant with which viewing times fade");
  visit("half_known", p.half_known, 0.0, 1.0, "", "score of a tile that is known for only one of the two poses");
}

/// Directions of the camera in the robot's frame, rad. Scores in tiles with full weight; 0: no direction shows
/// anything.
struct InformativeViews {
  double best_yaw = 0.0;  ///< where the room and its reflection differ most
  double best_score = 0.0;
  double unknown_yaw = 0.0;  ///< where most tiles are not trusted yet
  double unknown_score = 0.0;
};
template <typename Visit, ConstOr<InformativeViews> T>
void fields(Visit&& visit, T& views) {
  visit(views.best_yaw, views.best_score, views.unknown_yaw, views.unknown_score);
}

class ViewChooser {
 public:
  /// Starts without observations of a wall with this many columns.
  void restart(int columns);
  /// Processes one frame of `step` seconds. Each of the two directions has the greatest score per time, where the time
  /// includes turning there and looking. Parts of the wall with a cosine of incidence below `least_incidence` have no
  /// score. All values are zero if the believed camera is outside of the wall or not finite.
  const InformativeViews& choose(const Wall& wall, const ComparedModel& model, const Pose2& belief,
                                 const Isometry3& robot_from_camera, double step, double least_incidence,
                                 const ViewParameters& parameters);
  /// Renumbers the columns after a flip, or after a rotation of the field's axes by 180 degrees.
  void rotate_by_180_degrees();

  const InformativeViews& views() const { return views_; }

  /// Throws BadBytes.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    const std::size_t columns = self.viewing_times_.size();
    archive(self.viewing_times_, self.views_);
    if constexpr (Archive::kReads) self.check(columns);
  }

 private:
  struct Score {
    double difference = 0.0;  // between the tiles and their reflections
    double unknown = 0.0;     // number of tiles
  };

  void check(std::size_t columns) const;
  bool look_around(const Wall& wall, const Pose2& belief, const Eigen::Vector2d& camera, double outermost,
                   double least_incidence);
  void note_look(double yaw, double outermost, double step, const ViewParameters& parameters);
  Score score_of(int column, const Wall& wall, const ComparedModel& model, const ViewParameters& parameters) const;

  std::vector<double> viewing_times_;  // s, of each column; fades
  std::vector<double> angles_;         // rad, of the directions, then of the wall there; from right to left
  std::vector<Eigen::Vector2d> headings_, normals_;  // the same as unit vectors
  std::vector<int> columns_;                         // column in each direction, from right to left; -1: does not count
  std::vector<Score> scores_;                        // of these columns
  InformativeViews views_;
};

}  // namespace reorient
