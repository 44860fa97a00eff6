// SPDX-License-Identifier: MIT
#include "program/room/rating_text.h"

#include <cmath>
#include <ostream>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "geometry/angle.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

constexpr int kShownDirections = 3;

std::string bearing(double azimuth) {
  return fmt::format("{:+5.0f} degrees, {}", to_degrees(azimuth), direction_in_words(azimuth));
}

std::string times_in_words(const CorrectionTimes& times) {
  if (!times.mean) return fmt::format("none of {} robots is right within {:g} s", times.trials, times.limit);
  std::string words = fmt::format("mean {:.1f} s, ", *times.mean);
  words += times.within_90 ? fmt::format("90 % within {:.1f} s", *times.within_90)
                           : fmt::format("more than 10 % not within {:g} s", times.limit);
  return words + fmt::format(" ({} of {} robots within {:g} s)", times.corrected, times.trials, times.limit);
}

void print_directions(const char* title, const std::vector<DirectionRating>& directions, std::ostream& out) {
  out << "  " << title << ":\n";
  for (const DirectionRating& one : directions) {
    out << fmt::format("    {}: {:.1f}{}\n", bearing(one.azimuth), one.log_odds,
                       one.known < 0.5 ? fmt::format(" ({:.0f} % of it is learned)", 100.0 * one.known) : "");
  }
}

std::string false_flips_in_words(const FalseFlips& flips) {
  return fmt::format(
      "{} ({} of {} robots with a right belief flipped it within {:g} s; their greatest evidence against "
      "it was {:.1f} +- {:.1f})",
      flips.per_hour ? fmt::format("{:.2f} per hour", *flips.per_hour) : std::string("unknown"), flips.flips,
      flips.trials, flips.seconds, flips.mean_evidence, flips.evidence_deviation);
}

std::string banner_in_words(const BannerRating& rating) {
  const Banner& banner = rating.banner;
  const std::string what =
      fmt::format("a {} banner of {:g} m by {:g} m", color_in_words(banner.color), banner.width, banner.height);
  if (!rating.with) return "no position found at which " + what + " would save 2 % of the time";
  if (rating.without.trials == 0)
    return fmt::format("{} at {} would let the room be used: {}", what, bearing(banner.azimuth),
                       times_in_words(*rating.with));
  const double before = rating.without.mean_up_to_limit, after = rating.with->mean_up_to_limit;
  return fmt::format("{} at {} would change the mean time from {:.1f} to {:.1f} s ({:+.0f} %)", what,
                     bearing(banner.azimuth), before, after, 100.0 * (after - before) / before);
}

ordered_json rounded(double value, int digits = 4) {
  const double units = std::pow(10.0, digits);
  return std::isfinite(value) ? ordered_json(std::round(value * units) / units) : ordered_json();
}
ordered_json rounded_or_null(const std::optional<double>& value) { return value ? rounded(*value) : ordered_json(); }

ordered_json rating_part(const CorrectionTimes& times) {
  return {{"trials", times.trials},
          {"evaluated", times.evaluated},
          {"corrected", times.corrected},
          {"limit_s", times.limit},
          {"mean_s", rounded_or_null(times.mean)},
          {"p90_s", rounded_or_null(times.within_90)},
          {"mean_up_to_limit_s", rounded(times.mean_up_to_limit)}};
}

ordered_json rating_part(const FalseFlips& flips) {
  return {{"per_hour", flips.per_hour ? rounded(*flips.per_hour, 6) : ordered_json()},
          {"trials", flips.trials},
          {"flips", flips.flips},
          {"seconds", flips.seconds},
          {"mean_evidence", rounded(flips.mean_evidence)},
          {"evidence_deviation", rounded(flips.evidence_deviation)}};
}

ordered_json rating_part(const DirectionRating& one) {
  return {{"azimuth_degrees", rounded(to_degrees(one.azimuth), 2)},
          {"log_odds", rounded(one.log_odds)},
          {"deviation", rounded(one.deviation)},
          {"known", rounded(one.known)},
          {"words", direction_in_words(one.azimuth)}};
}

