// SPDX-License-Identifier: MIT
#include "program/look/seen_image.h"

#include <algorithm>

#include "engine/covered_areas.h"
#include "geometry/camera_attitude.h"
#include "perception/field/carpet/boundary.h"
#include "perception/field/ground_projection.h"
#include "perception/room/room_awareness.h"
#include "workbench/field_images/still_image.h"
#include "workbench/views/scene/camera_overlay.h"
#include "workbench/views/scene/color.h"

namespace reorient {
namespace {

/// Rows of the horizon in some columns, from left to right; empty if the camera's attitude cannot be used.
std::vector<Eigen::Vector2d> horizon_of(const CameraModel& camera, const Isometry3& robot_from_camera) {
  constexpr int kPieces = 32;
  std::vector<Eigen::Vector2d> horizon;
  const auto view = GroundProjection::look(camera, robot_from_camera);
  if (!view) return horizon;
  for (int i = 0; i <= kPieces; ++i) {
    const double column = (camera.width - 1.0) * i / kPieces;
    horizon.emplace_back(column, view->horizon(column));
  }
  return horizon;
}

void choose_pitch(const LookImage& image, const LookSetup& setup, SeenImage& seen) {
  if (setup.pitch) {
    seen.robot_from_camera = with_pitch(seen.robot_from_camera, *setup.pitch);
    return;
  }
  if (image.pitch_is_known) {
    seen.pitch_source = PitchSource::recorded;
    return;
  }
  seen.pitch_source = PitchSource::searched;
  seen.searched = search_pitch(image.frame.image.view(), seen.camera, seen.robot_from_camera, image.roll_is_known,
                               setup.parameters.field_features, setup.field);
  seen.robot_from_camera = seen.searched.known
                               ? with_attitude(seen.robot_from_camera, seen.searched.pitch, seen.searched.roll)
                               : with_pitch(seen.robot_from_camera, setup.level_pitch);
}

void look_at_wall(const LookImage& image, const RoomParameters& parameters, SeenImage& seen) {
  std::vector<CoveredArea> covered;
  collect_covered(seen.percept, covered);
  RoomAwareness room(parameters);
  room.update({.time = image.frame.time,
               .image = image.frame.image.view(),
               .camera = seen.camera,
               .robot_from_camera = seen.robot_from_camera,
               .belief = seen.pose,
               .covered = covered,
               .train = false,
               .evaluate = false});
  seen.wall = room.wall();
  seen.tiles.assign(room.perceived().begin(), room.perceived().end());
}

}  // namespace

SeenImage see(const LookImage& image, const LookSetup& setup) {
  const FootageFrame& frame = image.frame;
  SeenImage seen;
  seen.camera = frame.camera;
  seen.robot_from_camera = frame.robot_from_camera;
  if (setup.height) seen.robot_from_camera.translation().z() = *setup.height;
  seen.height = seen.robot_from_camera.translation().z();
  seen.height_is_body = !setup.height && !image.height_is_known;
  choose_pitch(image, setup, seen);
  seen.pose_is_recorded = frame.pose.has_value();
  seen.pose = frame.pose.value_or(setup.pose);

  seen.percept = percept_of_still_image(frame.image.view(), seen.camera, seen.robot_from_camera,
                                        setup.parameters.field_features, setup.field);
  seen.shows_carpet = shows_carpet(seen.percept.boundary, frame.image.height());
  if (const auto view = GroundProjection::look(seen.camera, seen.robot_from_camera))
    seen.horizon = view->horizon(0.5 * (seen.camera.width - 1.0));
  look_at_wall(image, setup.parameters.room, seen);
  return seen;
}

pictures::CameraView camera_view_of(const LookImage& image, const SeenImage& seen, const FieldDimensions& field) {
  const Isometry3 field_from_camera = to_isometry(seen.pose) * seen.robot_from_camera;
  FieldPercept percept = seen.percept;
  if (!seen.shows_carpet) percept.boundary.clear();
  pictures::CameraView view{image.frame.image.view(), image.frame.time,
                            scene::percept_overlay(percept, seen.camera, seen.robot_from_camera)};
  view.overlay.insert(view.overlay.begin(),
                      scene::perceived_tiles(seen.tiles, seen.wall, seen.camera, field_from_camera));
  view.overlay.push_back(scene::polylines("horizon", {horizon_of(seen.camera, seen.robot_from_camera)},
                                          scene::palette::horizon, 2.0, seen.camera));
  if (seen.pose_is_recorded && seen.shows_carpet)
    view.overlay.push_back(scene::expected_lines(field, seen.camera, field_from_camera));
  return view;
}

}  // namespace reorient
