// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/corner_view.h"

#include <algorithm>

#include "workbench/experiments/peers/horizon.h"

namespace reorient {
namespace {

constexpr double kFarthest = 50.0;  // m from the field's center; beyond any belief on a field

}  // namespace

std::optional<CornerView> CornerView::of(const RoomObservation& view, int contrast, int most) {
  const std::optional<CameraModel> camera = camera_of(view);
  if (!camera) return std::nullopt;
  CornerView seen(view, *camera);
  if (!(seen.eye_.norm() < kFarthest)) return std::nullopt;
  seen.find(contrast, most);
  return seen;
}

CornerView::CornerView(const RoomObservation& view, const CameraModel& camera)
    : view_(&view),
      camera_(camera),
      field_from_camera_(to_isometry(view.belief) * view.robot_from_camera),
      eye_(field_from_camera_.translation()) {}

bool CornerView::is_searched(const Eigen::Vector2d& pixel) const {
  return pixel.x() >= kCornerMargin && pixel.y() >= kCornerMargin && pixel.x() < camera_.width - kCornerMargin &&
         pixel.y() < camera_.height - kCornerMargin && !is_covered(*view_, pixel.x(), pixel.y());
}

bool CornerView::shows(const Eigen::Vector3d& place) const {
  if (place.z() <= eye_.z()) return false;
  const std::optional<Eigen::Vector2d> pixel = camera_.project(field_from_camera_.inverse() * place);
  return pixel && is_searched(*pixel);
}

/// Up to the lowest row that is above the horizon at one of the image's sides or in its middle. With less than all of
/// an image to search, a camera that looks at the field saves most of the time.
int CornerView::rows_above_horizon() const {
  for (int y = camera_.height - 1; y >= 0; --y) {
    for (const int x : {0, camera_.width / 2, camera_.width - 1}) {
      const Eigen::Vector3d ray = field_from_camera_.linear() * camera_.ray({x, y});
      if (ray.z() > 0.0) return y + 1;
    }
  }
  return 0;
}

void CornerView::find(int contrast, int most) {
  const int rows = rows_above_horizon();
  if (rows <= kCornerMargin) return;
  struct Candidate {
    Corner corner;
    Eigen::Vector3d ray;
  };
  std::vector<Candidate> candidates;
  const LumaPlane image(view_->image);
  for (const Corner& corner : find_corners(image, rows, contrast)) {
    const Eigen::Vector2d pixel(corner.x, corner.y);
    const Eigen::Vector3d ray = (field_from_camera_.linear() * camera_.ray(pixel)).normalized();
    if (ray.z() > 0.0 && is_searched(pixel)) candidates.push_back({corner, ray});
  }
  std::stable_sort(candidates.begin(), candidates.end(),
                   [](const Candidate& a, const Candidate& b) { return a.corner.score > b.corner.score; });
  candidates.resize(std::min(candidates.size(), static_cast<std::size_t>(most)));
  const CornerDescriber describer(image, rows);
  for (const Candidate& candidate : candidates)
    corners_.push_back({candidate.ray, describer.describe(candidate.corner)});
}

}  // namespace reorient
