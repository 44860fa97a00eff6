// SPDX-License-Identifier: MIT
#include "robots/simulator/render/scene/field_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "geometry/field_landmarks.h"
#include "geometry/random.h"
#include "geometry/wide.h"
#include "robots/simulator/render/coverage.h"

namespace reorient {
namespace {

/// A number in [0, 1) that is the same for all points of a patch of ground.
float chance_of_patch(float x, float y) {
  constexpr float kPatch = 0.25f;  // m
  const auto column = static_cast<std::int32_t>(std::floor(x / kPatch));
  const auto row = static_cast<std::int32_t>(std::floor(y / kPatch));
  const std::uint64_t patch =
      (static_cast<std::uint64_t>(static_cast<std::uint32_t>(column)) << 32) | static_cast<std::uint32_t>(row);
  return static_cast<float>(scatter(patch) >> 40) * 0x1p-24f;
}

}  // namespace

FieldLines::FieldLines(const FieldDimensions& field, double worn) : worn_(static_cast<float>(worn)) {
  // Adds lines that reach into the quarter in which both coordinates are positive. `beside`: half of the width.
  const auto add = [&](const FieldLine& line, const Eigen::Vector2d& beside) {
    constexpr double kAcross = -1e6;  // patches extend beyond the axes of symmetry
    const Eigen::Vector2d low = line.from.cwiseMin(line.to) - beside, high = line.from.cwiseMax(line.to) + beside;
    if (high.minCoeff() <= 0.0) return;
    strips_.push_back({static_cast<float>(low.x() < 0.0 ? kAcross : low.x()), static_cast<float>(high.x()),
                       static_cast<float>(low.y() < 0.0 ? kAcross : low.y()), static_cast<float>(high.y())});
  };
  const double half = 0.5 * field.line_width, mark = 0.5 * field.penalty_mark_size;
  for (const FieldLine& line : field_lines(field)) add(line, {half, half});
  for (const Eigen::Vector2d& position : penalty_marks(field)) {
    add({position, position}, {mark, half});
    add({position, position}, {half, mark});
  }
  add({{0.0, 0.0}, {0.0, 0.0}}, {mark, half});  // kick-off mark
  const Eigen::Vector2d corner = field_half_size(field);
  circle_radius_ = static_cast<float>(field.center_circle_radius);
  corner_x_ = static_cast<float>(corner.x());
  corner_y_ = static_cast<float>(corner.y());
  corner_radius_ = static_cast<float>(field.corner_arc_radius);
  half_line_ = static_cast<float>(half);
}

REORIENT_WIDE void FieldLines::cover(const GroundPatches& patches, float* __restrict coverage) const {
  const int count = patches.count;
  if (count <= 0) return;
  const float* __restrict x = patches.x;
  const float* __restrict y = patches.y;
  const float* __restrict half_x = patches.half_x;
  const float* __restrict half_y = patches.half_y;

  // The extent of the whole row, because most strips are far away from most rows.
  float least_x = std::numeric_limits<float>::max();
  float most_x = 0.0f;
  float least_y = std::numeric_limits<float>::max();
  float most_y = 0.0f;
  for (int i = 0; i < count; ++i) {
    const float folded_x = std::fabs(x[i]);
    const float folded_y = std::fabs(y[i]);
    least_x = std::min(least_x, folded_x - half_x[i]);
    most_x = std::max(most_x, folded_x + half_x[i]);
    least_y = std::min(least_y, folded_y - half_y[i]);
    most_y = std::max(most_y, folded_y + half_y[i]);
  }

  const float circle = circle_radius_;
  const float half_line = half_line_;
  const float outer = circle + half_line;
  if (least_x < outer && least_y < outer) {
    for (int i = 0; i < count; ++i) {
      const float radius = std::sqrt(x[i] * x[i] + y[i] * y[i]) + 1e-6f;
      const float across_x = half_x[i] * x[i] / radius;
      const float across_y = half_y[i] * y[i] / radius;
      const float half = std::sqrt(across_x * across_x + across_y * across_y) + 1e-6f;
      coverage[i] = covered_fraction(radius, half, circle - half_line, outer);
    }
  } else {
    std::fill(coverage, coverage + count, 0.0f);
  }
  for (const Strip& strip : strips_) {
    if (strip.low_x > most_x || strip.high_x < least_x || strip.low_y > most_y || strip.high_y < least_y) continue;
    for (int i = 0; i < count; ++i) {
      const float part = covered_fraction(std::fabs(x[i]), half_x[i], strip.low_x, strip.high_x) *
                         covered_fraction(std::fabs(y[i]), half_y[i], strip.low_y, strip.high_y);
      coverage[i] = part > coverage[i] ? part : coverage[i];
    }
  }
  const float reach = corner_radius_ + half_line;
  if (corner_radius_ > 0.0f && most_x > corner_x_ - reach && most_y > corner_y_ - reach) {
    for (int i = 0; i < count; ++i) {
      const float inward_x = corner_x_ - std::fabs(x[i]);
      const float inward_y = corner_y_ - std::fabs(y[i]);
      const float radius = std::sqrt(inward_x * inward_x + inward_y * inward_y) + 1e-6f;
      const float across_x = half_x[i] * inward_x / radius;
      const float across_y = half_y[i] * inward_y / radius;
      const float half = std::sqrt(across_x * across_x + across_y * across_y) + 1e-6f;
      const float arc = covered_fraction(radius, half, corner_radius_ - half_line, reach);
      const float part = inward_x > 0.0f && inward_y > 0.0f ? arc : 0.0f;
      coverage[i] = part > coverage[i] ? part : coverage[i];
    }
  }
  if (worn_ <= 0.0f) return;
  for (int i = 0; i < count; ++i) {
    if (coverage[i] > 0.0f && chance_of_patch(x[i], y[i]) < worn_) coverage[i] = 0.0f;
  }
}

float FieldLines::cover(float x, float y, float half_x, float half_y) const {
  float coverage = 0.0f;
  cover({&x, &y, &half_x, &half_y, 1}, &coverage);
  return coverage;
}

}  // namespace reorient
