// SPDX-License-Identifier: MIT
#include "workbench/experiments/tables/measure_row.h"

#include <algorithm>

#include "workbench/experiments/statistics/times.h"

namespace reorient {

std::vector<MeasureRow> measure_rows_of(const std::vector<TrialResult>& results) {
  std::size_t count = 0;
  for (const TrialResult& result : results) count = std::max(count, result.measures.size());
  std::vector<MeasureRow> rows(count);
  for (std::size_t i = 0; i < count; ++i) {
    std::vector<double> values;
    for (const TrialResult& result : results) {
      if (i < result.measures.size() && result.measures[i]) values.push_back(*result.measures[i]);
    }
    MeasureRow& row = rows[i];
    row.trials = static_cast<int>(values.size());
    if (values.empty()) continue;
    row.mean = mean(values);
    if (values.size() > 1) row.interval = bootstrap_interval(values);
    row.least = *std::min_element(values.begin(), values.end());
    row.most = *std::max_element(values.begin(), values.end());
  }
  return rows;
}

}  // namespace reorient
