// SPDX-License-Identifier: MIT
#include "perception/field/carpet/straight_edges.h"

#include <algorithm>

namespace reorient {
namespace {

constexpr double kLeastFraction = 0.35;  // fraction of the columns that the first edge explains
constexpr int kFewest = 6;               // smallest number of columns of an edge

}  // namespace

void StraightEdges::find(const CarpetMap& map, const CameraModel& camera, const Rows& highest) {
  constexpr double kUneven = 0.01;  // rad
  camera_ = camera;
  tolerance_ = kUneven + map.step() / camera.focal.y();
  size_ = 0;
  all_count_ = 0;
  for (int i = 0; i < CarpetMap::kColumns; ++i) {
    const int row = highest[static_cast<std::size_t>(i)];
    if (row >= map.rows()) continue;
    all_.col(all_count_++) = camera.ray(Eigen::Vector2d(map.column_pixel(i), map.row_pixel(row))).normalized();
  }
  open_ = all_;
  open_count_ = all_count_;
  while (size_ < edges_.size() && open_count_ >= kFewest) {
    Edge edge = best_edge();
    edge.score -= columns_lost_to(edge);
    if (edge.score < std::max<double>(kFewest, size_ == 0 ? kLeastFraction * all_count_ : 0.0)) return;
    edges_[size_++] = edge;
    remove_explained(edge);
  }
}

/// Among the edges through two columns, the one with the most columns on it, minus the columns beyond it.
StraightEdges::Edge StraightEdges::best_edge() const {
  constexpr int kEnds = 12;
  const auto end = [this](int index) { return open_.col(index * (open_count_ - 1) / (kEnds - 1)); };
  Edge best;
  for (int i = 0; i < kEnds; ++i) {
    for (int j = i + 2; j < kEnds; ++j) {
      const Eigen::Vector3d across = end(i).cross(end(j));  // points down, since i is to the left of j
      const double length = across.norm();
      if (!(length > tolerance_)) continue;
      const Eigen::Vector3d down = across / length;
      int score = 0;
      for (int k = 0; k < open_count_; ++k) {
        const double below = down.dot(open_.col(k));
        if (below > tolerance_) continue;
        score += below < -tolerance_ ? -1 : 1;
      }
      if (score > best.score) best = {down, score};
    }
  }
  return best;
}

/// The columns that lie on another edge already, but beyond this one.
int StraightEdges::columns_lost_to(const Edge& edge) const {
  int lost = 0;
  for (int k = 0; k < all_count_; ++k) {
    if (edge.down.dot(all_.col(k)) >= -tolerance_) continue;
    lost += std::any_of(edges_.begin(), edges_.begin() + static_cast<std::ptrdiff_t>(size_),
                        [&](const Edge& known) { return std::abs(known.down.dot(all_.col(k))) <= tolerance_; });
  }
  return lost;
}

/// The columns on the edge and beyond it.
void StraightEdges::remove_explained(const Edge& edge) {
  int kept = 0;
  for (int k = 0; k < open_count_; ++k) {
    if (edge.down.dot(open_.col(k)) > tolerance_) open_.col(kept++) = open_.col(k);
  }
  open_count_ = kept;
}

bool StraightEdges::is_beyond(const Eigen::Vector2d& pixel) const {
  const Eigen::Vector3d ray = camera_.ray(pixel).normalized();
  return std::any_of(edges_.begin(), edges_.begin() + static_cast<std::ptrdiff_t>(size_),
                     [&](const Edge& edge) { return edge.down.dot(ray) < -tolerance_; });
}

}  // namespace reorient
