// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/rating_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <utility>

#include "geometry/angle.h"
#include "workbench/views/pictures/parts/field_drawing.h"
#include "workbench/views/pictures/parts/legend.h"

namespace reorient::pictures {
namespace {

// Radii in pixels, from the inside out.
constexpr double kRatedField = 190.0;
constexpr double kKnownInner = 200.0;
constexpr double kKnownOuter = 214.0;
constexpr double kBarFoot = 250.0;  // base of the bars
constexpr double kLongestBar = 130.0;
constexpr double kBannerInner = 386.0;
constexpr double kBannerOuter = 402.0;
constexpr double kNameRadius = 424.0;

bool can_be_drawn(const RatedSector& sector) {
  const double width = sector.to - sector.from;
  return width > 0.0 && width <= 2.0 * kPi && std::abs(sector.from) < 1e3 && std::isfinite(sector.log_odds) &&
         sector.known >= 0.0 && sector.known <= 1.0;
}

Pixel ring_point(const Pixel& center, double radius, double azimuth) {
  return center + radius * Pixel(std::cos(azimuth), -std::sin(azimuth));
}

/// The full scale: 1, 2 or 5 times a power of ten, at least the largest value of the sectors.
double full_scale(const RatingView& rating) {
  double most = 0.1;
  for (const RatedSector& sector : rating.sectors)
    if (can_be_drawn(sector)) most = std::max(most, std::abs(sector.log_odds));
  const double power = std::pow(10.0, std::floor(std::log10(most)));
  for (const double step : {1.0, 2.0, 5.0})
    if (step * power >= most) return step * power;
  return 10.0 * power;
}

void draw_rated_scale(Canvas& canvas, const Pixel& center) {
  for (const double part : {0.5, 1.0}) {
    canvas.ring(center, kBarFoot + part * kLongestBar, palette::grid, 1.5);
  }
}

void draw_rated_sectors(Canvas& canvas, const Pixel& center, const RatingView& rating, double full) {
  for (const RatedSector& sector : rating.sectors) {
    if (!can_be_drawn(sector)) continue;
    const double seam = 0.08 * (sector.to - sector.from);
    const double from = sector.from + seam, to = sector.to - seam;
    canvas.fill(ring_sector(center, kKnownInner, kKnownOuter, from, to), palette::empty_plate);
    if (sector.known > 0.0)
      canvas.fill(ring_sector(center, kKnownInner, kKnownInner + sector.known * (kKnownOuter - kKnownInner), from, to),
                  palette::cluster);
    const double height = kLongestBar * std::clamp(sector.log_odds / full, -0.25, 1.0);
    if (height > 0.5) canvas.fill(ring_sector(center, kBarFoot, kBarFoot + height, from, to), palette::belief);
    if (height < -0.5) canvas.fill(ring_sector(center, kBarFoot + height, kBarFoot, from, to), palette::opposite);
  }
  canvas.ring(center, kBarFoot, palette::faint_ink, 1.5);
}

void draw_scale_labels(Canvas& canvas, const Pixel& center, double full) {
  for (const double part : {0.5, 1.0}) {
    char words[32];
    std::snprintf(words, sizeof words, "%g", part * full);
    canvas.text(ring_point(center, kBarFoot + part * kLongestBar + 2.0, from_degrees(-22.5)), words,
                {.size = 17.0, .bold = true, .halo = palette::page});
  }
}

void draw_direction_names(Canvas& canvas, const Pixel& center) {
  constexpr std::array<std::pair<double, const char*>, 4> kNames{
      {{0.0, "opponent goal"}, {90.0, "left touch line"}, {180.0, "own goal"}, {-90.0, "right touch line"}}};
  for (const auto& [degrees, name] : kNames) {
    const Align align = degrees == 0.0 ? Align::left : degrees == 180.0 ? Align::right : Align::center;
    const double below = degrees == -90.0 ? 14.0 : 6.0;
    canvas.text(ring_point(center, kNameRadius, from_degrees(degrees)) + Pixel(0.0, below), name,
                {.size = 19.0, .align = align});
  }
}

}  // namespace

Picture draw_rating(const RatingView& rating) {
  Canvas canvas(kRatingWidth, kRatingHeight);
  const Pixel center(kRatingWidth / 2.0, kRatingHeight / 2.0 + 30.0);
  const double half_diagonal = carpet_half_size(rating.field).norm();
  const double scale = kRatedField / half_diagonal;
  const double full = full_scale(rating);
  draw_field(canvas, {center, std::isfinite(scale) && scale > 0.0 ? scale : 1.0}, rating.field);
  draw_rated_scale(canvas, center);
  draw_rated_sectors(canvas, center, rating, full);
  draw_scale_labels(canvas, center, full);
  if (rating.banner) {
    const double from = rating.banner->azimuth - rating.banner->half_width;
    const double to = rating.banner->azimuth + rating.banner->half_width;
    canvas.fill(ring_sector(center, kBannerInner, kBannerOuter, from, to), palette::truth);
  }
  draw_direction_names(canvas, center);
  const TextStyle bold{.size = 28.0, .bold = true};
  canvas.text({30.0, 52.0}, shortened(rating.title, kRatingWidth - 60.0, bold), bold);
  const TextStyle plain{.size = 19.0, .color = palette::faint_ink};
  double line = 84.0;
  for (const std::string& note : rating.notes) {
    canvas.text({30.0, line}, shortened(note, kRatingWidth - 60.0, plain), plain);
    line += 26.0;
  }
  std::vector<LegendEntry> entries{patch_entry(palette::belief, "evidence for the right pose, log-odds"),
                                   patch_entry(palette::opposite, "against the right pose"),
                                   patch_entry(palette::cluster, "learned")};
  if (rating.banner) entries.push_back(patch_entry(palette::truth, "best banner"));
  draw_legend_column(canvas, {30.0, kRatingHeight - 24.0 - 30.0 * static_cast<double>(entries.size())}, entries);
  return canvas.finish();
}

}  // namespace reorient::pictures
