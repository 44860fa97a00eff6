// SPDX-License-Identifier: MIT
#include "workbench/experiments/tables/pose_row.h"

#include <algorithm>
#include <cmath>

#include "workbench/experiments/statistics/times.h"

namespace reorient {
namespace {

/// Quantile of times; missing times count as later than all others. Nothing: too many are missing.
std::optional<double> ninetieth(const std::vector<std::optional<double>>& times) {
  std::vector<CensoredTime> all;
  all.reserve(times.size());
  constexpr double kNever = 1e9;  // s
  for (const std::optional<double>& time : times) all.push_back({time.value_or(kNever), time.has_value()});
  const double time = time_by_which(kaplan_meier(std::move(all)), 0.9);
  return std::isfinite(time) ? std::optional(time) : std::nullopt;
}

}  // namespace

std::optional<PoseRow> pose_row_of(const std::vector<TrialResult>& results) {
  PoseRow row;
  PoseErrors sum;
  std::vector<std::optional<double>> right, located, first;
  bool is_measured = false;
  for (const TrialResult& result : results) {
    if (!result.pose_errors) continue;
    is_measured = true;
    const PoseErrors& errors = *result.pose_errors;
    first.push_back(errors.located_after);
    if (errors.located_after && *errors.located_after <= PoseRow::kInTime) ++row.located_in_time;
    for (const FallRecovery& recovery : errors.recoveries) {
      right.push_back(recovery.right_after);
      located.push_back(recovery.located_after);
    }
    if (errors.frames == 0) continue;
    const auto frames = static_cast<double>(errors.frames);
    row.worst_position = std::max(row.worst_position, std::sqrt(errors.square_position / frames));
    row.worst_rotation = std::max(row.worst_rotation, std::sqrt(errors.square_rotation / frames));
    sum.frames += errors.frames;
    sum.mirrored_frames += errors.mirrored_frames;
    sum.square_position += errors.square_position;
    sum.square_rotation += errors.square_rotation;
    sum.normalized_square += errors.normalized_square;
    sum.frames_within += errors.frames_within;
  }
  if (!is_measured) return std::nullopt;
  constexpr double kDegreesOfFreedom = 3.0;
  const auto frames = static_cast<double>(std::max<std::int64_t>(1, sum.frames));
  row.position = std::sqrt(sum.square_position / frames);
  row.rotation = std::sqrt(sum.square_rotation / frames);
  row.mirrored = static_cast<double>(sum.mirrored_frames) / frames;
  row.normalized = sum.normalized_square / frames / kDegreesOfFreedom;
  row.within = static_cast<double>(sum.frames_within) / frames;
  row.falls = static_cast<int>(right.size());
  row.right_p90 = ninetieth(right);
  row.located_p90 = ninetieth(located);
  row.first_located_p90 = ninetieth(first);
  return row;
}

}  // namespace reorient
