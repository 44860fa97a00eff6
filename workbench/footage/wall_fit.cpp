// SPDX-License-Identifier: MIT
#include "workbench/footage/wall_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/pinned_math.h"
#include "geometry/random.h"

namespace reorient {
namespace {

constexpr int kSmallWidth = 160;      // pixels
constexpr double kMostRadius = 40.0;  // m
constexpr int kRadii = 40;            // tried radii, each slightly larger than the last
constexpr std::size_t kMostPairs = 1200;
constexpr std::size_t kFewestPairs = 12;  // of images with a match
constexpr double kLeastBaseline = 0.1;    // m between two cameras
constexpr int kResamples = 200;

// Patches of an image that are searched in another one.
constexpr int kPatchColumns = 10, kPatchRows = 6;
constexpr int kPatchReach = 3;             // pixels to each side
constexpr double kLeastContrast = 5.0;     // standard deviation of a patch's luma
constexpr double kLeastCorrelation = 0.9;  // of a match
constexpr double kUniqueness = 0.1;        // margin over all matches at clearly different distances
constexpr int kNeighbors = 2;              // radii to each side that are not clearly different

Eigen::Vector3d axis_of(const WallView& view) { return view.field_from_camera.linear().col(0); }

/// Bilinear; the pixel lies within the image.
double luma_at(const WallView& view, const Eigen::Vector2d& pixel) {
  const double x = std::clamp(pixel.x(), 0.0, view.camera.width - 1.001);
  const double y = std::clamp(pixel.y(), 0.0, view.camera.height - 1.001);
  const auto column = static_cast<std::size_t>(x), row = static_cast<std::size_t>(y);
  const double right = x - static_cast<double>(column), down = y - static_cast<double>(row);
  const float* const above = view.luma.data() + row * static_cast<std::size_t>(view.camera.width) + column;
  const float* const below = above + view.camera.width;
  return (1.0 - down) * ((1.0 - right) * above[0] + right * above[1]) +
         down * ((1.0 - right) * below[0] + right * below[1]);
}

/// The point at which a ray from inside meets the cylinder about the field's center.
Eigen::Vector3d on_cylinder(const Eigen::Vector3d& from, const Eigen::Vector3d& direction, double radius) {
  const Eigen::Vector2d p = from.head<2>(), d = direction.head<2>();
  const double a = d.squaredNorm(), b = p.dot(d), c = p.squaredNorm() - radius * radius;
  return from + (std::sqrt(b * b - a * c) - b) / a * direction;
}

/// The correlation of a patch with another image at the same points of the wall; nothing if they are not in view, or if
/// the patch has no contrast.
std::optional<double> correlation(const WallView& one, const Eigen::Vector2d& middle, const WallView& other,
                                  const Isometry3& other_from_field, double radius) {
  constexpr int kPixels = (2 * kPatchReach + 1) * (2 * kPatchReach + 1);
  double sum_a = 0.0, sum_b = 0.0, sum_aa = 0.0, sum_bb = 0.0, sum_ab = 0.0;
  for (int dy = -kPatchReach; dy <= kPatchReach; ++dy) {
    for (int dx = -kPatchReach; dx <= kPatchReach; ++dx) {
      const Eigen::Vector2d pixel = middle + Eigen::Vector2d(dx, dy);
      const Eigen::Vector3d ray = one.field_from_camera.linear() * one.camera.ray(pixel);
      const Eigen::Vector3d point = on_cylinder(one.field_from_camera.translation(), ray, radius);
      const std::optional<Eigen::Vector2d> seen = other.camera.project(other_from_field * point);
      if (!seen || !other.camera.contains(*seen)) return std::nullopt;
      const double a = luma_at(one, pixel), b = luma_at(other, *seen);
      sum_a += a;
      sum_b += b;
      sum_aa += a * a;
      sum_bb += b * b;
      sum_ab += a * b;
    }
  }
  const double a = sum_aa - sum_a * sum_a / kPixels, b = sum_bb - sum_b * sum_b / kPixels;
  if (!(a > kPixels * kLeastContrast * kLeastContrast) || !(b > 1e-6)) return std::nullopt;
  return (sum_ab - sum_a * sum_b / kPixels) / std::sqrt(a * b);
}

/// The radius of a patch; nothing without a match, or with several.
std::optional<double> radius_of(const WallView& one, const Eigen::Vector2d& middle, const WallView& other,
                                const Isometry3& other_from_field, std::span<const double> radii) {
  std::array<double, kRadii> matches;
  matches.fill(-1.0);
  int best = 0;
  for (int i = 0; i < kRadii; ++i) {
    const auto index = static_cast<std::size_t>(i);
    const auto match = correlation(one, middle, other, other_from_field, radii[index]);
    if (match) matches[index] = *match;
    if (matches[index] > matches[static_cast<std::size_t>(best)]) best = i;
  }
  const double most = matches[static_cast<std::size_t>(best)];
  // At either end, the best radius may be out of range.
  if (most < kLeastCorrelation || best == 0 || best == kRadii - 1) return std::nullopt;
  for (int i = 0; i < kRadii; ++i) {
    if (std::abs(i - best) > kNeighbors && matches[static_cast<std::size_t>(i)] > most - kUniqueness)
      return std::nullopt;
  }
  return radii[static_cast<std::size_t>(best)];
}

std::vector<double> radii_beyond(double farthest) {
  const double least = std::max(1.0, 1.25 * farthest);
  std::vector<double> radii;
  radii.reserve(kRadii);
  for (int i = 0; i < kRadii; ++i)
    radii.push_back(least * pinned::exp(pinned::log(std::max(kMostRadius / least, 1.01)) * i / (kRadii - 1)));
  return radii;
}

struct Pair {
  std::size_t one = 0, other = 0;
  double baseline = 0.0;  ///< m between the cameras
};

/// Pairs of images with similar directions from different positions, evenly over the baselines: short baselines measure
/// near objects, long ones distant objects.
std::vector<Pair> pairs_of(std::span<const WallView> views) {
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < views.size(); ++i) {
    for (std::size_t j = 0; j < views.size(); ++j) {
      const double same = axis_of(views[i]).dot(axis_of(views[j]));
      const double baseline =
          (views[i].field_from_camera.translation() - views[j].field_from_camera.translation()).norm();
      if (i != j && baseline >= kLeastBaseline && same >= pinned::cos(0.7 * views[i].camera.horizontal_field_of_view()))
        pairs.push_back({i, j, baseline});
    }
  }
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.baseline > b.baseline; });
  const std::size_t every = (pairs.size() + kMostPairs - 1) / kMostPairs;
  for (std::size_t i = 0; every > 1 && i * every < pairs.size(); ++i) pairs[i] = pairs[i * every];
  pairs.resize(std::min(pairs.size(), kMostPairs));
  return pairs;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

