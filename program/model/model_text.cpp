// SPDX-License-Identifier: MIT
#include "program/model/model_text.h"

#include <algorithm>
#include <ostream>
#include <string>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/world/room_status.h"
#include "geometry/angle.h"
#include "perception/room/compared_model.h"
#include "perception/room/separability.h"

namespace reorient {
namespace {

std::string known_by_row(const SavedModel& model, const Wall& wall) {
  std::string rows;
  for (int row = wall.rows() - 1; row >= 0; --row) {
    int known = 0;
    for (int column = 0; column < wall.columns(); ++column)
      known += model.model[wall.tile(row, column)].visits > 0 ? 1 : 0;
    rows += fmt::format(" {}", known);
  }
  return rows;
}

/// The position of a tile: degrees to the left of the +x axis, heights in m.
std::string place_of(int tile, const Wall& wall) {
  const double azimuth = normalize_angle((wall.column_of(tile) + 0.5) * wall.column_width());
  const double foot = wall.bottom() + wall.row_of(tile) * wall.row_height();
  return fmt::format("{:+5.0f} degrees, {:4.1f} to {:4.1f} m", to_degrees(azimuth), foot, foot + wall.row_height());
}

/// Compares all columns at once; RoomAwareness compares one a frame.
double separability_of(const ComparedModel& model, const Wall& wall) {
  Separability separability;
  separability.restart(wall.columns());
  for (int column = 0; column < wall.columns(); ++column) separability.observe(model, wall);
  return separability.probability();
}

std::string bias_in_words(const std::optional<KnownBias>& known) {
  if (!known) return "not known";
  const auto [roll, pitch] = bias_ahead(known->bias);
  return fmt::format("straight ahead it looks {:+.1f} degrees lower and is rolled by {:+.1f} degrees, to {:.1f}",
                     to_degrees(pitch), to_degrees(roll), to_degrees(known->bias.deviation));
}

}  // namespace

void print_model(const SavedModel& model, std::ostream& out) {
  const Wall wall(model.basis.wall);
  const std::string different = differences({}, model.basis);
  ComparedModel compared;
  compared.prepare(model.model, wall, Comparison());
  const double separability = separability_of(compared, wall);
  const RoomStatusParameters least;
  out << fmt::format("  learned for {:.1f} s\n", model.learned)
      << fmt::format("  wall: {} m from the field's center, {} to {} m high, {} of {}\n", wall.radius(), wall.bottom(),
                     wall.top(), counted(wall.rows(), "row"), counted(wall.columns(), "column"))
      << "  camera, against what its robot measures: " << bias_in_words(model.camera_bias) << "\n"
      << "  parameters: " << (different.empty() ? "as by default" : different) << "\n"
      << fmt::format("  known: {} of {} tiles; row by row, from the top:{}\n", model.model.known_tiles(), wall.tiles(),
                     known_by_row(model, wall))
      << fmt::format("  coverage: {:.2f} ({})\n", compared.coverage(),
                     compared.coverage() < least.coverage
                         ? "too little for decisions: the robot continues to learn first"
                         : "enough for decisions")
      << fmt::format("  distinctiveness: {:.2f} ({})\n", compared.distinctiveness(),
                     compared.distinctiveness() < least.distinctiveness
                         ? "rotated by 180 degrees it looks the same: no evidence about the pose"
                         : "distinguishable from itself rotated by 180 degrees")
      << fmt::format("  separability: {:.2f} ({})\n", separability,
                     separability < least.separability
                         ? "a rotation by 180 degrees changes it less than other rotations: it counts as symmetric"
                         : "a rotation by 180 degrees changes it like other rotations");
}

void print_comparison(const ModelComparison& comparison, const Wall& wall, std::ostream& out) {
  constexpr std::size_t kShown = 10;
  out << fmt::format("both know {}; only A {}, only B {}\n", counted(comparison.tiles.size(), "tile"),
                     comparison.only_first, comparison.only_second);
  if (!comparison.mean) {
    out << "verdict: nothing can be compared\n";
    return;
  }
  out << fmt::format("mean difference {:.2f} (Hellinger distance of the colors, 0 to 1)\n", *comparison.mean);
  if (comparison.sides) {
    out << fmt::format("over the tiles known on both sides: {:.2f} unrotated, {:.2f} with B rotated by 180 degrees\n",
                       comparison.sides->as_it_is, comparison.sides->turned);
  }
  if (comparison.spread) out << fmt::format("different parts of one room differ by {:.2f}\n", *comparison.spread);
  out << (!comparison.is_of_one_room() ? "verdict: they are not of the same room, or one of them is wrong\n"
          : comparison.is_turned()     ? "verdict: B looks like A rotated by 180 degrees: the teams changed sides\n"
          : comparison.is_same_way()   ? "verdict: the same room, seen from the same end of the field\n"
                                       : "verdict: the same room, but it is not clear from which end of the field\n");
  constexpr double kShownDifference = 0.005;  // not 0.00 when rounded
  std::size_t shown = 0;
  while (shown < std::min(kShown, comparison.tiles.size()) && comparison.tiles[shown].distance >= kShownDifference)
    ++shown;
  if (shown == 0) {
    out << "no tile differs\n";
    return;
  }
  out << "where they differ most, seen from the field's center, to the left of the opponent's goal:\n";
  for (std::size_t i = 0; i < shown; ++i) {
    const TileDifference& tile = comparison.tiles[i];
    out << fmt::format("  {}: {:.2f}\n", place_of(tile.tile, wall), tile.distance);
  }
}

}  // namespace reorient
