// SPDX-License-Identifier: MIT
#include "workbench/experiments/report/report.h"

#include <algorithm>
#include <map>

#include "workbench/experiments/plan/plan.h"

namespace reorient {
namespace {

constexpr std::size_t kStyles = 7;  // as many as the style sheet distinguishes

/// Nothing without axes.
std::optional<std::size_t> series_axis(const Experiment& experiment) {
  for (std::size_t i = experiment.axes.size(); i-- > 0;) {
    if (experiment.axes[i].choices.size() > 1) return i;
  }
  return experiment.axes.empty() ? std::nullopt : std::optional(experiment.axes.size() - 1);
}

}  // namespace

int task_of(const Report& report, std::size_t cell, std::size_t trial) {
  std::size_t before = 0;
  for (std::size_t i = 0; i < cell; ++i) before += report.cells[i].trials.size();
  return static_cast<int>(before + trial) + 1;
}

std::string seeds_of(const Report& report) {
  std::uint64_t first = ~std::uint64_t{0}, last = 0;
  for (const CellResults& cell : report.cells) {
    for (const TrialResult& trial : cell.trials) {
      first = std::min(first, trial.seed);
      last = std::max(last, trial.seed);
    }
  }
  if (first > last) return "none";
  return first == last ? std::to_string(first) : std::to_string(first) + " to " + std::to_string(last);
}

double limit_of(const Report& report, std::size_t cell) {
  const Cell wanted = cells_of(report.experiment)[cell];
  double limit = 0.0;
  Task task;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, report.experiment.alternates.size()); ++i) {
    task.trial = static_cast<int>(i);
    limit = std::max(limit, condition_of(report.experiment, wanted, task).measurement.limit);
  }
  return limit;
}

std::vector<Series> series_of(const Report& report) {
  const std::optional<std::size_t> axis = series_axis(report.experiment);
  std::vector<Series> all;
  for (std::size_t cell = 0; cell < report.cells.size(); ++cell) {
    const std::string name = axis ? report.cells[cell].choices[*axis] : "all trials";
    auto found = std::find_if(all.begin(), all.end(), [&](const Series& one) { return one.name == name; });
    if (found == all.end()) found = all.insert(all.end(), {name, "s" + std::to_string(all.size() % kStyles), {}});
    found->cells.push_back(cell);
  }
  return all;
}

std::vector<std::vector<Series>> pictures_of(const std::vector<Series>& series) {
  if (series.size() <= 1) return {series};
  std::vector<std::vector<Series>> pictures;
  for (std::size_t i = 1; i < series.size(); ++i) {
    if (pictures.empty() || pictures.back().size() == kStyles) pictures.push_back({series.front()});
    pictures.back().push_back(series[i]);
  }
  for (std::vector<Series>& picture : pictures) {
    const auto has_twin = [&](const Series& one) {
      return std::count_if(picture.begin(), picture.end(),
                           [&](const Series& other) { return other.style == one.style; }) > 1;
    };
    if (std::none_of(picture.begin(), picture.end(), has_twin)) continue;
    for (std::size_t i = 0; i < picture.size(); ++i) picture[i].style = "s" + std::to_string(i);
  }
  return pictures;
}

std::vector<CellGroup> groups_of(const Report& report) {
  const std::optional<std::size_t> axis = series_axis(report.experiment);
  std::vector<CellGroup> groups;
  for (std::size_t cell = 0; cell < report.cells.size(); ++cell) {
    std::string name;
    for (std::size_t i = 0; i < report.experiment.axes.size(); ++i) {
      if (i != axis && report.experiment.axes[i].choices.size() > 1)
        name += (name.empty() ? "" : ", ") + report.experiment.axes[i].name + " " + report.cells[cell].choices[i];
    }
    auto found = std::find_if(groups.begin(), groups.end(), [&](const CellGroup& one) { return one.name == name; });
    if (found == groups.end()) found = groups.insert(groups.end(), {name, {}});
    found->cells.push_back(cell);
  }
  return groups;
}

const Series& series_of_cell(const std::vector<Series>& series, std::size_t cell) {
  return *std::find_if(series.begin(), series.end(), [&](const Series& one) {
    return std::find(one.cells.begin(), one.cells.end(), cell) != one.cells.end();
  });
}

}  // namespace reorient
