#include "perception/room/self_similarity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/bytes.h"

namespace reorient {
namespace {

constexpr int kFewestColumns = 8;  // of a wall with eighths
constexpr int kMostRows = 1000;
constexpr int kTolerance = 48;  // of a turn: 7.5 degrees
constexpr int kAbout = 24;      // of a turn: 15 degrees around an eighth
// That are asked for at once, with those beside them.
constexpr int kMostTurns = 2 * (kMostColumns / kAbout) + 1 + 2 * (kMostColumns / kTolerance);

int wrapped(int column, int columns) { return (column % columns + columns) % columns; }

/// Sum of differences, and how many there are.
struct Differences {
  double sum = 0.0;
  int known = 0;
};

/// Adds those of a tile to the nearest tile around where each turn from `first` to `last` leads, in columns; none where
/// the tile to which it leads is not known.
void add_differences(int tile, int first, int last, const ComparedModel& model, const Wall& wall, Differences& all) {
  const int columns = wall.columns();
  const int within = columns / kTolerance;
  const int row = wall.row_of(tile);
  const int begin = wall.column_of(tile) + first - within;
  const int count = last - first + 1 + 2 * within;
  constexpr double kUnknown = 2.0;  // more than any difference
  std::array<double, kMostTurns> single{};
  for (int i = 0; i < count; ++i) {
    const int other = wall.tile(row, wrapped(begin + i, columns));
    single[static_cast<std::size_t>(i)] = model.trusted(other) ? model.difference(tile, other) : kUnknown;
  }
  for (int i = within; i + within < count; ++i) {
    if (single[static_cast<std::size_t>(i)] == kUnknown) continue;
    all.sum += *std::min_element(single.begin() + (i - within), single.begin() + (i + within + 1));
    ++all.known;
  }
}

}  // namespace

void SelfSimilarity::restart(int columns) {
  columns_.assign(static_cast<std::size_t>(columns), Column{});
  next_ = 0;
  asymmetry_ = 1.0;
}

void SelfSimilarity::observe(const ComparedModel& model, const Wall& wall) {
  const int columns = wall.columns();
  if (columns < kFewestColumns) return;
  const int about = columns / kAbout;
  Column now;
  for (int row = 0; row < wall.rows(); ++row) {
    const int tile = wall.tile(row, next_);
    if (!model.trusted(tile)) continue;
    Differences half, eighths;
    add_differences(tile, columns / 2, columns / 2, model, wall, half);
    if (half.known == 0) continue;
    for (int eighth = 1; eighth < 8; eighth += 2) {
      const int turn = eighth * columns / 8;
      add_differences(tile, turn - about, turn + about, model, wall, eighths);
    }
    if (eighths.known == 0) continue;
    now.half += half.sum;
    now.eighths += eighths.sum / eighths.known;
    ++now.tiles;
  }
  columns_[static_cast<std::size_t>(next_)] = now;
  next_ = (next_ + 1) % columns;
  summarize();
}

void SelfSimilarity::summarize() {
  constexpr int kFewest = 20;  // tiles; of fewer, some may look like their reflections by chance
  Column all;
  for (const Column& column : columns_) {
    all.half += column.half;
    all.eighths += column.eighths;
    all.tiles += column.tiles;
  }
  asymmetry_ = all.tiles >= kFewest && all.eighths > 0.0 ? all.half / all.eighths : 1.0;
}

void SelfSimilarity::turn_half() {
  // Each column as well as its reflection is compared with all others, so their sums only trade places.
  std::rotate(columns_.begin(), columns_.begin() + static_cast<std::ptrdiff_t>(columns_.size() / 2), columns_.end());
}

/// After reading.
void SelfSimilarity::check(std::size_t columns) const {
  check_bytes(columns_.size() == columns && next_ >= 0 && next_ < static_cast<int>(columns),
              "the likeness of a wall with another number of columns");
  check_bytes(std::isfinite(asymmetry_), "the likeness of the wall to itself is not a number");
  for (const Column& column : columns_)
    check_bytes(column.half >= 0.0 && std::isfinite(column.half) && column.eighths >= 0.0 &&
                    std::isfinite(column.eighths) && column.tiles >= 0 && column.tiles <= kMostRows,
                "the likeness of a column is none");
}

}  // namespace reorient
