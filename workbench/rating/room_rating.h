// SPDX-License-Identifier: MIT
// Rates a model of a room: whether and how soon a mirrored belief of a placed robot is corrected, which directions
// contribute, and what would improve it.
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
  int trials = 96;  ///< robots that are placed with a mirrored belief, and as many with a right one
  double misfit =
      0.35;  ///< mean difference between an observation and the model (Hellinger distance); default: hard light
  double banner_width = 2.0;  ///< m; 0: no banner is evaluated
  std::uint64_t seed = 1;
};

/// Whether the room distinguishes a pose from the mirrored pose.
enum class RoomVerdict {
  works,      ///< it distinguishes them
  unlearned,  ///< too little of the wall is learned, or too short a time
  symmetric,  ///< it looks the same after a rotation by 180 degrees
  weak        ///< more than half of the robots are not corrected within the limit
};
/// "works", "unlearned", "symmetric", "weak".
std::string_view to_string(RoomVerdict verdict);

/// Results of robots with a mirrored belief.
struct CorrectionTimes {
  int trials = 0;
  int evaluated = 0;  ///< robots whose behaviors permitted the evaluation, because the room is learned
  int corrected = 0;  ///< within the limit
  double limit = 30.0;
  std::optional<double> mean;       ///< s, of those that were corrected
  std::optional<double> within_90;  ///< s, by which 90 % of all were corrected; empty: more than 10 % were not
  double mean_up_to_limit = 0.0;    ///< s; robots that were not corrected count with the limit
};

/// Results of robots with a right belief.
struct FalseFlips {
  int trials = 0;
  int flips = 0;               ///< of the trials
  double seconds = 5.0;        ///< duration of each trial
  double mean_evidence = 0.0;  ///< mean over trials of the largest log-odds against the right pose
  double evidence_deviation = 0.0;
  std::optional<double> per_hour;  ///< empty: the scripts have no known limits
};

struct BannerTry {
  double azimuth = 0.0;    ///< rad
  bool is_usable = false;  ///< the room distinguishes the poses with it
  CorrectionTimes times;   ///< if it is usable
};

struct BannerRating {
  Banner banner;                        ///< at the best position
  std::vector<BannerTry> places;        ///< all evaluated positions, from azimuth 0 to the left
  CorrectionTimes without;              ///< of the same robots
  std::optional<CorrectionTimes> with;  ///< at the best position; empty: no position makes the room usable or saves 2 %
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
/// around without walking. `stop` is called between trials; if it returns true, the rating is incomplete. Throws as
/// put_down() does.
RoomRating rate_room(const SavedModel& model, const RatedRobot& robot, const RatingOptions& options,
                     const std::function<bool()>& stop = {});

}  // namespace reorient
