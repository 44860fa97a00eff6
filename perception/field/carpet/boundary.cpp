// SPDX-License-Identifier: MIT
#include "perception/field/carpet/boundary.h"

#include <algorithm>

namespace reorient {
namespace {

constexpr int kColumns = CarpetMap::kColumns;

/// Adds up from the bottom: carpet counts for continuing, everything else against it. So the search passes a line or a
/// robot if enough carpet follows, but it does not reach a green banner beyond the field.
int highest_carpet(const CarpetMap& map, int column) {
  constexpr int kLeast = 3;  // cells of carpet
  constexpr int kAgainst = 2;
  constexpr int kOccluder = -10;  // largest penalty for an object at the image's bottom, whatever its height
  int best_row = map.rows();
  int best = kLeast - 1;
  int score = 0;
  for (int row = map.rows() - 1; row >= map.first_cell(); --row) {
    const Surface surface = map.at(column, row);
    if (surface == Surface::carpet) ++score;
    if (surface == Surface::other) score -= kAgainst;
    if (best_row == map.rows()) score = std::max(score, kOccluder);
    if (score <= best || surface != Surface::carpet) continue;
    best = score;
    best_row = row;
  }
  return best_row;
}

/// Lowers columns that reach higher than most of their neighbors, since they followed something beyond the field.
int without_spike(const StraightEdges::Rows& rows, int column) {
  constexpr int kReach = 3;
  std::array<int, 2 * kReach + 1> around{};
  int neighbor = column - kReach;
  for (int& row : around) row = rows[static_cast<std::size_t>(std::clamp(neighbor++, 0, kColumns - 1))];
  std::nth_element(around.begin(), around.begin() + kReach, around.end());
  return std::max(rows[static_cast<std::size_t>(column)], around[kReach]);
}

}  // namespace

/// The first row at or below `row` that is not beyond an edge.
int Boundary::within_edges(const CarpetMap& map, int column, int row) const {
  const auto is_beyond = [&](int at) {
    return edges_.is_beyond({static_cast<double>(map.column_pixel(column)), static_cast<double>(map.row_pixel(at))});
  };
  if (row >= map.rows() || !is_beyond(row)) return row;
  int beyond = row, within = map.rows();
  while (within - beyond > 1) {
    const int middle = (beyond + within) / 2;
    (is_beyond(middle) ? beyond : within) = middle;
  }
  return within;
}

void Boundary::find(const CarpetMap& map, const CameraModel& camera, std::vector<float>& boundary) {
  const auto row_of = [&](int column) { return smooth_[static_cast<std::size_t>(column)]; };
  for (int i = 0; i < kColumns; ++i) highest_[static_cast<std::size_t>(i)] = highest_carpet(map, i);
  for (int i = 0; i < kColumns; ++i) smooth_[static_cast<std::size_t>(i)] = without_spike(highest_, i);
  edges_.find(map, camera, smooth_);
  for (int i = 0; i < kColumns; ++i) {
    int& row = smooth_[static_cast<std::size_t>(i)];
    row = within_edges(map, i, row);
  }

  // Upper convex hull of the columns with carpet in view (Andrew, 1979). Rows count downward.
  std::size_t size = 0;
  for (int i = 0; i < kColumns; ++i) {
    if (row_of(i) >= map.rows()) continue;
    while (size >= 2) {
      const int a = hull_[size - 2];
      const int b = hull_[size - 1];
      if ((b - a) * (row_of(i) - row_of(a)) > (i - a) * (row_of(b) - row_of(a))) break;  // b is above the chord
      --size;
    }
    hull_[size++] = i;
  }

  boundary.assign(kColumns, static_cast<float>(camera.height));
  for (std::size_t k = 0; k < size; ++k) {
    const int from = hull_[k];
    const int to = hull_[std::min(k + 1, size - 1)];
    for (int i = from; i <= to; ++i) {
      const double fraction = to > from ? static_cast<double>(i - from) / (to - from) : 0.0;
      const double row = row_of(from) + fraction * (row_of(to) - row_of(from));
      boundary[static_cast<std::size_t>(i)] = static_cast<float>(row * map.step());
    }
  }
}

bool shows_carpet(const std::vector<float>& boundary, int image_height) {
  return std::any_of(boundary.begin(), boundary.end(),
                     [&](float row) { return row < static_cast<float>(image_height); });
}

double boundary_at(const std::vector<float>& boundary, int width, double column) {
  if (boundary.empty() || width <= 0) return 0.0;
  const double last = static_cast<double>(boundary.size()) - 1.0;
  const double position = std::clamp((column + 0.5) * static_cast<double>(boundary.size()) / width - 0.5, 0.0, last);
  const auto left = static_cast<std::size_t>(position);
  const auto right = std::min(left + 1, boundary.size() - 1);
  const double fraction = position - static_cast<double>(left);
  return (1.0 - fraction) * boundary[left] + fraction * boundary[right];
}

}  // namespace reorient
