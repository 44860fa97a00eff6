// SPDX-License-Identifier: MIT
#include "geometry/lens.h"

#include <algorithm>
#include <cmath>

#include "geometry/angle.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr std::array<std::string_view, 3> kNames{"pinhole", "fisheye", "equirectangular"};

/// The distorted radius and its derivative. If the slope is not positive, two directions have the same position.
struct Radius {
  double value = 0.0;
  double slope = 1.0;
};

/// `radius`: the tangent of the angle to the optical axis (pinhole), or the angle (fisheye).
Radius distorted(const Lens& lens, double radius) {
  const double r2 = radius * radius;
  if (lens.projection == CameraProjection::fisheye) {
    return {radius * (1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * (lens.k3 + r2 * lens.k4)))),
            1.0 + r2 * (3.0 * lens.k1 + r2 * (5.0 * lens.k2 + r2 * (7.0 * lens.k3 + r2 * 9.0 * lens.k4)))};
  }
  const double top = 1.0 + r2 * (lens.k1 + r2 * (lens.k2 + r2 * lens.k3));
  const double bottom = 1.0 + r2 * (lens.k4 + r2 * (lens.k5 + r2 * lens.k6));
  if (!(bottom > 0.0)) return {0.0, -1.0};
  const double top_slope = lens.k1 + r2 * (2.0 * lens.k2 + r2 * 3.0 * lens.k3);
  const double bottom_slope = lens.k4 + r2 * (2.0 * lens.k5 + r2 * 3.0 * lens.k6);
  const double factor = top / bottom;
  return {radius * factor, factor + 2.0 * r2 * (top_slope - factor * bottom_slope) / bottom};
}

double farthest(const Lens& lens) {
  constexpr double kSteepest = 1e3;  // tangent; 89.94 degrees
  return lens.projection == CameraProjection::fisheye ? kPi - 1e-6 : kSteepest;
}

/// Whether each position from the axis to this radius has only one direction.
bool is_one_to_one(const Lens& lens, double radius) {
  constexpr int kSteps = 8;
  if (!(radius <= farthest(lens))) return false;
  for (int i = kSteps; i > 0; --i) {
    if (!(distorted(lens, radius * i / kSteps).slope > 0.0)) return false;
  }
  return true;
}

/// The radius whose distorted radius is `target`, on the branch that begins at the axis. The end of that branch if it
/// does not reach `target`.
double undistorted(const Lens& lens, double target) {
  constexpr double kFirstStep = 0.05;
  constexpr double kGrowth = 0.1;  // fraction of the radius; steps farther out may be longer
  constexpr int kBisections = 50;
  constexpr int kIterations = 60;
  if (!(target > 0.0)) return 0.0;
  const double most = farthest(lens);
  double low = 0.0;
  double high = 0.0;
  while (high < most) {
    high = std::min(most, low + kFirstStep + (lens.is_perspective() ? kGrowth * low : 0.0));
    const Radius at = distorted(lens, high);
    if (!(at.slope > 0.0)) {  // the distortion folds back before this radius: find where
      double rising = low, falling = high;
      for (int i = 0; i < kBisections; ++i) {
        const double middle = 0.5 * (rising + falling);
        (distorted(lens, middle).slope > 0.0 ? rising : falling) = middle;
      }
      high = rising;
      if (distorted(lens, high).value < target) return high;
      break;
    }
    if (at.value >= target) break;
    if (high >= most) return most;
    low = high;
  }
  // Newton's method, bounded by a radius that is too small and one that is too large.
  double radius = 0.5 * (low + high);
  for (int i = 0; i < kIterations; ++i) {
    const Radius at = distorted(lens, radius);
    const double error = at.value - target;
    (error > 0.0 ? high : low) = radius;
    double next = at.slope > 0.0 ? radius - error / at.slope : low;
    if (!(next > low && next < high)) next = 0.5 * (low + high);
    if (std::abs(next - radius) <= 1e-15 * (1.0 + radius)) return next;
    radius = next;
  }
  return radius;
}

/// The distorted position of an ideal position of a pinhole, with its derivatives.
struct Place {
  Eigen::Vector2d value;
  Eigen::Matrix2d slope;
};

Place distorted(const Lens& lens, const Eigen::Vector2d& ideal) {
  const double x = ideal.x(), y = ideal.y();
  const double r2 = ideal.squaredNorm();
  const double radius = std::sqrt(r2);
  const Radius radial = distorted(lens, radius);
  const double factor = radius > 0.0 ? radial.value / radius : 1.0;
  // d factor / d (r^2), times 2.
  const double bend = r2 > 0.0 ? (radial.slope - factor) / r2 : 0.0;
  Place place;
  place.value = factor * ideal + Eigen::Vector2d(2.0 * lens.p1 * x * y + lens.p2 * (r2 + 2.0 * x * x),
                                                 lens.p1 * (r2 + 2.0 * y * y) + 2.0 * lens.p2 * x * y);
  const double mixed = bend * x * y + 2.0 * lens.p1 * x + 2.0 * lens.p2 * y;
  place.slope << factor + bend * x * x + 2.0 * lens.p1 * y + 6.0 * lens.p2 * x, mixed, mixed,
      factor + bend * y * y + 6.0 * lens.p1 * y + 2.0 * lens.p2 * x;
  return place;
}

double determinant(const Eigen::Matrix2d& m) { return m(0, 0) * m(1, 1) - m(0, 1) * m(1, 0); }

