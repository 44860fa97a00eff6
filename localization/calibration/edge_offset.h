// SPDX-License-Identifier: MIT
// A camera's offset from edges that are vertical in the room: poles, door frames, corners of walls, legs of tables. All
// of them meet at the vertical vanishing point, which gives tilt and roll. Pan and height do not change their
// directions.
#pragma once

#include <span>
#include <vector>

#include "geometry/camera.h"
#include "geometry/camera_attitude.h"
#include "geometry/camera_offset.h"
#include "geometry/transform.h"
#include "localization/calibration/offset_fit.h"
#include "localization/calibration/vertical_edges.h"

namespace reorient {

/// The edges of one image.
struct EdgeView {
  CameraModel camera;
  Isometry3 robot_from_camera = Isometry3::Identity();  ///< as recorded
  std::vector<ImageEdge> edges;
};

/// How far from the projected vertical edges have to be searched for, rad.
inline constexpr double kEdgeReach = from_degrees(35.0);

/// What a camera's recorded poses need to agree with the edges: `offset` on top of what is used of them.
struct EdgeMounting {
  RecordedAttitude recorded;
  OffsetEstimate estimate;
};
/// The recorded roll (or pitch) of single images is left out where the edges agree better without it: in 95 of 100
/// bootstrap samples of the images, by at least a hundredth.
EdgeMounting mounting_from_edges(std::span<const EdgeView> views);

/// The same edges, seen by cameras with corrected poses.
std::vector<EdgeView> corrected(std::span<const EdgeView> views, const RecordedAttitude& recorded,
                                const CameraOffset& offset);

/// For each edge that is nearly vertical under one of the two poses of its camera: the angles (at least 0) between the
/// edge and the projected vertical under both, weighted by the edge's length. The views differ in their poses only.
struct EdgeAngles {
  std::vector<WeightedResidual> before, after;
};
EdgeAngles edge_angles(std::span<const EdgeView> before, std::span<const EdgeView> after);

/// What no constant offset can reach: the angles after each image has its own tilt and roll around the estimate, fitted
/// to every second of its edges and checked on the others, with the roles swapped as well.
/// `views`: corrected.
std::vector<WeightedResidual> angles_with_own_offsets(std::span<const EdgeView> views, double noise);

}  // namespace reorient
