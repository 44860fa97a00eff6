// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/corner_features.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "geometry/pinned_math.h"
#include "geometry/random.h"

namespace reorient {
namespace {

constexpr int kCircleSize = 16;   // pixels of the circle around a corner
constexpr int kArc = 9;           // contiguous pixels of it that have to differ
constexpr int kPatchRadius = 15;  // pixels: ORB's patch of 31x31
constexpr int kBoxRadius = 2;     // pixels: ORB compares means of 5x5 pixels
constexpr int kDirections = 32;   // ORB has 30; with 32 a quarter turn of the image is a whole number of steps
constexpr int kComparisons = 256;
constexpr std::uint64_t kPatternSeed = 20110611;
static_assert(kPatchRadius + kBoxRadius < kCornerMargin);

struct Offset {
  int x = 0;
  int y = 0;
  bool operator==(const Offset&) const = default;
};

constexpr std::array<Offset, kCircleSize> kCircle{{{0, -3},
                                                   {1, -3},
                                                   {2, -2},
                                                   {3, -1},
                                                   {3, 0},
                                                   {3, 1},
                                                   {2, 2},
                                                   {1, 3},
                                                   {0, 3},
                                                   {-1, 3},
                                                   {-2, 2},
                                                   {-3, 1},
                                                   {-3, 0},
                                                   {-3, -1},
                                                   {-2, -2},
                                                   {-1, -3}}};

/// The largest value that 9 contiguous ones of the circle all reach, or minus the smallest that none exceeds.
int best_arc(const std::array<int, kCircleSize>& differences) {
  int best = 0;
  for (std::size_t first = 0; first < kCircleSize; ++first) {
    int least = 255, most = -255;
    for (std::size_t i = 0; i < kArc; ++i) {
      const int difference = differences[(first + i) % kCircleSize];
      least = std::min(least, difference);
      most = std::max(most, difference);
    }
    best = std::max({best, least, -most});
  }
  return best;
}

/// 0: no corner. Most pixels are ruled out by the ends of the circle's two diameters: an arc of 9 contains 2 of them.
int corner_score(const LumaPlane& image, int x, int y, int contrast) {
  const int center = image.at(x, y);
  std::array<int, kCircleSize> differences{};
  int brighter = 0, darker = 0;
  for (std::size_t i = 0; i < kCircleSize; i += 4) {
    const int difference = image.at(x + kCircle[i].x, y + kCircle[i].y) - center;
    brighter += difference > contrast ? 1 : 0;
    darker += difference < -contrast ? 1 : 0;
  }
  if (brighter < 2 && darker < 2) return 0;
  for (std::size_t i = 0; i < kCircleSize; ++i) differences[i] = image.at(x + kCircle[i].x, y + kCircle[i].y) - center;
  const int best = best_arc(differences);
  return best > contrast ? best - 1 : 0;
}

struct Comparison {
  Offset first, second;
};
using Pattern = std::array<Comparison, kComparisons>;

/// Of the unit circle's direction, in 4096ths.
Offset unit_direction(int direction) {
  const auto [sine, cosine] = pinned::sincos(2.0 * kPi * direction / kDirections);
  return {static_cast<int>(std::nearbyint(4096.0 * cosine)), static_cast<int>(std::nearbyint(4096.0 * sine))};
}

/// Places that are drawn around the corner with the deviation that BRIEF recommends, a fifth of the patch.
Offset random_offset(Random& random) {
  constexpr double kDeviation = (2 * kPatchRadius + 1) / 5.0;
  while (true) {
    const double x = random.normal(), y = random.normal();
    const Offset offset{static_cast<int>(std::nearbyint(kDeviation * x)),
                        static_cast<int>(std::nearbyint(kDeviation * y))};
    if (offset.x * offset.x + offset.y * offset.y <= kPatchRadius * kPatchRadius) return offset;
  }
}

Offset turned(const Offset& offset, const Offset& direction) {
  const auto rounded = [](int value) { return (value + (value < 0 ? -2048 : 2048)) / 4096; };
  return {rounded(offset.x * direction.x - offset.y * direction.y),
          rounded(offset.x * direction.y + offset.y * direction.x)};
}

std::array<Pattern, kDirections> make_patterns() {
  std::array<Pattern, kDirections> patterns;
  Random random(kPatternSeed);
  for (std::size_t i = 0; i < kComparisons; ++i) {
    const Offset first = random_offset(random);
    Offset second = random_offset(random);
    while (second == first) second = random_offset(random);
    for (int direction = 0; direction < kDirections; ++direction) {
      const Offset unit = unit_direction(direction);
      patterns[static_cast<std::size_t>(direction)][i] = {turned(first, unit), turned(second, unit)};
    }
  }
  return patterns;
}

/// The same comparisons for each direction of a patch.
const Pattern& pattern_of(int direction) {
  static const std::array<Pattern, kDirections> patterns = make_patterns();
  return patterns[static_cast<std::size_t>(direction)];
}

const std::array<Offset, kDirections>& unit_directions() {
  static const std::array<Offset, kDirections> units = [] {
    std::array<Offset, kDirections> all;
    for (int i = 0; i < kDirections; ++i) all[static_cast<std::size_t>(i)] = unit_direction(i);
    return all;
  }();
  return units;
}

}  // namespace

LumaPlane::LumaPlane(const ImageView& image) {
  if (image.empty()) return;
  width = image.width;
  height = image.height;
  pixels.reserve(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) pixels.push_back(image.luma(x, y));
  }
}

