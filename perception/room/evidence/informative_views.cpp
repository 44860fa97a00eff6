// SPDX-License-Identifier: MIT
#include "perception/room/evidence/informative_views.h"

#include <algorithm>
#include <cmath>

#include "geometry/bytes.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr double kStep = 0.087;  // rad between the directions that are evaluated

int directions_within(double outermost) { return static_cast<int>(2.0 * outermost / kStep) + 1; }

}  // namespace

void ViewChooser::restart(int columns) {
  viewing_times_.assign(static_cast<std::size_t>(columns), 0.0);
  views_ = {};
}

void ViewChooser::rotate_by_180_degrees() {
  const auto half = viewing_times_.begin() + static_cast<std::ptrdiff_t>(viewing_times_.size() / 2);
  std::swap_ranges(viewing_times_.begin(), half, half);
}

/// Checks the state after reading.
void ViewChooser::check(std::size_t columns) const {
  check_bytes(viewing_times_.size() == columns,
              "informative views: expected one viewing time for each column of the wall");
  for (const double seconds : viewing_times_)
    check_bytes(seconds >= 0.0 && std::isfinite(seconds),
                "informative views: a viewing time is negative or not finite");
}

const InformativeViews& ViewChooser::choose(const Wall& wall, const ComparedModel& model, const Pose2& belief,
                                            const Isometry3& robot_from_camera, double step, double least_incidence,
                                            const ViewParameters& parameters) {
  views_ = {};
  const Eigen::Vector2d axis = robot_from_camera.linear().col(0).head<2>();
  const Eigen::Vector2d camera = belief * Eigen::Vector2d(robot_from_camera.translation().head<2>());
  // The body may have a neck with a range that is negative or not a number.
  const double outermost = std::max(0.0, parameters.reach) + parameters.half_width;
  if (!axis.allFinite() || !std::isfinite(belief.rotation) ||
      !look_around(wall, belief, camera, outermost, least_incidence))
    return views_;
  const double yaw = direction_of(axis);
  note_look(yaw, outermost, step, parameters);
  scores_.clear();
  for (const int column : columns_) scores_.push_back(column < 0 ? Score{} : score_of(column, wall, model, parameters));

  double best_rate = 0.0;
  double best_unknown_rate = 0.0;
  const int directions = static_cast<int>(columns_.size());
  const int width = static_cast<int>(2.0 * parameters.half_width / kStep);
  for (int first = 0; first + width < directions; ++first) {
    const double view = -outermost + kStep * (first + 0.5 * width);
    Score sum;
    int last = -1;
    for (int i = first; i <= first + width; ++i) {
      const int column = columns_[static_cast<std::size_t>(i)];
      if (column < 0 || column == last)
        continue;  // a column counts once in a view, independent of its number of directions
      last = column;
      const Score& score = scores_[static_cast<std::size_t>(i)];
      sum.difference += score.difference;
      sum.unknown += score.unknown;
    }
    const double seconds = std::abs(view - yaw) / parameters.speed + parameters.dwell;
    if (sum.difference > best_rate * seconds) {
      best_rate = sum.difference / seconds;
      views_.best_yaw = view;
      views_.best_score = sum.difference;
    }
    if (sum.unknown > best_unknown_rate * seconds) {
      best_unknown_rate = sum.unknown / seconds;
      views_.unknown_yaw = view;
      views_.unknown_score = sum.unknown;
    }
  }
  return views_;
}

/// Returns false if the camera is outside of the wall.
bool ViewChooser::look_around(const Wall& wall, const Pose2& belief, const Eigen::Vector2d& camera, double outermost,
                              double least_incidence) {
  if (!wall.surrounds(camera)) return false;
  const auto count = static_cast<std::size_t>(directions_within(outermost));
  angles_.resize(count);
  headings_.resize(count);
  normals_.resize(count);
  for (std::size_t i = 0; i < count; ++i) angles_[i] = belief.rotation - outermost + kStep * static_cast<double>(i);
  unit_vectors(angles_, headings_);
  wall.azimuths_seen(camera, headings_, angles_);
  unit_vectors(angles_, normals_);
  columns_.assign(count, -1);
  for (std::size_t i = 0; i < count; ++i) {
    if (headings_[i].dot(normals_[i]) > least_incidence) columns_[i] = static_cast<int>(wall.column_at(angles_[i]));
  }
  return true;
}

void ViewChooser::note_look(double yaw, double outermost, double step, const ViewParameters& parameters) {
  if (step <= 0.0) return;
  const double kept = pinned::exp(-step / parameters.memory);
  for (double& seconds : viewing_times_) seconds *= kept;
  int last = -1;
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    const double direction = -outermost + kStep * static_cast<double>(i);
    if (columns_[i] < 0 || columns_[i] == last || std::abs(direction - yaw) > parameters.half_width) continue;
    last = columns_[i];
    viewing_times_[static_cast<std::size_t>(last)] += step;
  }
}

ViewChooser::Score ViewChooser::score_of(int column, const Wall& wall, const ComparedModel& model,
                                         const ViewParameters& parameters) const {
  Score score;
  for (int row = 0; row < wall.rows(); ++row) {
    const int tile = wall.tile(row, column);
    if (!model.trusted(tile)) score.unknown += 1.0;
    if (!model.trusted(tile) && !model.trusted(wall.reflected(tile))) continue;
    score.difference += model.difference_to_reflection(tile).value_or(parameters.half_known);
  }
  // Columns that were in view recently and are still unknown cannot be learned from here.
  const double fresh = parameters.look / (parameters.look + viewing_times_[static_cast<std::size_t>(column)]);
  score.difference *= fresh;
  score.unknown *= fresh;
  return score;
}

}  // namespace reorient
