// SPDX-License-Identifier: MIT
#include "perception/room/evidence/evidence.h"

#include <algorithm>
#include <cmath>

#include "geometry/bytes.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

/// The weight w of the class comment.
double weight_of(int tile, const ComparedModel& model, const EvidenceParameters& parameters) {
  const std::optional<double> difference = model.difference_to_reflection(tile);
  if (!difference) return 1.0;
  const auto fraction = [](double amount, double half) { return amount > 0.0 ? amount / (amount + half) : 0.0; };
  return fraction(*difference * *difference, parameters.distinct * parameters.distinct) *
         fraction(model.trained(tile), parameters.half_trained) *
         fraction(model.reflection_trained(tile), parameters.half_trained);
}

}  // namespace

int tolerated_columns(const EvidenceParameters& parameters, const Wall& wall) {
  return static_cast<int>(std::lround(parameters.tolerance / wall.column_width()));
}

void Evidence::restart(int tiles) {
  tiles_.assign(static_cast<std::size_t>(tiles), SeenTile{});
  log_odds_ = 0.0;
}

void Evidence::observe(std::span<const ComparedPlace> places, const ComparedModel& model, double step,
                       const EvidenceParameters& parameters) {
  if (places.empty() || step <= 0.0) return;
  const double kept = pinned::exp(-step / parameters.leak);
  for (SeenTile& tile : tiles_) tile.time *= kept;
  const double between = 0.5 * (parameters.right + model.distinctiveness());
  const bool is_distinctive = model.distinctiveness() > parameters.right;
  for (const ComparedPlace& place : places) {
    const bool both = place.believed_known && place.reflected_known;
    if (!both && !is_distinctive) continue;
    // If only one of the two is known, its distance is compared with a value between those of a correct and of a wrong
    // tile.
    double score = both                   ? place.as_believed - place.as_reflected
                   : place.believed_known ? parameters.unknown * (place.as_believed - between)
                                          : parameters.unknown * (between - place.as_reflected);
    score = std::clamp(score, -parameters.cap, parameters.cap);
    SeenTile& seen = tiles_[static_cast<std::size_t>(place.tile)];
    seen.score += (score - seen.score) * step / (seen.time + step);
    seen.time = std::min(seen.time + step, parameters.settle);
  }
  double sum = 0.0;
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (tiles_[i].time > 0.0) sum += score_of(i, model, parameters);
  }
  log_odds_ = parameters.gain * sum;
}

/// The contribution of a tile that was in view, divided by the gain.
double Evidence::score_of(std::size_t tile, const ComparedModel& model, const EvidenceParameters& parameters) const {
  const SeenTile& seen = tiles_[tile];
  return weight_of(static_cast<int>(tile), model, parameters) * seen.score * seen.time / (seen.time + parameters.look);
}

void Evidence::contributions(const ComparedModel& model, const EvidenceParameters& parameters,
                             std::vector<double>& log_odds) const {
  log_odds.assign(tiles_.size(), 0.0);
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (tiles_[i].time > 0.0) log_odds[i] = parameters.gain * score_of(i, model, parameters);
  }
}

void Evidence::reflect(const Wall& wall) {
  rotate_by_180_degrees(wall);
  for (SeenTile& tile : tiles_) tile.score = -tile.score;
  log_odds_ = -log_odds_;
}

/// Checks values after reading.
void Evidence::check(std::size_t tiles) const {
  check_bytes(tiles_.size() == tiles, "evidence: expected one entry for each tile of the wall");
  check_bytes(std::isfinite(log_odds_), "evidence: the log-odds are not finite");
  for (const SeenTile& tile : tiles_)
    check_bytes(std::isfinite(tile.score) && tile.time >= 0.0 && std::isfinite(tile.time),
                "evidence: a tile has an invalid value");
}

}  // namespace reorient
