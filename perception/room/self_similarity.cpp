#include "perception/room/self_similarity.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/bytes.h"

namespace reorient {
namespace {

constexpr int kFewestColumns = 8;  // of a wall with eighths
constexpr int kMostRows = 1000;

int wrapped(int column, int columns) { return (column % columns + columns) % columns; }

/// Of a tile to the nearest tile around where `turn` columns lead; nothing where that tile is not known.
std::optional<double> difference_after(int tile, int turn, const ComparedModel& model, const Wall& wall) {
  const int columns = wall.columns();
  const int within = columns / 48;  // 7.5 degrees
  const int row = wall.row_of(tile);
  const int there = wall.column_of(tile) + turn;
  if (!model.trusted(wall.tile(row, wrapped(there, columns)))) return std::nullopt;
  double least = 1.0;
  for (int column = there - within; column <= there + within; ++column) {
    const int other = wall.tile(row, wrapped(column, columns));
    if (model.trusted(other)) least = std::min(least, model.difference(tile, other));
  }
  return least;
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
  const int about = columns / 24;  // 15 degrees
  Column now;
  for (int row = 0; row < wall.rows(); ++row) {
    const int tile = wall.tile(row, next_);
    if (!model.trusted(tile)) continue;
    const std::optional<double> half = difference_after(tile, columns / 2, model, wall);
    if (!half) continue;
    double sum = 0.0;
    int known = 0;
    for (int eighths = 1; eighths < 8; eighths += 2) {
      for (int turn = eighths * columns / 8 - about; turn <= eighths * columns / 8 + about; ++turn) {
        const std::optional<double> difference = difference_after(tile, turn, model, wall);
        if (!difference) continue;
        sum += *difference;
        ++known;
      }
    }
    if (known == 0) continue;
    now.half += *half;
    now.eighths += sum / known;
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
