// SPDX-License-Identifier: MIT
#include "workbench/experiments/tables/compass_rows.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "workbench/experiments/statistics/rates.h"

namespace reorient {
namespace {

using Trials = std::vector<const TrialResult*>;

CompassFigure figure_of(const Trials& trials, std::size_t method, std::size_t time) {
  std::vector<ScoredGroup> groups;
  std::vector<double> positives, negatives;
  int silent = 0;
  double flips = 0.0, false_flips = 0.0;
  for (const TrialResult* trial : trials) {
    ScoredGroup& group = groups.emplace_back();
    for (const CompassLook& look : trial->looks) {
      const CompassScores& scores = look[method];
      group.positives.push_back(scores.if_reflected[time]);
      group.negatives.push_back(scores.if_right[time]);
      silent += scores.if_reflected[time] == 0.0 && scores.if_right[time] == 0.0 ? 1 : 0;
      flips += scores.flips_if_reflected[time];
      false_flips += scores.flips_if_right[time];
    }
    positives.insert(positives.end(), group.positives.begin(), group.positives.end());
    negatives.insert(negatives.end(), group.negatives.begin(), group.negatives.end());
  }
  const auto looks = static_cast<int>(positives.size());
  CompassFigure figure;
  figure.silent = static_cast<double>(silent) / looks;
  if (kHasFlipRule[method]) {
    figure.flipped = flips / looks;
    figure.false_flipped = false_flips / looks;
  }
  figure.curve = roc_curve(std::move(positives), std::move(negatives));
  figure.area = area_below(figure.curve);
  figure.area_interval = bootstrap_area_interval(groups);
  figure.equal_error = equal_error_rate(figure.curve);
  figure.equal_error_interval = wilson_interval(static_cast<int>(std::lround(figure.equal_error * looks)), looks);
  return figure;
}

/// A row for each method, of the cells with these choices; nothing matches any choice.
void add_rows(const std::vector<CellResults>& cells, const std::vector<std::optional<std::string>>& wanted,
              std::vector<CompassRow>& rows) {
  Trials trials;
  int looks = 0;
  for (const CellResults& cell : cells) {
    const bool fits = std::equal(cell.choices.begin(), cell.choices.end(), wanted.begin(), wanted.end(),
                                 [](const std::string& choice, const auto& one) { return !one || *one == choice; });
    if (!fits) continue;
    for (const TrialResult& trial : cell.trials) {
      if (trial.looks.empty()) continue;
      trials.push_back(&trial);
      looks += static_cast<int>(trial.looks.size());
    }
  }
  if (looks == 0) return;
  for (std::size_t method = 0; method < kCompassMethods.size(); ++method) {
    CompassRow row;
    for (const std::optional<std::string>& one : wanted) row.choices.push_back(one.value_or("all"));
    row.method = method;
    row.trials = static_cast<int>(trials.size());
    row.looks = looks;
    for (std::size_t time = 0; time < kLookTimes.size(); ++time) row.figures[time] = figure_of(trials, method, time);
    rows.push_back(std::move(row));
  }
}

}  // namespace

bool have_looks(const std::vector<CellResults>& cells) {
  return std::any_of(cells.begin(), cells.end(), [](const CellResults& cell) {
    return std::any_of(cell.trials.begin(), cell.trials.end(), [](const auto& trial) { return !trial.looks.empty(); });
  });
}

std::vector<CompassRow> compass_rows(const Experiment& experiment, const std::vector<CellResults>& cells) {
  std::vector<CompassRow> rows;
  const std::vector<Axis> axes = with_usual_choices(experiment).axes;
  std::vector<std::optional<std::string>> wanted(axes.size());
  const auto add_each_of_last = [&] {
    if (axes.empty()) return add_rows(cells, wanted, rows);
    for (const AxisChoice& choice : axes.back().choices) {
      wanted.back() = choice.name;
      add_rows(cells, wanted, rows);
    }
  };
  add_each_of_last();
  for (std::size_t axis = 0; axis + 1 < axes.size(); ++axis) {
    if (axes[axis].choices.size() < 2) continue;
    for (const AxisChoice& choice : axes[axis].choices) {
      wanted[axis] = choice.name;
      add_each_of_last();
    }
    wanted[axis].reset();
  }
  return rows;
}

}  // namespace reorient
