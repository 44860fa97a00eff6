// SPDX-License-Identifier: MIT
#include "workbench/experiments/plan/plan.h"

#include <charconv>
#include <set>
#include <stdexcept>
#include <string>

#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

constexpr std::size_t kMostTasks = 1'000'000;

int number_in(std::string_view text, std::string_view list, int count) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error == std::errc::invalid_argument || end != text.data() + text.size())
    throw std::runtime_error("expected a list of tasks, as in 17, 1-64 or 1-64,70, found '" +
                             as_line(list.substr(0, 60)) + "'");
  if (error != std::errc() || number < 1 || number > count)
    throw std::runtime_error("unknown task " + as_line(text.substr(0, 30)) + " (expected 1 to " +
                             std::to_string(count) + ")");
  return number;
}

}  // namespace

std::vector<Task> tasks_of(const Experiment& experiment, std::uint64_t first_seed) {
  const std::size_t cells = cells_of(experiment).size();
  const auto trials = static_cast<std::size_t>(experiment.trials);
  if (cells * trials > kMostTasks)
    throw std::runtime_error(as_line(experiment.name) + ": expected at most " + std::to_string(kMostTasks) +
                             " trials, found " + std::to_string(cells * trials));
  std::vector<Task> tasks;
  tasks.reserve(cells * trials);
  for (std::size_t cell = 0; cell < cells; ++cell) {
    for (int trial = 0; trial < experiment.trials; ++trial)
      tasks.push_back(
          {static_cast<int>(tasks.size()) + 1, cell, trial, first_seed + static_cast<std::uint64_t>(trial)});
  }
  return tasks;
}

Condition condition_of(const Experiment& experiment, const Cell& cell, const Task& task) {
  Condition condition = cell.condition;
  if (!experiment.alternates.empty())
    apply(experiment.alternates[static_cast<std::size_t>(task.trial) % experiment.alternates.size()], condition);
  return condition;
}

std::vector<int> numbers_in(std::string_view list, int count) {
  std::set<int> numbers;
  std::string_view rest = list;
  while (true) {
    const std::size_t comma = rest.find(',');
    const std::string_view part = rest.substr(0, comma);
    const std::size_t dash = part.find('-', 1);  // the first character may be a sign
    const int first = number_in(part.substr(0, dash), list, count);
    const int last = dash == std::string_view::npos ? first : number_in(part.substr(dash + 1), list, count);
    if (last < first)
      throw std::runtime_error("expected a range whose start is before its end, found '" + as_line(part) + "'; write " +
                               std::to_string(last) + "-" + std::to_string(first));
    for (int number = first; number <= last; ++number) numbers.insert(number);
    if (comma == std::string_view::npos) return {numbers.begin(), numbers.end()};
    rest.remove_prefix(comma + 1);
  }
}

}  // namespace reorient