ordered_json rating_part(const BannerRating& rating) {
  ordered_json places = ordered_json::array();
  for (const BannerTry& one : rating.places) {
    places.push_back({{"azimuth_degrees", rounded(to_degrees(one.azimuth), 2)},
                      {"usable", one.is_usable},
                      {"times", one.is_usable ? rating_part(one.times) : ordered_json()}});
  }
  const bool any = rating.with.has_value();
  return {{"width_m", rating.banner.width},
          {"height_m", rating.banner.height},
          {"foot_m", rating.banner.foot},
          {"color_bin", rating.banner.color},
          {"color", color_in_words(rating.banner.color)},
          {"best_azimuth_degrees", any ? rounded(to_degrees(rating.banner.azimuth), 2) : ordered_json()},
          {"without", rating.without.trials > 0 ? rating_part(rating.without) : ordered_json()},
          {"with", any ? rating_part(*rating.with) : ordered_json()},
          {"places", std::move(places)}};
}

}  // namespace

std::string verdict_in_words(const RoomRating& rating) {
  switch (rating.verdict) {
    case RoomVerdict::works:
      return "works";
    case RoomVerdict::unlearned:
      return fmt::format(
          "does not work: too little was learned, {:.0f} % of the wall (expected at least {:.0f} %){}",
          100.0 * rating.coverage, 100.0 * rating.least_coverage,
          rating.coverage < rating.least_coverage ? "" : " and background_training would continue to learn");
    case RoomVerdict::symmetric:
      return fmt::format(
          "does not work: the room looks the same rotated by 180 degrees, separability {:.2f} (at least {:.2f} is "
          "needed), distinctiveness {:.2f} (at least {:.2f})",
          rating.separability, rating.least_separability, rating.distinctiveness, rating.least_distinctiveness);
    case RoomVerdict::weak:
      break;
  }
  return "does not work: the evidence is too weak for most robots";
}

void print_rating(const LearnedRoom& room, const RoomRating& rating, std::ostream& out) {
  out << room.from << '\n'
      << "verdict: " << verdict_in_words(rating) << '\n'
      << fmt::format("  coverage {:.2f}, distinctiveness {:.2f}, separability {:.2f}; learned for {:.1f} s\n",
                     rating.coverage, rating.distinctiveness, rating.separability, room.model.learned);
  if (rating.times) {
    out << "time to correction of a mirrored belief: " << times_in_words(*rating.times) << '\n'
        << fmt::format(
               "  measured from the start of placing the robot, 0.9 s before it stands on average; misfit of "
               "observations "
               "{:g}\n",
               rating.misfit);
  }
  if (rating.false_flips) {
    out << "false flips: " << false_flips_in_words(*rating.false_flips) << '\n'
        << "  computed from observations that differ from the model at random, without other light, people and wrong "
           "lines\n";
  }
  out << "where the evidence comes from, in log-odds of an observation of 1 s of one column of the wall (of "
      << rating.directions.size() << "):\n";
  print_directions("best", best_directions(rating.directions, kShownDirections), out);
  print_directions("worst", worst_directions(rating.directions, kShownDirections), out);
  out << "what would help: ";
  if (rating.verdict == RoomVerdict::unlearned) {
    out << "let the robot learn more of the room first, from several places\n";
  } else {
    out << (rating.banner ? banner_in_words(*rating.banner) : "no banner was evaluated") << '\n';
  }
}

std::string rating_as_json(const LearnedRoom& room, const RoomRating& rating) {
  ordered_json directions = ordered_json::array();
  for (const DirectionRating& one : rating.directions) directions.push_back(rating_part(one));
  const ordered_json json{{"room", as_utf8(room.from)},
                          {"verdict", to_string(rating.verdict)},
                          {"works", rating.verdict == RoomVerdict::works},
                          {"reason", verdict_in_words(rating)},
                          {"learned_s", rounded(room.model.learned, 3)},
                          {"misfit", rating.misfit},
                          {"coverage", rounded(rating.coverage)},
                          {"distinctiveness", rounded(rating.distinctiveness)},
                          {"separability", rounded(rating.separability)},
                          {"times", rating.times ? rating_part(*rating.times) : ordered_json()},
                          {"false_flips", rating.false_flips ? rating_part(*rating.false_flips) : ordered_json()},
                          {"directions", std::move(directions)},
                          {"banner", rating.banner ? rating_part(*rating.banner) : ordered_json()}};
  return json.dump(2) + "\n";
}

}  // namespace reorient
