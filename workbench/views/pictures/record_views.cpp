// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/record_views.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "workbench/views/scene/camera_overlay.h"
#include "workbench/views/scene/field_scene.h"

namespace reorient::pictures {
namespace {

WallTile wall_tile(const Wall& wall, int tile, const ColorHistogram& mean) {
  const double from = wall.column_of(tile) * wall.column_width();
  return {from, from + wall.column_width(), wall.row_of(tile), {mean, {}}};
}

void add_room(const RoomRecord& room, WorldView& view) {
  if (room.model.empty()) return;  // room awareness is off
  const Wall wall(room.basis.wall);
  view.wall_radius = wall.radius();
  for (int tile = 0; tile < std::min(wall.tiles(), static_cast<int>(room.model.size())); ++tile) {
    const TileModel& model = room.model[static_cast<std::size_t>(tile)];
    WallTile drawn = wall_tile(wall, tile, model.mean);
    for (std::size_t bin = 0; bin < model.variance.size(); ++bin)
      drawn.histogram.deviation[bin] = std::sqrt(model.variance[bin]);
    (model.visits > 0 ? view.model : view.untrained).push_back(drawn);
  }
  for (const PerceivedTile& perceived : room.perceived) {
    if (!perceived.counts) continue;
    WallTile& drawn = view.perceived.emplace_back(wall_tile(wall, perceived.tile, perceived.histogram));
    const auto tile = static_cast<std::size_t>(perceived.tile);
    if (tile < room.evidence.size()) drawn.evidence = room.evidence[tile];
  }
  for (const ViewParticle& particle : room.particles) view.view_particles.push_back(particle.azimuth);
  const double half_cell = kPi / static_cast<double>(room.cells.size());
  for (const reorient::ViewCell& cell : room.cells)
    view.view_cells.push_back({cell.azimuth - half_cell, cell.azimuth + half_cell, cell.share});
  for (const reorient::ViewCluster& cluster : room.clusters) {
    if (cluster.share >= 0.1) view.view_clusters.push_back({cluster.azimuth, cluster.spread});
  }
  view.view_azimuth = room.center_of_view;
  view.view_half_width = room.half_width;
  view.goal_area_half_width = room.goal_half_width;
}

}  // namespace

WorldView world_view_of(const FrameRecord& frame, const SceneTruth& scene) {
  WorldView view;
  view.field = frame.world.field;
  view.time = frame.world.time;
  view.pose_particles = frame.pose_particles.particles;
  if (frame.reorientation) {
    view.note = "before the command " + std::string(to_string(frame.reorientation->reorientation));
    view.pose_particles = frame.pose_particles.before;
  }
  if (scene.truth) view.truth = scene.truth->pose;
  view.belief = scene::observing_belief(frame);
  add_room(frame.room, view);
  return view;
}

WorldView world_view_of(const RoomRecord& room, const FieldDimensions& field) {
  WorldView view;
  view.field = field;
  add_room(room, view);
  return view;
}

CameraView camera_view_of(const FrameRecord& frame) {
  const HeadCamera camera = frame.inputs.upper ? HeadCamera::upper : HeadCamera::lower;
  CameraView view{.image = camera == HeadCamera::upper ? frame.images.upper : frame.images.lower,
                  .time = frame.world.time,
                  .overlay = scene::room_overlay(frame, camera)};
  const scene::Overlay found = scene::field_overlay(frame, camera);
  view.overlay.insert(view.overlay.end(), found.begin(), found.end());
  return view;
}

}  // namespace reorient::pictures