std::vector<Corner> find_corners(const LumaPlane& image, int rows, int contrast) {
  const int begin_x = kCornerMargin, end_x = image.width - kCornerMargin;
  const int begin_y = kCornerMargin, end_y = std::min(rows, image.height - kCornerMargin);
  std::vector<Corner> corners;
  if (begin_x >= end_x || begin_y >= end_y) return corners;
  // With an edge of zeros all around, so that every pixel has neighbors.
  const auto width = static_cast<std::size_t>(end_x - begin_x + 2);
  std::vector<int> scores(width * static_cast<std::size_t>(end_y - begin_y + 2));
  const auto place = [&](int x, int y) {
    return static_cast<std::size_t>(y - begin_y + 1) * width + static_cast<std::size_t>(x - begin_x + 1);
  };
  for (int y = begin_y; y < end_y; ++y) {
    for (int x = begin_x; x < end_x; ++x) scores[place(x, y)] = corner_score(image, x, y, contrast);
  }
  for (int y = begin_y; y < end_y; ++y) {
    for (int x = begin_x; x < end_x; ++x) {
      const std::size_t at = place(x, y);
      const int score = scores[at];
      if (score == 0) continue;
      // Of equal scores the first one counts.
      const bool is_best = score > scores[at - width - 1] && score > scores[at - width] &&
                           score > scores[at - width + 1] && score > scores[at - 1] && score >= scores[at + 1] &&
                           score >= scores[at + width - 1] && score >= scores[at + width] &&
                           score >= scores[at + width + 1];
      if (is_best) corners.push_back({x, y, score});
    }
  }
  return corners;
}

int distance(const CornerDescriptor& a, const CornerDescriptor& b) {
  int bits = 0;
  for (std::size_t i = 0; i < a.size(); ++i) bits += std::popcount(a[i] ^ b[i]);
  return bits;
}

CornerDescriber::CornerDescriber(const LumaPlane& image, int rows) : image_(&image), sums_(image.pixels.size()) {
  const int end_y = std::min(rows + kCornerMargin, image.height - kBoxRadius);
  const auto width = static_cast<std::size_t>(std::max(image.width, 0));
  std::vector<int> columns(width);  // sums of 5 pixels of a column
  for (int y = kBoxRadius; y < end_y; ++y) {
    for (int x = 0; x < image.width; ++x) {
      int& column = columns[static_cast<std::size_t>(x)];
      column = 0;
      for (int i = -kBoxRadius; i <= kBoxRadius; ++i) column += image.at(x, y + i);
    }
    for (std::size_t x = kBoxRadius; x + kBoxRadius < width; ++x) {
      int sum = 0;
      for (std::size_t i = x - kBoxRadius; i <= x + kBoxRadius; ++i) sum += columns[i];
      sums_[static_cast<std::size_t>(y) * width + x] = static_cast<std::uint16_t>(sum);
    }
  }
}

int CornerDescriber::direction_of(const Corner& corner) const {
  int moment_x = 0, moment_y = 0;
  for (int dy = -kPatchRadius; dy <= kPatchRadius; ++dy) {
    for (int dx = -kPatchRadius; dx <= kPatchRadius; ++dx) {
      if (dx * dx + dy * dy > kPatchRadius * kPatchRadius) continue;
      const int luma = image_->at(corner.x + dx, corner.y + dy);
      moment_x += dx * luma;
      moment_y += dy * luma;
    }
  }
  std::int64_t most = 0;
  int best = 0;
  for (int i = 0; i < kDirections; ++i) {
    const Offset& unit = unit_directions()[static_cast<std::size_t>(i)];
    const std::int64_t along = std::int64_t{moment_x} * unit.x + std::int64_t{moment_y} * unit.y;
    if (along <= most) continue;
    most = along;
    best = i;
  }
  return best;
}

CornerDescriptor CornerDescriber::describe(const Corner& corner) const {
  const Pattern& pattern = pattern_of(direction_of(corner));
  CornerDescriptor descriptor{};
  for (std::size_t i = 0; i < kComparisons; ++i) {
    const auto& [first, second] = pattern[i];
    const bool is_darker =
        smoothed(corner.x + first.x, corner.y + first.y) < smoothed(corner.x + second.x, corner.y + second.y);
    descriptor[i / 64] |= std::uint64_t{is_darker ? 1U : 0U} << (i % 64);
  }
  return descriptor;
}

}  // namespace reorient
