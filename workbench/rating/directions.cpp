// SPDX-License-Identifier: MIT
#include "workbench/rating/directions.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "geometry/angle.h"
#include "perception/room/evidence/evidence.h"
#include "perception/room/view/viewpoint_scores.h"

namespace reorient {
namespace {

constexpr double kLookStep = 1.0 / 30.0;  // s
constexpr int kLookFrames = 30;           // an observation of 1 s

/// The column as a mirrored robot sees it: tiles of the other side with observations of the real ones.
std::vector<PerceivedTile> column_as_believed(int column, const Wall& wall, const Looks& looks) {
  std::vector<PerceivedTile> tiles;
  for (int row = 0; row < wall.rows(); ++row) {
    const int real = wall.tile(row, column);
    PerceivedTile& tile = tiles.emplace_back();
    tile.tile = wall.reflected(real);
    tile.counts = true;
    tile.histogram = tile.reflected_histogram = looks[static_cast<std::size_t>(real)];
  }
  return tiles;
}

double evidence_of(int column, const RatedModel& model, const EvidenceParameters& parameters, const Looks& looks) {
  ViewpointScores scores;
  // No tolerance: the tiles of a view shift together, but a single column would choose its own shift.
  scores.compute(column_as_believed(column, model.wall, looks), model.compared, model.wall, model.comparison, 0);
  Evidence evidence;
  evidence.restart(model.wall.tiles());
  for (int frame = 0; frame < kLookFrames; ++frame)
    evidence.observe(scores.places(), model.compared, kLookStep, parameters);
  return evidence.log_odds();
}

double known_part(int column, const RatedModel& model) {
  int known = 0;
  for (int row = 0; row < model.wall.rows(); ++row)
    known += model.compared.trusted(model.wall.tile(row, column)) ? 1 : 0;
  return static_cast<double>(known) / model.wall.rows();
}

/// Smooths: the mean of each column's log-odds and those of its two neighbors.
std::vector<DirectionRating> smoothed(const std::vector<DirectionRating>& all) {
  std::vector<DirectionRating> result = all;
  const std::size_t count = all.size();
  for (std::size_t i = 0; i < count; ++i) {
    const double around = all[(i + count - 1) % count].log_odds + all[(i + 1) % count].log_odds;
    result[i].log_odds = (all[i].log_odds + around) / 3.0;
  }
  return result;
}

/// Takes columns in this order, without those near an earlier one.
std::vector<DirectionRating> apart(const std::vector<DirectionRating>& sorted, int count) {
  const double least = from_degrees(45.0) - 1e-9;
  std::vector<DirectionRating> chosen;
  for (const DirectionRating& one : sorted) {
    if (static_cast<int>(chosen.size()) == count) break;
    const bool is_near = std::any_of(chosen.begin(), chosen.end(), [&](const DirectionRating& other) {
      return std::abs(angle_difference(one.azimuth, other.azimuth)) < least;
    });
    if (!is_near) chosen.push_back(one);
  }
  return chosen;
}

}  // namespace

std::vector<DirectionRating> rate_directions(const RatedModel& model, const RoomParameters& parameters, double scale,
                                             int draws, std::uint64_t seed) {
  constexpr std::uint64_t kStream = 0x6469'7265;
  const int columns = model.wall.columns();
  std::vector<DirectionRating> all(static_cast<std::size_t>(columns));
  std::vector<double> squares(all.size());
  for (int draw = 0; draw < draws; ++draw) {
    const Looks looks = draw_looks(model.learned, model.wall, model.comparison.trusted_after, scale,
                                   Random(seed, kStream + static_cast<std::uint64_t>(draw)));
    for (int column = 0; column < columns; ++column) {
      const auto i = static_cast<std::size_t>(column);
      const double log_odds = evidence_of(column, model, parameters.evidence, looks);
      all[i].log_odds += log_odds / draws;
      squares[i] += log_odds * log_odds / draws;
    }
  }
  for (int column = 0; column < columns; ++column) {
    const auto i = static_cast<std::size_t>(column);
    all[i].azimuth = normalize_angle((column + 0.5) * model.wall.column_width());
    all[i].deviation = std::sqrt(std::max(squares[i] - all[i].log_odds * all[i].log_odds, 0.0));
    all[i].known = known_part(column, model);
  }
  return all;
}

std::vector<DirectionRating> best_directions(const std::vector<DirectionRating>& all, int count) {
  std::vector<DirectionRating> sorted = smoothed(all);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& one, const auto& other) { return one.log_odds > other.log_odds; });
  return apart(sorted, count);
}

std::vector<DirectionRating> worst_directions(const std::vector<DirectionRating>& all, int count) {
  std::vector<DirectionRating> sorted = smoothed(all);
  std::stable_sort(sorted.begin(), sorted.end(),
                   [](const auto& one, const auto& other) { return one.log_odds < other.log_odds; });
  return apart(sorted, count);
}

std::string direction_in_words(double azimuth) {
  constexpr const char* kNames[] = {"toward the opponent goal",    "toward the left corner of the opponent half",
                                    "toward the left touch line",  "toward the left corner of the own half",
                                    "toward the own goal",         "toward the right corner of the own half",
                                    "toward the right touch line", "toward the right corner of the opponent half"};
  const double eighths = normalize_angle(azimuth) / (0.25 * kPi);
  const auto eighth = static_cast<std::size_t>((static_cast<int>(std::lround(eighths)) + 8) % 8);
  return kNames[eighth];
}

}  // namespace reorient
