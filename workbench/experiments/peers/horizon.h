// SPDX-License-Identifier: MIT
// The horizon in the image, and the part of the room there: shared by methods that describe the room by azimuth alone.
// Field frame.
#pragma once

#include <optional>
#include <vector>

#include "perception/room/room_observation.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// Whether a robot or a goal hides the room at a pixel.
bool is_covered(const RoomObservation& view, double x, double y);

/// One column of the image.
struct HorizonColumn {
  int x = 0;             ///< pixels
  double row = 0.0;      ///< pixels, where it meets the horizon; may lie outside of the image
  double azimuth = 0.0;  ///< rad in (-pi, pi], of the wall there
  bool covered = false;  ///< by a robot or a goal, at the horizon
};

/// A round wall of which only the distance matters. `radius`: m; 100 is practically infinite.
Wall bare_wall(double radius);

/// The camera of a view, seen from the believed pose. Nothing without an image, if a number is not finite, or if
/// the camera is outside of the wall.
class HorizonCamera {
 public:
  static std::optional<HorizonCamera> of(const RoomObservation& view, const Wall& wall);

  /// `count` columns, evenly spread. Empty if the camera is too steep for a horizon.
  void find(int count, std::vector<HorizonColumn>& columns) const;
  /// The row of a column at which the line of sight has this slope (height per distance), pixels; nothing if
  /// the column has no such row.
  std::optional<double> row_at(double x, double slope) const;
  int width() const { return camera_.width; }
  int height() const { return camera_.height; }

 private:
  HorizonCamera(const RoomObservation& view, const Wall& wall, const CameraModel& camera)
      : view_(&view),
        wall_(&wall),
        camera_(camera),
        field_from_camera_(to_isometry(view.belief) * view.robot_from_camera) {}

  Eigen::Vector3d direction(double x, double y) const { return field_from_camera_.linear() * camera_.ray({x, y}); }

  const RoomObservation* view_;
  const Wall* wall_;
  CameraModel camera_;  // at the image's resolution
  Isometry3 field_from_camera_;
};

/// One of `sectors` equal parts of the circle, counted to the left from azimuth 0. With an even number of them, the
/// reflection of a sector is half their number further on.
int sector_of(double azimuth, int sectors);
inline int reflected_sector(int sector, int sectors) { return (sector + sectors / 2) % sectors; }

}  // namespace reorient
