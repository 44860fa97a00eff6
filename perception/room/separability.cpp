// SPDX-License-Identifier: MIT
#include "perception/room/separability.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "geometry/bytes.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr double kExpected = 0.8;        // expected s without data
constexpr double kLeast = 0.03;          // t: amount of difference that has the same weight as the expected value
constexpr double kMisfitFraction = 0.7;  // the nearest of several tiles differs by less than the misfit
constexpr double kUsualMisfit = 0.15;
constexpr std::size_t kParts = 8;
constexpr int kFewestTiles = 20;   // with fewer tiles, some may look like their reflections by chance
constexpr int kFewestColumns = 8;  // of a wall that can be rotated by eighths
constexpr int kMostRows = 1000;
constexpr int kTolerance = 48;  // 1/48 of a turn: 7.5 degrees
constexpr int kAbout = 24;      // 1/24 of a turn: 15 degrees around an eighth
// Largest number of rotations that are compared at once, with those beside them.
constexpr int kMostTurns = 2 * (kMostColumns / kAbout) + 1 + 2 * (kMostColumns / kTolerance);

int wrapped(int column, int columns) { return (column % columns + columns) % columns; }

/// Sum and number of differences.
struct Differences {
  double sum = 0.0;
  int known = 0;
};

/// For each rotation from `first` to `last` (columns), adds the difference between a tile and the nearest tile around
/// its rotated position. Adds nothing if the tile at that position is unknown.
void add_differences(int tile, int first, int last, const ComparedModel& model, const Wall& wall, Differences& all) {
  const int columns = wall.columns();
  const int within = columns / kTolerance;
  const int row = wall.row_of(tile);
  const int begin = wall.column_of(tile) + first - within;
  const int count = last - first + 1 + 2 * within;
  constexpr double kUnknown = 2.0;  // greater than any difference
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

Separability::Column& Separability::Column::operator+=(const Column& other) {
  half += other.half;
  eighths += other.eighths;
  tiles += other.tiles;
  return *this;
}

void Separability::restart(int columns) {
  columns_.assign(static_cast<std::size_t>(columns), Column{});
  next_ = 0;
  misfit_ = kUsualMisfit;
  misfit_age_ = 0.0;
  summarize();
}

void Separability::note_misfit(double difference, double step) {
  constexpr double kMemory = 20.0;  // s
  if (step <= 0.0) return;
  misfit_age_ = std::min(misfit_age_ + step, kMemory);
  misfit_ += (difference - misfit_) * std::min(step / misfit_age_, 1.0);
}

void Separability::observe(const ComparedModel& model, const Wall& wall) {
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

/// The ratio s of the class comment.
double Separability::ratio(const Column& sums) const {
  if (sums.tiles == 0) return kExpected;
  const auto beyond = [&](double sum) { return std::max(sum / sums.tiles - kMisfitFraction * misfit_, 0.0); };
  return (beyond(sums.half) + kExpected * kLeast) / (beyond(sums.eighths) + kLeast);
}

void Separability::summarize() {
  constexpr double kOfATile = 0.08;      // variance with one known tile
  constexpr double kOfExperience = 0.3;  // standard deviation without data
  constexpr double kLimit = 0.6;
  constexpr double kLogistic = 1.7;  // the normal distribution is close to the logistic distribution with this slope
  Column all;
  std::array<Column, kParts> parts;
  const std::size_t half = columns_.size() / 2;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    all += columns_[i];
    // A column and its reflection are compared with each other.
    if (half > 0) parts[std::min(i % half * kParts / half, kParts - 1)] += columns_[i];
  }
  double mean = 0.0, squares = 0.0;
  int count = 0;
  for (const Column& part : parts) {
    if (part.tiles == 0 || part.tiles == all.tiles) continue;
    Column others = all;
    others.half -= part.half;
    others.eighths -= part.eighths;
    others.tiles -= part.tiles;
    const double without = ratio(others), change = without - mean;
    ++count;
    mean += change / count;
    squares += change * (without - mean);
  }
  constexpr int kFewestParts = 3;
  const double jackknife = count >= kFewestParts ? squares * (count - 1) / count : 1.0;
  const double beyond = all.tiles > 0 ? std::max(all.eighths / all.tiles - kMisfitFraction * misfit_, 0.0) : 0.0;
  const double experience = kOfExperience * kLeast / (beyond + kLeast);
  const double variance = jackknife + kOfATile / std::max(all.tiles, 1) + experience * experience;
  const double deviations =
      all.tiles < kFewestTiles ? (kExpected - kLimit) / kOfExperience : (ratio(all) - kLimit) / std::sqrt(variance);
  probability_ = 1.0 / (1.0 + pinned::exp(-kLogistic * deviations));
}

void Separability::rotate_by_180_degrees() {
  // Each column and its reflection are compared with all others, so only their sums are exchanged.
  std::rotate(columns_.begin(), columns_.begin() + static_cast<std::ptrdiff_t>(columns_.size() / 2), columns_.end());
  const int columns = static_cast<int>(columns_.size());
  if (columns > 0) next_ = (next_ + columns / 2) % columns;
}

/// Checks values after reading.
void Separability::check(std::size_t columns) const {
  check_bytes(columns_.size() == columns && next_ >= 0 && next_ < static_cast<int>(columns),
              "separability: expected one entry for each column of the wall");
  check_bytes(probability_ >= 0.0 && probability_ <= 1.0, "separability: the probability is outside of 0 to 1");
  check_bytes(misfit_ >= 0.0 && misfit_ <= 1.0 && misfit_age_ >= 0.0 && std::isfinite(misfit_age_),
              "separability: the misfit is invalid");
  for (const Column& column : columns_)
    check_bytes(column.half >= 0.0 && std::isfinite(column.half) && column.eighths >= 0.0 &&
                    std::isfinite(column.eighths) && column.tiles >= 0 && column.tiles <= kMostRows,
                "separability: a column has an invalid value");
}

}  // namespace reorient
