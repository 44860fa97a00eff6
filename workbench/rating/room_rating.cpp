// SPDX-License-Identifier: MIT
#include "workbench/rating/room_rating.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr int kPlacesOfBanners = 24;
constexpr double kLeastGain = 0.02;  // of the mean time: a smaller gain may be random
constexpr int kDirectionDraws = 16;  // of observations, for the directions

/// One robot of the rating, with the same values for each model.
struct Placement {
  VisibleTiles visible;
  double head_yaw = 0.0;  // rad
  double lowering = 0.0;  // s
  std::uint64_t seed = 0;
};

Pose2 random_pose(const FieldDimensions& field, const Wall& wall, Random& random) {
  constexpr double kInside = 0.8;  // of the wall's radius
  const double x = random.uniform(-0.5, 0.5) * field.length;
  const double y = random.uniform(-0.5, 0.5) * field.width;
  const double rotation = random.uniform(-kPi, kPi);
  const double most = kInside * wall.radius();
  const double distance = pinned::hypot(x, y);
  const double scale = distance > most ? most / distance : 1.0;
  return {scale * x, scale * y, rotation};
}

std::vector<Placement> placements(const RatedRobot& robot, const Wall& wall, const CoreParameters& core,
                                  const RatingOptions& options) {
  constexpr double kWidestScan = 1.1;                           // rad
  constexpr double kLeastLowering = 0.42, kMostLowering = 0.9;  // s, as in the simulator
  std::vector<Placement> all;
  for (int trial = 0; trial < options.trials; ++trial) {
    Random random(options.seed, static_cast<std::uint64_t>(trial));
    const Pose2 belief = random_pose(robot.field, wall, random);
    const double yaw = random.uniform(-kWidestScan, kWidestScan);
    const double lowering = random.uniform(kLeastLowering, kMostLowering);
    all.push_back({VisibleTiles(robot.body, wall, core.room.perception, belief), yaw, lowering, random()});
  }
  return all;
}

/// The values that are the same for all models.
struct Rating {
  const RatedRobot& robot;
  const RatingOptions& options;
  const std::function<bool()>& stop;
  CoreParameters core;
  double scale = 0.0;  // of the observations
  std::vector<Placement> placements;

  bool is_stopped() const { return stop && stop(); }

  PutDownResult play(const PutDown& how, const RatedModel& model, Placement& place) const {
    const Looks looks =
        draw_looks(model.learned, model.wall, model.comparison.trusted_after, scale, Random(place.seed));
    PutDown placed = how;
    placed.head_yaw = place.head_yaw;
    placed.lowering = place.lowering;
    return put_down(placed, robot, model, looks, place.visible);
  }
};

CorrectionTimes correction_times(Rating& rating, const RatedModel& model, std::size_t trials) {
  PutDown how;
  CorrectionTimes times;
  times.limit = how.limit;
  std::vector<double> corrected;
  for (std::size_t i = 0; i < trials && !rating.is_stopped(); ++i) {
    const PutDownResult result = rating.play(how, model, rating.placements[i]);
    ++times.trials;
    times.evaluated += result.has_evaluated ? 1 : 0;
    if (result.flipped_after) corrected.push_back(*result.flipped_after);
  }
  if (times.trials == 0) return times;
  times.corrected = static_cast<int>(corrected.size());
  double sum = 0.0;
  for (const double seconds : corrected) sum += seconds;
  if (!corrected.empty()) times.mean = sum / times.corrected;
  times.mean_up_to_limit = (sum + how.limit * (times.trials - times.corrected)) / times.trials;
  std::sort(corrected.begin(), corrected.end());
  const auto rank = static_cast<std::size_t>(std::ceil(0.9 * times.trials));  // starts at 1
  if (rank <= corrected.size()) times.within_90 = corrected[rank - 1];
  return times;
}

/// Probability that a normal number is greater than this many standard deviations, with a relative error of 0.3 %
/// (Borjesson and Sundberg 1979).
double upper_tail(double deviations) {
  if (deviations < 0.0) return 1.0 - upper_tail(-deviations);
  constexpr double kA = 1.0 / kPi, kB = 2.0 * kPi;
  const double square = deviations * deviations;
  const double density = pinned::exp(-0.5 * square) / std::sqrt(2.0 * kPi);
  return density / ((1.0 - kA) * deviations + kA * std::sqrt(square + kB));
}

