// SPDX-License-Identifier: MIT
// Estimates a camera's offset from edges that are vertical in the room: poles, door frames, corners of walls, legs of
// tables. All of them meet at the vertical vanishing point, which determines tilt and roll. Pan and height do not
// change their directions.
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

/// Largest angle from the projected vertical within which to search for edges, rad.
inline constexpr double kEdgeReach = from_degrees(35.0);

/// The correction with which a camera's recorded poses agree with the edges: which parts of the recorded attitude to
/// use, and the offset to add to them.
struct EdgeMounting {
  RecordedAttitude recorded;
  OffsetEstimate estimate;
};
/// Leaves out the recorded roll (or pitch) of the images if the edges agree better without it: in 95 of 100 bootstrap
/// samples of the images, by at least 1 %.
EdgeMounting mounting_from_edges(std::span<const EdgeView> views);

/// The same edges with corrected poses of the cameras.
std::vector<EdgeView> corrected(std::span<const EdgeView> views, const RecordedAttitude& recorded,
                                const CameraOffset& offset);

/// For each edge that is nearly vertical with one of its camera's two poses: the non-negative angles between the edge
/// and the projected vertical with both poses, weighted by the edge's length. The views differ only in these poses.
struct EdgeAngles {
  std::vector<WeightedResidual> before, after;
};
EdgeAngles edge_angles(std::span<const EdgeView> before, std::span<const EdgeView> after);

/// A lower bound for any constant offset: the angles after each image has got its own tilt and roll around the
/// estimate. These are fitted to every second edge and evaluated on the others, and the other way around.
/// `views`: already corrected.
std::vector<WeightedResidual> angles_with_own_offsets(std::span<const EdgeView> views, double noise);

}  // namespace reorient
