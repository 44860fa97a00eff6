#include "workbench/experiments/tables/row.h"

#include <cmath>
#include <limits>

#include "workbench/experiments/statistics/rates.h"
#include "workbench/experiments/statistics/times.h"

namespace reorient {
namespace {

TimeRow time_row(const std::vector<double>& times) {
  if (times.empty()) return {};
  return {mean(times), bootstrap_interval(times)};
}

std::optional<double> if_known(double value) { return std::isnan(value) ? std::nullopt : std::optional(value); }

}  // namespace

Row row_of(const std::vector<TrialResult>& results) {
  Row row;
  std::vector<double> right, mended, by_flip, by_purge, kidnapped_right, usable;
  std::vector<CensoredTime> until_right, until_mended;
  double right_seconds = 0.0;
  for (const TrialResult& result : results) {
    ++row.trials;
    row.not_started += result.started ? 0 : 1;
    row.flips += result.flips;
    row.purges += result.purges;
    row.false_flips += result.false_flips;
    row.false_purges += result.false_purges;
    right_seconds += result.right_seconds;
    if (result.usable_after) usable.push_back(*result.usable_after);
    if (result.kidnapped) {
      ++row.kidnapped;
      row.kidnapped_failed += result.failed() ? 1 : 0;
      if (result.right_after) kidnapped_right.push_back(*result.right_after);
    }
    if (result.started && result.correct_at_start) continue;
    ++row.disturbed;
    row.failed += result.failed() ? 1 : 0;
    row.uninformative += result.failed() && result.ended_uninformative ? 1 : 0;
    until_right.push_back({result.right_after.value_or(result.seconds), result.right_after.has_value()});
    until_mended.push_back({result.mended_after.value_or(result.seconds), result.mended_after.has_value()});
    if (result.right_after) right.push_back(*result.right_after);
    if (!result.mended_after) continue;
    mended.push_back(*result.mended_after);
    row.flip += result.mended_by == Reorientation::flip_pose ? 1 : 0;
    row.purge += result.mended_by == Reorientation::purge_reflection ? 1 : 0;
    row.reset += result.mended_by == Reorientation::reset_orientation ? 1 : 0;
    if (result.mended_by == Reorientation::flip_pose) by_flip.push_back(*result.mended_after);
    if (result.mended_by == Reorientation::purge_reflection) by_purge.push_back(*result.mended_after);
  }
  constexpr double kHour = 3600.0;  // s
  row.failed_rate = wilson_interval(row.failed, row.disturbed);
  row.right = time_row(right);
  const std::vector<SurvivalStep> curve = kaplan_meier(until_right);
  row.right_median = if_known(time_by_which(curve, 0.5));
  row.right_p90 = if_known(time_by_which(curve, 0.9));
  row.mended = time_row(mended);
  const std::vector<SurvivalStep> mended_curve = kaplan_meier(until_mended);
  row.mended_median = if_known(time_by_which(mended_curve, 0.5));
  row.mended_p90 = if_known(time_by_which(mended_curve, 0.9));
  row.kidnapped_right = time_row(kidnapped_right);
  row.usable = time_row(usable);
  row.flip_time = time_row(by_flip);
  row.purge_time = time_row(by_purge);
  row.right_hours = right_seconds / kHour;
  row.false_flip_rate = row.right_hours > 0.0 ? poisson_rate(row.false_flips, row.right_hours)
                                              : Interval{0.0, std::numeric_limits<double>::infinity()};
  return row;
}

}  // namespace reorient
