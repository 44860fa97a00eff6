// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/triangle_dome.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <Eigen/Geometry>
#include <Eigen/LU>

namespace reorient {

namespace {

/// The corners of an icosahedron with an edge on top, at this distance from its center.
std::array<Eigen::Vector3d, 12> corners_of_icosahedron(double radius) {
  const double golden = 0.5 * (1.0 + std::sqrt(5.0));
  std::array<Eigen::Vector3d, 12> corners;
  std::size_t next = 0;
  for (const double one : {1.0, -1.0}) {
    for (const double other : {golden, -golden}) {
      for (const Eigen::Vector3d& corner :
           {Eigen::Vector3d(0.0, one, other), Eigen::Vector3d(one, other, 0.0), Eigen::Vector3d(other, 0.0, one)})
        corners[next++] = radius * corner.normalized();
    }
  }
  return corners;
}

}  // namespace

TriangleDome::TriangleDome(double radius, int cuts) : cuts_(cuts) {
  const auto corners = corners_of_icosahedron(radius);
  double edge = std::numeric_limits<double>::infinity();
  for (std::size_t i = 1; i < corners.size(); ++i) edge = std::min(edge, (corners[i] - corners[0]).norm());
  const auto are_neighbors = [&](std::size_t i, std::size_t j) {
    return (corners[i] - corners[j]).norm() < 1.1 * edge;
  };
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = i + 1; j < corners.size(); ++j) {
      for (std::size_t k = j + 1; k < corners.size(); ++k) {
        if (!are_neighbors(i, j) || !are_neighbors(j, k) || !are_neighbors(i, k)) continue;
        Face face;
        face.corners = {corners[i], corners[j], corners[k]};
        face.normal = (corners[i] + corners[j] + corners[k]).normalized();
        Eigen::Matrix3d points;
        points << corners[i], corners[j], corners[k];
        face.shares_of_point = points.inverse();
        faces_.push_back(face);
      }
    }
  }
  inner_radius_ = faces_.front().normal.dot(faces_.front().corners[0]);
  reflected_.resize(faces_.size() * static_cast<std::size_t>(cuts * cuts));
  for (std::size_t tile = 0; tile < reflected_.size(); ++tile) {
    const Eigen::Vector3d here = center(static_cast<int>(tile));
    reflected_[tile] = meet(Eigen::Vector3d::Zero(), {-here.x(), -here.y(), here.z()})->tile;
  }
}

bool TriangleDome::surrounds(const Eigen::Vector3d& position) const {
  return std::all_of(faces_.begin(), faces_.end(),
                     [&](const Face& face) { return face.normal.dot(position) < inner_radius_; });
}

std::optional<TriangleDome::Hit> TriangleDome::meet(const Eigen::Vector3d& from,
                                                    const Eigen::Vector3d& direction) const {
  if (!direction.allFinite() || direction.squaredNorm() == 0.0 || !surrounds(from)) return std::nullopt;
  std::size_t nearest = 0;
  double steps = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < faces_.size(); ++i) {
    const double speed = faces_[i].normal.dot(direction);
    if (speed <= 0.0) continue;
    const double until = (inner_radius_ - faces_[i].normal.dot(from)) / speed;
    if (until >= steps) continue;
    steps = until;
    nearest = i;
  }
  const Eigen::Vector3d point = from + steps * direction;
  return Hit{tile_at(nearest, point), point.z()};
}

// A face's triangles by two of the three barycentric coordinates, times `cuts`: row a of them holds 2 (cuts - a) - 1
// triangles, which point up and down alternately.
int TriangleDome::tile_at(std::size_t face, const Eigen::Vector3d& point) const {
  const Eigen::Vector3d shares = faces_[face].shares_of_point * point;
  const double whole = std::max(shares.sum(), 1e-9);
  const auto cut = [&](double share) { return std::clamp(share / whole, 0.0, 1.0) * cuts_; };
  const double a = cut(shares[0]), b = cut(shares[1]);
  const int row = std::min(static_cast<int>(a), cuts_ - 1);
  const int most = 2 * (cuts_ - row) - 1;
  const int whole_b = static_cast<int>(b);
  const bool on_tip = (a - row) + (b - whole_b) > 1.0;
  const int in_row = std::clamp(2 * whole_b + (on_tip ? 1 : 0), 0, most - 1);
  const int before = row * (2 * cuts_ - row);  // triangles of the rows before
  return static_cast<int>(face) * cuts_ * cuts_ + before + in_row;
}

Eigen::Vector3d TriangleDome::center(int tile) const {
  const Face& face = faces_[static_cast<std::size_t>(tile / (cuts_ * cuts_))];
  int in_row = tile % (cuts_ * cuts_);
  int row = 0;
  while (in_row >= 2 * (cuts_ - row) - 1) in_row -= 2 * (cuts_ - row++) - 1;
  const double third = in_row % 2 == 0 ? 1.0 / 3.0 : 2.0 / 3.0;
  const double a = (row + third) / cuts_;
  const int whole_b = in_row / 2;
  const double b = (whole_b + third) / cuts_;
  return a * face.corners[0] + b * face.corners[1] + (1.0 - a - b) * face.corners[2];
}

}  // namespace reorient