std::optional<WallView> wall_view(const FootageFrame& frame) {
  if (!frame.pose) return std::nullopt;
  const int factor = std::max(1, frame.image.width() / kSmallWidth);
  WallView view;
  view.camera = frame.camera.scaled_to(frame.image.width() / factor, frame.image.height() / factor);
  view.field_from_camera = to_isometry(*frame.pose) * frame.robot_from_camera;
  view.luma.reserve(static_cast<std::size_t>(view.camera.width) * static_cast<std::size_t>(view.camera.height));
  const ImageView image = frame.image.view();
  for (int y = 0; y < view.camera.height; ++y) {
    for (int x = 0; x < view.camera.width; ++x) {
      int sum = 0;
      for (int dy = 0; dy < factor; ++dy) {
        for (int dx = 0; dx < factor; ++dx) sum += image.luma(factor * x + dx, factor * y + dy);
      }
      view.luma.push_back(static_cast<float>(sum) / static_cast<float>(factor * factor));
    }
  }
  return view;
}

std::optional<WallFit> fit_wall(std::span<const WallView> views) {
  double farthest = 0.0;
  for (const WallView& view : views)
    farthest = std::max(farthest, view.field_from_camera.translation().head<2>().norm());
  const std::vector<double> radii = radii_beyond(farthest);
  std::vector<std::vector<double>> found;  // of each pair
  for (const Pair& pair : pairs_of(views)) {
    const WallView& one = views[pair.one];
    const WallView& other = views[pair.other];
    const Isometry3 other_from_field = other.field_from_camera.inverse();
    std::vector<double> here;
    for (int row = 0; row < kPatchRows; ++row) {
      for (int column = 0; column < kPatchColumns; ++column) {
        // Use the upper half only: below, floor and furniture are nearer than the wall.
        const Eigen::Vector2d middle(
            kPatchReach + (column + 0.5) / kPatchColumns * (one.camera.width - 2 * kPatchReach),
            kPatchReach + (row + 0.5) / kPatchRows * (0.5 * one.camera.height - kPatchReach));
        if (const auto radius = radius_of(one, middle, other, other_from_field, radii)) here.push_back(*radius);
      }
    }
    if (!here.empty()) found.push_back(std::move(here));
  }
  if (found.size() < kFewestPairs) return std::nullopt;
  const auto median = [&](auto&& pick) {
    std::vector<double> all;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::vector<double>& here = found[pick(i)];
      all.insert(all.end(), here.begin(), here.end());
    }
    return median_of(std::move(all));
  };
  WallFit fit;
  fit.pairs = static_cast<int>(found.size());
  fit.radius = median([](std::size_t i) { return i; });
  Random random(1);
  std::vector<double> others;
  others.reserve(kResamples);
  for (int i = 0; i < kResamples; ++i)
    others.push_back(median([&](std::size_t) { return static_cast<std::size_t>(random.below(found.size())); }));
  std::sort(others.begin(), others.end());
  fit.low = others[kResamples / 20];
  fit.high = others[kResamples - 1 - kResamples / 20];
  constexpr double kVague = 2.0;
  if (fit.high > kVague * fit.low) return std::nullopt;
  return fit;
}

WallParameters wall_of(double radius, std::span<const WallView> views, const WallParameters& usual) {
  std::vector<double> tops, heights;
  for (const WallView& view : views) {
    const Eigen::Vector3d ray = view.field_from_camera.linear() * view.camera.ray({view.camera.center.x(), 0.0});
    const double height = view.field_from_camera.translation().z();
    tops.push_back(height + radius * ray.z() / ray.head<2>().norm());
    heights.push_back(height);
  }
  WallParameters wall = usual;
  wall.radius = radius;
  const double eye = median_of(std::move(heights));
  wall.bottom = 0.5 * eye;
  wall.top = std::max(median_of(std::move(tops)), eye + 0.2 * radius);
  const double column = radius * 2.0 * kPi / wall.columns;
  wall.rows = std::clamp(static_cast<int>(std::lround((wall.top - wall.bottom) / column)), 2, 8);
  return wall;
}

}  // namespace reorient
