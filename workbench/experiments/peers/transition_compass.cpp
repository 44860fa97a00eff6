// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/transition_compass.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr int kLeastLines = 20;  // a sector with fewer is not used
constexpr std::size_t kMostColors = 6000;
constexpr int kLineSamples = 16;  // of a scan line

}  // namespace

TransitionCompass::TransitionCompass(const TransitionCompassParameters& parameters, std::uint64_t seed)
    : parameters_(parameters), seed_(seed), wall_(bare_wall(parameters.radius)) {
  parameters_.sectors += parameters_.sectors % 2;
  for (int band = 1; band <= parameters_.bands; ++band)
    slopes_.push_back(pinned::tan(band * parameters_.elevation / parameters_.bands));
}

/// The k-th of its samples.
Ycbcr TransitionCompass::pixel_of(const ImageView& image, const ScanLine& line, int k) {
  return image.at(line.x, static_cast<int>(line.bottom + k * (line.top - line.bottom) / kLineSamples));
}

/// The scan lines of the frame. False: no scan line is in view.
bool TransitionCompass::look(const RoomObservation& view) {
  scan_lines_.clear();
  const std::optional<HorizonCamera> camera = HorizonCamera::of(view, wall_);
  if (!camera || !std::isfinite(view.time)) return false;
  camera->find(parameters_.columns, columns_);
  for (const HorizonColumn& column : columns_) {
    if (column.covered) continue;
    double bottom = column.row;
    for (int band = 0; band < parameters_.bands; ++band) {
      const std::optional<double> top = camera->row_at(column.x, slopes_[static_cast<std::size_t>(band)]);
      if (!top || *top < 0.0 || *top >= bottom) break;
      if (bottom <= camera->height() - 1.0) scan_lines_.push_back({column.x, bottom, *top, band, column.azimuth});
      bottom = *top;
    }
  }
  for (const ScanLine& line : scan_lines_) {
    for (int k = 0; k < kLineSamples; k += 4) light_.add(pixel_of(view.image, line, k));
  }
  light_.next_frame(view.time, parameters_.light_memory);
  return !scan_lines_.empty();
}

void TransitionCompass::sample_colors(const RoomObservation& view) {
  for (std::size_t i = 0; i < scan_lines_.size(); i += 8) {
    for (int k = 0; k < kLineSamples; k += 8)
      palette_.push_back(light_.without_light(pixel_of(view.image, scan_lines_[i], k)));
  }
  // Thinned evenly, so that it covers the whole start.
  if (palette_.size() <= 2 * kMostColors) return;
  for (std::size_t i = 0; 2 * i < palette_.size(); ++i) palette_[i] = palette_[2 * i];
  palette_.resize((palette_.size() + 1) / 2);
}

/// Counts the transitions of one line.
void TransitionCompass::scan(const RoomObservation& view, const ScanLine& line) {
  for (const int pair : present_) counts_[static_cast<std::size_t>(pair)] = 0;
  present_.clear();
  int before = -1;
  for (int k = 0; k < kLineSamples; ++k) {
    const int now = classes_(light_.without_light(pixel_of(view.image, line, k)));
    if (before >= 0 && now != before) {
      const int pair = before * classes_.count() + now;
      if (counts_[static_cast<std::size_t>(pair)]++ == 0) present_.push_back(pair);
    }
    before = now;
  }
}

void TransitionCompass::learn(const RoomObservation& view) {
  if (!look(view)) return;
  if (!std::exchange(any_time_, true)) first_time_ = view.time;
  if (classes_.count() == 0) {
    sample_colors(view);
    if (view.time - first_time_ < parameters_.palette) return;
    classes_ = ColorClasses::of(palette_, parameters_.classes, parameters_.chroma, seed_);
    palette_ = {};
    pairs_ = classes_.count() * classes_.count();
    lines_.assign(places(), 0);
    transitions_.assign(cell(places(), 0), {});
    counts_.assign(static_cast<std::size_t>(pairs_), 0);
    return;
  }
  for (const ScanLine& line : scan_lines_) {
    scan(view, line);
    const std::size_t here = place(sector_of(line.azimuth, parameters_.sectors), line.band);
    ++lines_[here];
    for (const int pair : present_)
      transitions_[cell(here, pair)][counts_[static_cast<std::size_t>(pair)] > 1 ? 1 : 0] += 1.0f;
  }
  is_prepared_ = false;
}

/// Computes the logarithms once for many frames.
void TransitionCompass::prepare() {
  if (std::exchange(is_prepared_, true)) return;
  nothing_.assign(places(), 0.0);
  gains_.assign(transitions_.size(), {});
  for (int band = 0; band < parameters_.bands; ++band) {
    double lines = 0.0;
    for (int s = 0; s < parameters_.sectors; ++s) lines += lines_[place(s, band)];
    for (int pair = 0; pair < pairs_; ++pair) {
      std::array<double, 2> usual{};  // of the whole room; never 0
      for (std::size_t i = 0; i < 2; ++i) {
        double sum = 0.01;
        for (int s = 0; s < parameters_.sectors; ++s)
          sum += static_cast<double>(transitions_[cell(place(s, band), pair)][i]);
        usual[i] = sum / (lines + 1.0);
      }
      for (int s = 0; s < parameters_.sectors; ++s) prepare(place(s, band), pair, usual);
    }
  }
}

void TransitionCompass::prepare(std::size_t here, int pair, const std::array<double, 2>& usual) {
  const std::array<float, 2>& seen = transitions_[cell(here, pair)];
  std::array<double, 2> share{};  // of the lines with one, with several
  for (std::size_t i = 0; i < 2; ++i)
    share[i] = (static_cast<double>(seen[i]) + parameters_.prior * usual[i]) / (lines_[here] + parameters_.prior);
  const double none = pinned::log(std::max(1e-6, 1.0 - share[0] - share[1]));
  nothing_[here] += none;
  for (std::size_t i = 0; i < 2; ++i) gains_[cell(here, pair)][i] = static_cast<float>(pinned::log(share[i]) - none);
}

double TransitionCompass::compare(const RoomObservation& view) {
  if (!look(view) || classes_.count() == 0) return score_;
  prepare();
  for (const ScanLine& line : scan_lines_) {
    const int sector = sector_of(line.azimuth, parameters_.sectors);
    const std::size_t here = place(sector, line.band);
    const std::size_t there = place(reflected_sector(sector, parameters_.sectors), line.band);
    if (lines_[here] < kLeastLines || lines_[there] < kLeastLines) continue;
    scan(view, line);
    double lead = nothing_[there] - nothing_[here];
    for (const int pair : present_) {
      const std::size_t i = counts_[static_cast<std::size_t>(pair)] > 1 ? 1 : 0;
      lead += static_cast<double>(gains_[cell(there, pair)][i]) - static_cast<double>(gains_[cell(here, pair)][i]);
    }
    score_ += std::clamp(lead, -parameters_.cap, parameters_.cap) / static_cast<double>(parameters_.columns);
  }
  return score_;
}

}  // namespace reorient
