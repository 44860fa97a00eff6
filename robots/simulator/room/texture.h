// SPDX-License-Identifier: MIT
// Textures of surfaces for the renderer: linear light, coordinates in meters, coarser copies (mip maps) for distances.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <vector>

#include <Eigen/Core>

namespace reorient {

/// Linear light (not gamma coded): red, green, blue. 1 is about the light that white paper reflects in the hall.
using LinearColor = Eigen::Array3f;

/// A picture in linear light. Row 0 is the top row of a picture, and the row at the lowest coordinate of a surface.
struct LinearImage {
  int width = 0;
  int height = 0;
  std::vector<LinearColor> pixels;  ///< row by row

  LinearImage() = default;
  LinearImage(int columns, int rows, const LinearColor& color = LinearColor::Zero())
      : width(columns),
        height(rows),
        pixels(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), color) {}

  LinearColor& at(int x, int y) { return pixels[index(x, y)]; }
  const LinearColor& at(int x, int y) const { return pixels[index(x, y)]; }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
};

/// A mip map over a rectangle of `extent` meters. Immutable; copies share their memory.
class Texture {
 public:
  static constexpr int kLevels = 7;
  /// Width and height of a texture's image must be multiples of this, because each level halves the previous one.
  static constexpr int kGranularity = 1 << (kLevels - 1);

  enum class Edge { clamp, wrap };

  /// Four channels, in memory as fixed-point numbers: 4096 is 1, so that lamps of up to 16 fit in.
  using Color = float __attribute__((vector_size(16)));

  Texture() = default;

  /// `edge` defines what lies beyond the left and right edges; above and below, the last row is repeated.
  /// The fourth channel is `light` with one value for each pixel, or 1 if `light` is empty.
  Texture(const LinearImage& image, const std::vector<float>& light, const Eigen::Vector2d& extent, Edge edge);

  /// Texels per meter of the finest level (geometric mean of both axes).
  float texels_per_meter() const { return texels_per_meter_; }

  /// The level whose texels have about the size of `footprint_in_texels` texels of the finest level.
  static int level_for(float footprint_in_texels) {
    constexpr float kBias = 1.3f;  // texels between 0.77 and 1.54 times the footprint
    constexpr int kExponentOfOne = 127;
    const int exponent =
        static_cast<int>(std::bit_cast<std::uint32_t>(footprint_in_texels * kBias) >> 23) - kExponentOfOne;
    return exponent < 0 ? 0 : (exponent >= kLevels ? kLevels - 1 : exponent);
  }

  /// Interpolates bilinearly at `count` points of one level: u and v in meters, within the extent except for rounding
  /// errors. Calls take(i, color) for each point.
  template <typename Take>
  void sample(const float* u, const float* v, int count, int level, Take&& take) const;

  /// The same at one point.
  Color sample(float u, float v, int level) const {
    Color sampled{};
    sample(&u, &v, 1, level, [&](int, Color color) { sampled = color; });
    return sampled;
  }

 private:
  static constexpr float kUnit = 4096.0f;
  using Texel = std::uint16_t __attribute__((vector_size(8)));

  struct Level {
    const Texel* texels = nullptr;  // with a border of one texel on every side
    int stride = 0;
    float scale_u = 0.0f;  // texels per meter
    float scale_v = 0.0f;
    float last_column = 0.0f;  // greatest sampling coordinate in the bordered image
    float last_row = 0.0f;
  };

  /// From texels[0] to texels[1].
  static Color between(const Texel* texels, float fraction) {
    using Pair = std::uint16_t __attribute__((vector_size(16)));
    using Whole = std::int32_t __attribute__((vector_size(16)));
    static_assert(std::endian::native == std::endian::little, "interleaving with zeros needs little endian");
    Pair pair;
    std::memcpy(&pair, texels, sizeof pair);
    const Pair zeros{};
    const Pair left = __builtin_shufflevector(pair, zeros, 0, 8, 1, 8, 2, 8, 3, 8);
    const Pair right = __builtin_shufflevector(pair, zeros, 4, 8, 5, 8, 6, 8, 7, 8);
    const Color from = __builtin_convertvector(std::bit_cast<Whole>(left), Color);
    const Color to = __builtin_convertvector(std::bit_cast<Whole>(right), Color);
    return from + fraction * (to - from);
  }
  static float limit(float value, float greatest) {
    const float positive = value > 0.0f ? value : 0.0f;
    return positive < greatest ? positive : greatest;
  }

  std::shared_ptr<const std::vector<Texel>> memory_;
  std::array<Level, kLevels> levels_;
  float texels_per_meter_ = 0.0f;
};

template <typename Take>
[[gnu::always_inline]] inline void Texture::sample(const float* u, const float* v, int count, int level,
                                                   Take&& take) const {
  constexpr int kBlock = 64;  // points whose texels are looked up together
  constexpr int kAhead = 12;  // points by which texels are prefetched, because they lie anywhere in memory
  const Level l = levels_[static_cast<std::size_t>(level)];
  alignas(32) int offset[kBlock + kAhead];
  alignas(32) float across[kBlock];
  alignas(32) float up[kBlock];
  for (int begin = 0; begin < count; begin += kBlock) {
    const int points = count - begin < kBlock ? count - begin : kBlock;
    const float* __restrict from_left = u + begin;
    const float* __restrict from_below = v + begin;
#ifndef __clang__  // which does not know this hint
#pragma GCC ivdep
#endif
    for (int i = 0; i < points; ++i) {
      const float column = limit(from_left[i] * l.scale_u + 0.5f, l.last_column);
      const float row = limit(from_below[i] * l.scale_v + 0.5f, l.last_row);
      const int left = static_cast<int>(column);
      const int below = static_cast<int>(row);
      offset[i] = below * l.stride + left;
      across[i] = column - static_cast<float>(left);
      up[i] = row - static_cast<float>(below);
    }
    for (int i = 0; i < kAhead; ++i) offset[points + i] = offset[points - 1];
    for (int i = 0; i < points; ++i) {
      __builtin_prefetch(l.texels + offset[i + kAhead]);
      __builtin_prefetch(l.texels + offset[i + kAhead] + l.stride);
      const Texel* lower = l.texels + offset[i];
      const Color from = between(lower, across[i]);
      const Color to = between(lower + l.stride, across[i]);
      take(begin + i, (from + up[i] * (to - from)) * (1.0f / kUnit));
    }
  }
}

/// The number of texels for `meters` at about `per_meter`, rounded up to a multiple that a Texture accepts.
int texels_for(double meters, double per_meter);

}  // namespace reorient