/// Newton's method, started at the inverse of the radial distortion.
Eigen::Vector2d undistorted_place(const Lens& lens, const Eigen::Vector2d& target) {
  constexpr int kIterations = 20;
  const double distance = target.norm();
  if (!(distance > 0.0)) return Eigen::Vector2d::Zero();
  Eigen::Vector2d start = target * (undistorted(lens, distance) / distance);
  if (lens.p1 == 0.0 && lens.p2 == 0.0) return start;
  Eigen::Vector2d ideal = start;
  for (int i = 0; i < kIterations; ++i) {
    const Place at = distorted(lens, ideal);
    const Eigen::Vector2d error = at.value - target;
    const double scale = determinant(at.slope);
    if (!(scale > 1e-6)) return start;
    const Eigen::Vector2d step(at.slope(1, 1) * error.x() - at.slope(0, 1) * error.y(),
                               at.slope(0, 0) * error.y() - at.slope(1, 0) * error.x());
    ideal -= step / scale;
    if (!ideal.allFinite() || ideal.norm() > farthest(lens)) return start;
    if (step.norm() <= 1e-15 * scale * (1.0 + ideal.norm())) break;
  }
  return ideal;
}

}  // namespace

std::string_view to_string(CameraProjection projection) { return kNames.at(static_cast<std::size_t>(projection)); }

std::optional<CameraProjection> projection_named(std::string_view name) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return std::nullopt;
  return static_cast<CameraProjection>(found - kNames.begin());
}

bool Lens::is_finite() const {
  std::size_t count = 0;
  const std::array<double, 8> all = coefficients(count);
  return std::all_of(all.begin(), all.end(), [](double value) { return std::isfinite(value); });
}

std::string Lens::set_coefficients(std::span<const double> coefficients) {
  const std::size_t count = coefficients.size();
  const auto expected = [&](const char* counts) {
    return "expected " + std::string(counts) + " coefficients for a " + std::string(to_string(projection)) +
           " camera, found " + std::to_string(count);
  };
  if (projection == CameraProjection::equirectangular && count != 0) return expected("no");
  if (projection == CameraProjection::fisheye && count != 0 && count != 4) return expected("0 or 4");
  if (projection == CameraProjection::pinhole && count != 0 && count != 2 && count != 4 && count != 5 && count != 8)
    return expected("0, 2, 4, 5 or 8");
  const auto at = [&](std::size_t index) { return index < count ? coefficients[index] : 0.0; };
  k1 = at(0);
  k2 = at(1);
  if (projection == CameraProjection::fisheye) {
    k3 = at(2);
    k4 = at(3);
    p1 = p2 = k5 = k6 = 0.0;
  } else {
    p1 = at(2);
    p2 = at(3);
    k3 = at(4);
    k4 = at(5);
    k5 = at(6);
    k6 = at(7);
  }
  return {};
}

std::array<double, 8> Lens::coefficients(std::size_t& count) const {
  count = projection == CameraProjection::pinhole ? 8 : projection == CameraProjection::fisheye ? 4 : 0;
  if (projection == CameraProjection::fisheye) return {k1, k2, k3, k4, p1, p2, k5, k6};
  return {k1, k2, p1, p2, k3, k4, k5, k6};
}

std::optional<Eigen::Vector2d> Lens::distort(const Eigen::Vector3d& direction) const {
  constexpr double kNearest = 1e-6;  // m from the camera
  const double right = -direction.y(), down = -direction.z();
  const double across = pinned::hypot(right, down);
  std::optional<Eigen::Vector2d> place;
  if (projection == CameraProjection::pinhole) {
    if (!(direction.x() >= kNearest)) return std::nullopt;
    const Eigen::Vector2d ideal(right / direction.x(), down / direction.x());
    if (!is_one_to_one(*this, ideal.norm())) return std::nullopt;
    const Place at = distorted(*this, ideal);
    if (!(determinant(at.slope) > 0.0)) return std::nullopt;
    place = at.value;
  } else if (!(pinned::hypot(direction.x(), across) >= kNearest)) {
    return std::nullopt;
  } else if (projection == CameraProjection::fisheye) {
    const double angle = pinned::atan2(across, direction.x());
    if (!is_one_to_one(*this, angle)) return std::nullopt;
    const double scale = across > 0.0 ? distorted(*this, angle).value / across : 0.0;
    place = Eigen::Vector2d(scale * right, scale * down);
  } else {
    place = Eigen::Vector2d(pinned::atan2(right, direction.x()),
                            pinned::atan2(down, pinned::hypot(direction.x(), direction.y())));
  }
  if (!place->allFinite()) place.reset();
  return place;
}

Eigen::Vector3d Lens::undistort(const Eigen::Vector2d& place) const {
  if (!place.allFinite() || !is_finite()) return Eigen::Vector3d::UnitX();
  if (projection == CameraProjection::pinhole) {
    const Eigen::Vector2d ideal = undistorted_place(*this, place);
    return {1.0, -ideal.x(), -ideal.y()};
  }
  if (projection == CameraProjection::fisheye) {
    const double distance = place.norm();
    const auto [sine, cosine] = pinned::sincos(undistorted(*this, distance));
    const double scale = distance > 0.0 ? sine / distance : 0.0;
    return {cosine, -scale * place.x(), -scale * place.y()};
  }
  const auto [right, ahead] = pinned::sincos(std::clamp(place.x(), -kPi, kPi));
  const auto [down, level] = pinned::sincos(std::clamp(place.y(), -0.5 * kPi, 0.5 * kPi));
  return {level * ahead, -level * right, -down};
}

double Lens::place_of_angle(double angle) const {
  if (projection == CameraProjection::pinhole) return pinned::tan(angle);
  return projection == CameraProjection::fisheye ? distorted(*this, angle).value : angle;
}

double Lens::angle_at_place(double place) const {
  if (projection == CameraProjection::pinhole) return pinned::atan2(place, 1.0);
  return projection == CameraProjection::fisheye ? undistorted(*this, place) : place;
}

}  // namespace reorient
