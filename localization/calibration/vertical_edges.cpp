// SPDX-License-Identifier: MIT
#include "localization/calibration/vertical_edges.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

// Rounding to integer gray values would rotate a weaker gradient by more than kSameDirection.
constexpr double kSameDirection = from_degrees(22.5);
constexpr double kLeastGradient = 5.2;    // gray values per pixel
constexpr double kShortest = 1.0 / 15.0;  // of an edge, in heights of the image
constexpr double kSlimmest = 5.0;         // length over width

struct Gradients {
  int width = 0, height = 0;
  std::vector<float> x, y, strength;
  std::size_t at(int u, int v) const {
    return static_cast<std::size_t>(v) * static_cast<std::size_t>(width) + static_cast<std::size_t>(u);
  }
};

/// Scharr's operator, in gray values per pixel.
Gradients gradients_of(const ImageView& image) {
  Gradients all{image.width, image.height, {}, {}, {}};
  const std::size_t size = static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height);
  all.x.assign(size, 0.0f);
  all.y.assign(size, 0.0f);
  all.strength.assign(size, 0.0f);
  for (int v = 1; v + 1 < image.height; ++v) {
    for (int u = 1; u + 1 < image.width; ++u) {
      const auto luma = [&](int du, int dv) { return static_cast<int>(image.luma(u + du, v + dv)); };
      const int x = 3 * (luma(1, -1) - luma(-1, -1)) + 10 * (luma(1, 0) - luma(-1, 0)) + 3 * (luma(1, 1) - luma(-1, 1));
      const int y = 3 * (luma(-1, 1) - luma(-1, -1)) + 10 * (luma(0, 1) - luma(0, -1)) + 3 * (luma(1, 1) - luma(1, -1));
      const std::size_t i = all.at(u, v);
      all.x[i] = static_cast<float>(x) / 32.0f;
      all.y[i] = static_cast<float>(y) / 32.0f;
      all.strength[i] = std::sqrt(all.x[i] * all.x[i] + all.y[i] * all.y[i]);
    }
  }
  return all;
}

/// Fits a line to the pixels of a region, weighted by their gradients.
bool edge_of(const Gradients& gradients, const std::vector<std::size_t>& region, ImageEdge& edge) {
  double weight = 0.0;
  Eigen::Vector2d mean = Eigen::Vector2d::Zero();
  const auto pixel = [&](std::size_t i) {
    const auto width = static_cast<std::size_t>(gradients.width);
    const std::size_t u = i % width, v = i / width;
    return Eigen::Vector2d(static_cast<double>(u), static_cast<double>(v));
  };
  for (const std::size_t i : region) {
    const double strength = gradients.strength[i];
    weight += strength;
    mean += strength * pixel(i);
  }
  mean /= weight;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const std::size_t i : region) {
    const Eigen::Vector2d off = pixel(i) - mean;
    spread += gradients.strength[i] / weight * off * off.transpose();
  }
  const double angle = 0.5 * pinned::atan2(2.0 * spread(0, 1), spread(0, 0) - spread(1, 1));
  Eigen::Vector2d along = unit_vector(angle);
  if (along.y() < 0.0) along = -along;
  const Eigen::Vector2d across(-along.y(), along.x());
  double first = 0.0, last = 0.0;
  for (const std::size_t i : region) {
    const double distance = (pixel(i) - mean).dot(along);
    first = std::min(first, distance);
    last = std::max(last, distance);
  }
  const double width = std::sqrt(12.0 * std::max(across.dot(spread * across), 0.0));  // of a rectangle with that spread
  edge = {mean + first * along, mean + last * along};
  return last - first >= std::max(8.0, kShortest * gradients.height) && last - first >= kSlimmest * width;
}

}  // namespace

std::vector<ImageEdge> vertical_edges(const ImageView& image, const CameraModel& camera,
                                      const Isometry3& robot_from_camera, double reach) {
  std::vector<ImageEdge> edges;
  if (image.empty() || image.width < 3 || image.height < 3) return edges;
  const Gradients gradients = gradients_of(image);
  const Eigen::Vector3d up = robot_from_camera.linear().transpose() * Eigen::Vector3d::UnitZ();
  // Candidates: strong pixels whose edge is nearly vertical.
  std::vector<std::size_t> seeds;
  std::vector<std::uint8_t> is_free(gradients.strength.size(), 0);
  const double tolerance = pinned::sin(reach + kSameDirection);
  for (int v = 1; v + 1 < image.height; ++v) {
    for (int u = 1; u + 1 < image.width; ++u) {
      const std::size_t i = gradients.at(u, v);
      if (gradients.strength[i] < kLeastGradient) continue;
      const Eigen::Vector3d ray = camera.ray({static_cast<double>(u), static_cast<double>(v)});
      const Eigen::Vector2d vertical(-(up.y() - ray.y() * up.x()) * camera.focal.x(),
                                     -(up.z() - ray.z() * up.x()) * camera.focal.y());
      const double across = gradients.x[i] * vertical.x() + gradients.y[i] * vertical.y();
      if (std::abs(across) > tolerance * gradients.strength[i] * vertical.norm()) continue;
      is_free[i] = 1;
      seeds.push_back(i);
    }
  }
  std::sort(seeds.begin(), seeds.end(), [&](std::size_t a, std::size_t b) {
    return gradients.strength[a] != gradients.strength[b] ? gradients.strength[a] > gradients.strength[b] : a < b;
  });
  const double similar = pinned::cos(kSameDirection);
  std::vector<std::size_t> region;
  for (const std::size_t seed : seeds) {
    if (is_free[seed] == 0) continue;
    region.assign(1, seed);
    is_free[seed] = 0;
    Eigen::Vector2d direction(gradients.x[seed], gradients.y[seed]);
    for (std::size_t next = 0; next < region.size(); ++next) {
      const int u = static_cast<int>(region[next] % static_cast<std::size_t>(image.width));
      const int v = static_cast<int>(region[next] / static_cast<std::size_t>(image.width));
      for (int dv = -1; dv <= 1; ++dv) {
        for (int du = -1; du <= 1; ++du) {
          const std::size_t i = gradients.at(u + du, v + dv);
          if (is_free[i] == 0) continue;
          const Eigen::Vector2d gradient(gradients.x[i], gradients.y[i]);
          if (gradient.dot(direction) < similar * gradients.strength[i] * direction.norm()) continue;
          is_free[i] = 0;
          region.push_back(i);
          direction += gradient;
        }
      }
    }
    ImageEdge edge;
    if (edge_of(gradients, region, edge)) edges.push_back(edge);
  }
  return edges;
}

}  // namespace reorient
