// SPDX-License-Identifier: MIT
// Rotations with pinned mathematics (Eigen's AngleAxis and Rotation2D use the C library), and rigid motions of space.
#pragma once

#include <algorithm>
#include <array>
#include <span>

#include <Eigen/Core>
#include <Eigen/Geometry>

#include "geometry/pinned_math.h"

namespace reorient {

/// A rigid motion of space. Unlike Eigen::Isometry3d, it has the same memory layout for every instruction set, so a
/// program that was built for AVX can use a library that was built without it.
using Isometry3 = Eigen::Transform<double, 3, Eigen::Isometry, Eigen::DontAlign>;

/// `vector` rotated to the left by `angle` (rad).
inline Eigen::Vector2d rotated(const Eigen::Vector2d& vector, double angle) {
  const auto [sine, cosine] = pinned::sincos(angle);
  return {cosine * vector.x() - sine * vector.y(), sine * vector.x() + cosine * vector.y()};
}

/// A vector of length 1 in the direction `angle` (rad).
inline Eigen::Vector2d unit_vector(double angle) {
  const auto [sine, cosine] = pinned::sincos(angle);
  return {cosine, sine};
}

/// The same for many angles, with the same bits in a third of the time. As many vectors as angles.
inline void unit_vectors(std::span<const double> angles, std::span<Eigen::Vector2d> vectors) {
  std::array<double, 16> sines, cosines;
  for (std::size_t first = 0; first < angles.size(); first += sines.size()) {
    const std::size_t count = std::min(sines.size(), angles.size() - first);
    pinned::sincos(angles.subspan(first, count), sines, cosines);
    for (std::size_t i = 0; i < count; ++i) vectors[first + i] = {cosines[i], sines[i]};
  }
}

/// The z component of the cross product: positive if b points to the left of a.
inline double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) { return a.x() * b.y() - a.y() * b.x(); }

/// rad, in (-pi, pi].
inline double direction_of(const Eigen::Vector2d& vector) { return pinned::atan2(vector.y(), vector.x()); }

inline Eigen::Matrix3d rotation_about_x(double angle) {
  const auto [sine, cosine] = pinned::sincos(angle);
  return (Eigen::Matrix3d() << 1.0, 0.0, 0.0, 0.0, cosine, -sine, 0.0, sine, cosine).finished();
}

inline Eigen::Matrix3d rotation_about_y(double angle) {
  const auto [sine, cosine] = pinned::sincos(angle);
  return (Eigen::Matrix3d() << cosine, 0.0, sine, 0.0, 1.0, 0.0, -sine, 0.0, cosine).finished();
}

inline Eigen::Matrix3d rotation_about_z(double angle) {
  const auto [sine, cosine] = pinned::sincos(angle);
  return (Eigen::Matrix3d() << cosine, -sine, 0.0, sine, cosine, 0.0, 0.0, 0.0, 1.0).finished();
}

}  // namespace reorient
