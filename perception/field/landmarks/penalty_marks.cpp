// SPDX-License-Identifier: MIT
#include "perception/field/landmarks/penalty_marks.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace reorient {
namespace {

using Eigen::Vector2d;

constexpr std::size_t kMostMarks = 4;
constexpr double kBesideBall = 0.3;  // m, distance from the ball within which white spots count as part of the ball

constexpr std::size_t kAround = 32;

/// Mean luma of a ring around a position. Nearly all of its visible part must be carpet. `step`: uses every
/// n-th position.
std::optional<double> luma_of_carpet_ring(const FieldImage& seen, const Vector2d& center, double radius,
                                          std::size_t step, int most_others) {
  constexpr std::size_t kMostOutside = kAround / 4;  // of the image
  int carpet = 0, others = 0;
  std::size_t outside = 0;
  double sum = 0.0;
  for (std::size_t i = 0; i < kAround; i += step) {
    const auto pixel = seen.nearest_to_ground(center + radius * directions_around<kAround>()[i]);
    if (!pixel) {
      if (step * ++outside > kMostOutside) return std::nullopt;
    } else if (seen.surface(*pixel) == Surface::carpet) {
      ++carpet;
      sum += seen.at(*pixel).y;
    } else if (++others > most_others) {
      return std::nullopt;
    }
  }
  return sum / carpet;
}

}  // namespace

PenaltyMarks::PenaltyMarks(const FieldFeatureParameters& parameters, const FieldDimensions& field)
    : parameters_(parameters), size_(field.penalty_mark_size) {}

void PenaltyMarks::find(const FieldImage& seen, std::span<const Vector2d> lone, FieldPercept& percept) const {
  percept.penalty_marks.clear();
  if (size_ <= 0.0) return;
  for (const Vector2d& place : lone) {
    if (percept.penalty_marks.size() >= kMostMarks) return;
    const auto is_near = [&](const PenaltyMark& mark) { return (mark.position - place).norm() < 2.0 * size_; };
    if (std::any_of(percept.penalty_marks.begin(), percept.penalty_marks.end(), is_near)) continue;
    if (percept.ball && (percept.ball->position - place).norm() < kBesideBall) continue;
    if (const auto mark = mark_at(seen, place)) percept.penalty_marks.push_back(*mark);
  }
}

/// Whether the middle of a mark is as white as lines are, compared with the carpet's luma around it.
bool PenaltyMarks::is_white(const FieldImage& seen, const Vector2d& center, double carpet) const {
  constexpr double kApart = 0.2;          // fraction of the mark's size, in a grid of 3 by 3 positions
  constexpr int kLeastOther = 7;          // of the positions
  constexpr double kLeastContrast = 0.5;  // fraction of the contrast of lines
  int places = 0, other = 0;
  double luma = 0.0;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      const auto pixel = seen.nearest_to_ground(center + kApart * size_ * Vector2d(i, j));
      if (!pixel) continue;
      ++places;
      luma += seen.at(*pixel).y;
      other += seen.surface(*pixel) != Surface::carpet ? 1 : 0;
    }
  }
  const double least = std::max({2.0 * parameters_.line_contrast, parameters_.noise_factor * seen.color.noise(),
                                 kLeastContrast * seen.color.white_contrast()});
  return other >= kLeastOther && luma / places - carpet >= least;
}

std::optional<PenaltyMark> PenaltyMarks::mark_at(const FieldImage& seen, const Vector2d& place) const {
  constexpr double kLeastHeight = 2.0;            // pixels from the near to the far edge of a mark
  constexpr double kRing = 1.2, kWideRing = 2.0;  // multiples of the mark's size
  constexpr double kMostSpread = 0.62;            // fraction of its size
  constexpr int kSteps = 4;                       // of a grid, to each side of the middle
  const GroundProjection& view = seen.view;
  const Vector2d away = view.away(place);
  const auto near = view.pixel({place.x() - 0.5 * size_ * away.x(), place.y() - 0.5 * size_ * away.y(), 0.0});
  const auto far = view.pixel({place.x() + 0.5 * size_ * away.x(), place.y() + 0.5 * size_ * away.y(), 0.0});
  if (!near || !far || (*near - *far).norm() < kLeastHeight) return std::nullopt;

  // The center of the pixels that are brighter than the carpet around. The initial position may be on the mark's edge.
  const auto rough = luma_of_carpet_ring(seen, place, kRing * size_, 4, 2);
  if (!rough) return std::nullopt;
  Vector2d center = place;
  double carpet = *rough, spread = 0.0;
  for (int iteration = 0; iteration < 2; ++iteration) {
    Vector2d sum = Vector2d::Zero();
    double weight = 0.0, squares = 0.0;
    for (int i = -kSteps; i <= kSteps; ++i) {
      for (int j = -kSteps; j <= kSteps; ++j) {
        const Vector2d offset = size_ / kSteps * Vector2d(i, j);
        if (offset.norm() > 1.05 * size_) continue;
        const auto pixel = seen.nearest_to_ground(center + offset);
        if (!pixel) continue;
        const double bright = std::max(0.0, seen.at(*pixel).y - carpet - parameters_.line_contrast);
        sum += bright * offset;
        squares += bright * offset.squaredNorm();
        weight += bright;
      }
    }
    if (!(weight > 0.0)) return std::nullopt;
    center += sum / weight;
    spread = std::sqrt(std::max(0.0, squares / weight - (sum / weight).squaredNorm()));
    const auto ring = luma_of_carpet_ring(seen, center, kRing * size_, 1, 1);
    if (!ring) return std::nullopt;
    carpet = *ring;
  }
  if (!luma_of_carpet_ring(seen, center, kWideRing * size_, 1, 1)) return std::nullopt;
  if (spread > kMostSpread * size_ || !is_white(seen, center, carpet)) return std::nullopt;
  PenaltyMark mark;
  mark.position = center;
  const auto pixel = view.pixel({center.x(), center.y(), 0.0});
  if (!pixel) return std::nullopt;
  mark.pixel = pixel->cast<float>();
  mark.covariance = view.covariance(center, parameters_.attitude_deviation, *pixel, parameters_.pixel_deviation);
  return mark;
}

}  // namespace reorient
