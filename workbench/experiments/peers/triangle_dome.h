// SPDX-License-Identifier: MIT
// The other wall that the paper names (Section 3.3): a subdivided half icosahedron of triangles around the field, which
// covers the ceiling. Field frame.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <Eigen/Core>

namespace reorient {

/// An icosahedron about the field's center, an edge on top, so that a rotation by 180 degrees about the vertical maps
/// it onto itself. Each of its 20 faces is cut into `cuts`^2 equal triangles. Directions below the field belong to no
/// triangle.
class TriangleDome {
 public:
  /// `radius`: distance of the corners from the center, m.
  TriangleDome(double radius, int cuts);

  int tiles() const { return static_cast<int>(reflected_.size()); }
  /// The triangle rotated by 180 degrees.
  int reflected(int tile) const { return reflected_[static_cast<std::size_t>(tile)]; }
  Eigen::Vector3d center(int tile) const;
  bool surrounds(const Eigen::Vector3d& position) const;

  struct Hit {
    int tile = 0;
    double height = 0.0;  ///< m above the field
  };
  /// The triangle that a ray from a point inside meets; nothing from outside, or for a zero direction.
  std::optional<Hit> meet(const Eigen::Vector3d& from, const Eigen::Vector3d& direction) const;

 private:
  struct Face {
    std::array<Eigen::Vector3d, 3> corners;
    Eigen::Vector3d normal;           // outwards, of unit length
    Eigen::Matrix3d shares_of_point;  // barycentric coordinates are this times a point of the face
  };

  int tile_at(std::size_t face, const Eigen::Vector3d& point) const;

  int cuts_;
  double inner_radius_ = 0.0;  // of the sphere that touches all faces
  std::vector<Face> faces_;
  std::vector<int> reflected_;
};

}  // namespace reorient
