// SPDX-License-Identifier: MIT
// The directions of a room: as text, and the evidence of an observation in each of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core_parameters.h"
#include "workbench/rating/put_down.h"

namespace reorient {

/// One column of the wall, seen by a robot that believes the mirrored pose.
struct DirectionRating {
  double azimuth = 0.0;    ///< rad, of the column's middle, seen from the field's center; 0 is the opponent goal
  double log_odds = 0.0;   ///< mean evidence for the right pose after an observation of all rows of this column for 1 s
  double deviation = 0.0;  ///< its standard deviation from robot to robot
  double known = 0.0;      ///< fraction of the column's tiles that are learned
};

/// All columns, in their order, by the real Evidence over `draws` robots whose observations are drawn from the model
/// with this scale. Ignores separability: the evidence of the columns if the room were usable.
std::vector<DirectionRating> rate_directions(const RatedModel& model, const RoomParameters& parameters, double scale,
                                             int draws, std::uint64_t seed);

/// The best or the worst of them, at most `count`, by the mean over a column and its two neighbors; no two within 45
/// degrees of each other. Azimuth and log-odds are those of the middle column and of the mean.
std::vector<DirectionRating> best_directions(const std::vector<DirectionRating>& all, int count);
std::vector<DirectionRating> worst_directions(const std::vector<DirectionRating>& all, int count);

/// "toward the left touch line". In steps of 45 degrees; argument in rad.
std::string direction_in_words(double azimuth);

}  // namespace reorient
