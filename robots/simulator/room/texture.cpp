// SPDX-License-Identifier: MIT
#include "robots/simulator/room/texture.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace reorient {
namespace {

using Plane = std::vector<Eigen::Array4f>;

Plane halve(const Plane& fine, int width, int height) {
  Plane coarse(fine.size() / 4);
  for (int y = 0; y < height / 2; ++y) {
    for (int x = 0; x < width / 2; ++x) {
      const auto corner = static_cast<std::size_t>(2 * y) * static_cast<std::size_t>(width) + 2 * x;
      const auto below = corner + static_cast<std::size_t>(width);
      coarse[static_cast<std::size_t>(y) * static_cast<std::size_t>(width / 2) + x] =
          0.25f * (fine[corner] + fine[corner + 1] + fine[below] + fine[below + 1]);
    }
  }
  return coarse;
}

}  // namespace

int texels_for(double meters, double per_meter) {
  const int requested = std::max(1, static_cast<int>(std::ceil(meters * per_meter)));
  return (requested + Texture::kGranularity - 1) / Texture::kGranularity * Texture::kGranularity;
}

Texture::Texture(const LinearImage& image, const std::vector<float>& light, const Eigen::Vector2d& extent, Edge edge) {
  if (image.width <= 0 || image.height <= 0 || image.width % kGranularity != 0 || image.height % kGranularity != 0) {
    throw std::invalid_argument("texture: expected a width and a height that are positive multiples of 64 texels");
  }
  Plane plane(image.pixels.size());
  for (std::size_t i = 0; i < plane.size(); ++i) {
    plane[i] << image.pixels[i], light.empty() ? 1.0f : light[i];
  }

  std::size_t total = 0;
  for (int level = 0; level < kLevels; ++level) {
    total +=
        static_cast<std::size_t>((image.width >> level) + 2) * static_cast<std::size_t>((image.height >> level) + 2);
  }
  auto memory = std::make_shared<std::vector<Texel>>(total);
  Texel* next = memory->data();
  int width = image.width;
  int height = image.height;
  for (Level& level : levels_) {
    level.texels = next;
    level.stride = width + 2;
    level.scale_u = static_cast<float>(width / extent.x());
    level.scale_v = static_cast<float>(height / extent.y());
    // Just below width + 1, so that the right neighbor lies within the border.
    level.last_column = std::nextafter(static_cast<float>(width + 1), 0.0f);
    level.last_row = std::nextafter(static_cast<float>(height + 1), 0.0f);
    for (int y = -1; y <= height; ++y) {
      for (int x = -1; x <= width; ++x) {
        const int column = edge == Edge::wrap ? (x + width) % width : std::clamp(x, 0, width - 1);
        const int row = std::clamp(y, 0, height - 1);
        const Eigen::Array4f& color = plane[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + column];
        constexpr float kGreatest = 65535.0f;
        for (int channel = 0; channel < 4; ++channel) {
          (*next)[channel] = static_cast<std::uint16_t>(std::clamp(color[channel] * kUnit + 0.5f, 0.0f, kGreatest));
        }
        ++next;
      }
    }
    if (&level != &levels_.back()) plane = halve(plane, width, height);
    width /= 2;
    height /= 2;
  }
  memory_ = std::move(memory);
  texels_per_meter_ = std::sqrt(levels_.front().scale_u * levels_.front().scale_v);
}

}  // namespace reorient
