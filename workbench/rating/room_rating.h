// SPDX-License-Identifier: MIT
// Rates a model of a room: is a mirrored belief of a placed robot corrected, how soon, by looks in which directions,
// and what would improve it?
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "perception/room/saved_model.h"
#include "workbench/rating/banner.h"
#include "workbench/rating/directions.h"
#include "workbench/rating/put_down.h"

namespace reorient {

struct RatingOptions {
  int trials = 96;            ///< robots that are placed with a mirrored belief, and as many with a right one
  double misfit = 0.35;       ///< mean difference between a look and the model (Hellinger distance): hard light
  double banner_width = 2.0;  ///< m; 0: no banner is tried
  std::uint64_t seed = 1;
};

/// Whether the room distinguishes a pose from the mirrored pose.
enum class RoomVerdict {
  works,      ///< it does
  unlearned,  ///< too little of the wall is learned, or too short a time
  symmetric,  ///< it looks the same after a rotation by 180 degrees
  weak        ///< more than half of the robots are not corrected within the limit
};
/// "works", "unlearned", "symmetric", "weak".
std::string_view to_string(RoomVerdict verdict);

/// Of robots with a mirrored belief.
struct CorrectionTimes {
  int trials = 0;
  int evaluated = 0;  ///< whose behaviors permitted the evaluation, because the room is learned
  int corrected = 0;  ///< within the limit
  double limit = 30.0;
  std::optional<double> mean;       ///< s, of those that were corrected
  std::optional<double> within_90;  ///< s, by which 90 % of all were corrected; empty: more than 10 % were not
  double mean_up_to_limit = 0.0;    ///< s, where the others count with the limit
};

/// Of robots with a right belief.
struct FalseFlips {
  int trials = 0;
  int flips = 0;               ///< of the trials
  double seconds = 5.0;        ///< for which each was watched
  double mean_evidence = 0.0;  ///< log-odds against the right pose, the greatest of each trial: mean
  double evidence_deviation = 0.0;
  std::optional<double> per_hour;  ///< empty: the scripts have no limits that are known
};

struct BannerTry {
  double azimuth = 0.0;    ///< rad
  bool is_usable = false;  ///< the room distinguishes the poses with it
  CorrectionTimes times;   ///< where it is usable
};

struct BannerRating {
  Banner banner;                        ///< at the best place
  std::vector<BannerTry> places;        ///< all that were tried, from azimuth 0 to the left
  CorrectionTimes without;              ///< of the same robots
  std::optional<CorrectionTimes> with;  ///< at the best place; empty: no place makes the room usable, or saves 2 %
};

struct RoomRating {
  RoomVerdict verdict = RoomVerdict::unlearned;
  double coverage = 0.0, least_coverage = 0.0;
  double distinctiveness = 0.0, least_distinctiveness = 0.0;
  double separability = 0.0, least_separability = 0.0;
  double misfit = 0.0;
  std::optional<CorrectionTimes> times;  ///< empty: unlearned, or symmetric
  std::optional<FalseFlips> false_flips;
  std::vector<DirectionRating> directions;
  std::optional<BannerRating> banner;
};

/// Robots stand anywhere within the field's lines, as far as these are inside of the wall, in any direction, and look
/// around without walking. `stop` is asked between trials; then the rating is not complete. Throws as put_down() does.
RoomRating rate_room(const SavedModel& model, const RatedRobot& robot, const RatingOptions& options,
                     const std::function<bool()>& stop = {});

}  // namespace reorient