FalseFlips false_flips(Rating& rating, const RatedModel& model) {
  FalseFlips found;
  PutDown how;
  how.is_mirrored = false;
  how.limit = found.seconds;
  double sum = 0.0, squares = 0.0;
  for (Placement& place : rating.placements) {
    if (rating.is_stopped()) break;
    const PutDownResult result = rating.play(how, model, place);
    ++found.trials;
    found.flips += result.flipped_after ? 1 : 0;
    sum += result.most_evidence;
    squares += result.most_evidence * result.most_evidence;
  }
  if (found.trials == 0) return found;
  found.mean_evidence = sum / found.trials;
  found.evidence_deviation =
      std::sqrt(std::max(squares / found.trials - found.mean_evidence * found.mean_evidence, 0.0));
  const std::optional<DecisionLimits> limits = decision_limits_of(rating.robot);
  if (!limits) return found;
  const auto probability = [&](double limit) {
    constexpr double kLeastDeviation = 1e-6;
    return upper_tail((limit - found.mean_evidence) / std::max(found.evidence_deviation, kLeastDeviation));
  };
  // Observed flips count as well, in case the tail of the normal distribution underestimates them.
  const double unconfirmed =
      std::max(probability(limits->unconfirmed), static_cast<double>(found.flips) / found.trials);
  found.per_hour = limits->disturbances * unconfirmed + limits->looks * probability(limits->confirmed);
  return found;
}

RoomVerdict verdict_of(RoomStatus status, const std::optional<CorrectionTimes>& times) {
  if (status == RoomStatus::unlearned || (times && times->evaluated == 0)) return RoomVerdict::unlearned;
  if (status == RoomStatus::symmetric) return RoomVerdict::symmetric;
  const bool is_weak = !times || 2 * times->corrected < times->trials;
  return is_weak ? RoomVerdict::weak : RoomVerdict::works;
}

BannerRating rate_banners(Rating& rating, const SavedModel& model, const RatedModel& rated) {
  const std::size_t trials = std::max<std::size_t>(1, rating.placements.size() / 4);
  BannerRating result;
  result.banner.width = rating.options.banner_width;
  result.banner.color = rarest_color(model.model);
  const bool is_usable = rated.status(rating.core.room_status) == RoomStatus::usable;
  result.without = is_usable ? correction_times(rating, rated, trials) : CorrectionTimes();
  double least =
      is_usable ? (1.0 - kLeastGain) * result.without.mean_up_to_limit : std::numeric_limits<double>::infinity();
  for (int i = 0; i < kPlacesOfBanners && !rating.is_stopped(); ++i) {
    Banner banner = result.banner;
    banner.azimuth = normalize_angle(2.0 * kPi * i / kPlacesOfBanners);
    const RatedModel changed(with_banner(model, banner), rating.core);
    BannerTry one{banner.azimuth, changed.status(rating.core.room_status) == RoomStatus::usable, {}};
    if (one.is_usable) one.times = correction_times(rating, changed, trials);
    if (one.is_usable && one.times.mean_up_to_limit < least) {
      least = one.times.mean_up_to_limit;
      result.banner.azimuth = banner.azimuth;
      result.with = one.times;
    }
    result.places.push_back(one);
  }
  return result;
}

}  // namespace

std::string_view to_string(RoomVerdict verdict) {
  switch (verdict) {
    case RoomVerdict::works:
      return "works";
    case RoomVerdict::unlearned:
      return "unlearned";
    case RoomVerdict::symmetric:
      return "symmetric";
    case RoomVerdict::weak:
      break;
  }
  return "weak";
}

RoomRating rate_room(const SavedModel& model, const RatedRobot& robot, const RatingOptions& options,
                     const std::function<bool()>& stop) {
  Rating rating{robot, options, stop, core_parameters_of(robot), 0.0, {}};
  const RatedModel rated(model, rating.core);
  rating.scale = scale_for_misfit(rated.learned, rated.wall, rated.comparison.trusted_after, options.misfit);
  rating.placements = placements(robot, rated.wall, rating.core, options);
  const RoomStatusParameters& least = rating.core.room_status;
  const RoomStatus status = rated.status(least);
  RoomRating result;
  result.coverage = rated.compared.coverage();
  result.least_coverage = least.coverage;
  result.distinctiveness = rated.compared.distinctiveness();
  result.least_distinctiveness = least.distinctiveness;
  result.separability = rated.separability;
  result.least_separability = least.separability;
  result.misfit = options.misfit;
  result.directions = rate_directions(rated, rating.core.room, rating.scale, kDirectionDraws, options.seed);
  if (status == RoomStatus::usable) {
    result.times = correction_times(rating, rated, rating.placements.size());
    result.false_flips = false_flips(rating, rated);
  }
  result.verdict = verdict_of(status, result.times);
  // In a room that is hardly known, a banner would dominate the known part and the rating.
  if (options.banner_width > 0.0 && result.verdict != RoomVerdict::unlearned)
    result.banner = rate_banners(rating, model, rated);
  return result;
}

}  // namespace reorient
