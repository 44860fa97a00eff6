// SPDX-License-Identifier: MIT
// The directions of a room: in words, and how much a look in each of them shows of the pose.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core_parameters.h"
#include "workbench/rating/put_down.h"

namespace reorient {

/// One column of the wall, as a robot sees it that believes the mirrored pose.
struct DirectionRating {
  double azimuth = 0.0;    ///< rad, of the column's middle, seen from the field's center; 0 is the opponent goal
  double log_odds = 0.0;   ///< evidence for the right pose after a look of 1 s at all rows of this column: mean
  double deviation = 0.0;  ///< its standard deviation from robot to robot
  double known = 0.0;      ///< fraction of the column's tiles that are learned
};

/// All columns, in their order, by the real Evidence over `draws` robots whose looks are drawn from the model with this
/// scale. Separability is left out: what the columns would show if the room could be used.
std::vector<DirectionRating> rate_directions(const RatedModel& model, const RoomParameters& parameters, double scale,
                                             int draws, std::uint64_t seed);

/// The best or the worst of them, at most `count`, by the mean over a column and its two neighbors; no two within 45
/// degrees of each other. Azimuth and log-odds are those of the middle column and of the mean.
std::vector<DirectionRating> best_directions(const std::vector<DirectionRating>& all, int count);
std::vector<DirectionRating> worst_directions(const std::vector<DirectionRating>& all, int count);

/// "toward the left touch line". By eighths of a turn. rad.
std::string direction_in_words(double azimuth);

}  // namespace reorient
