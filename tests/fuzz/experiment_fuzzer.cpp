// SPDX-License-Identifier: MIT
// Arbitrary bytes as an experiment file or a condition file: refused with one line that names the file, or read as an
// experiment whose cells and tasks can be counted and whose conditions are within their limits.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/image.h"
#include "tests/fuzz/promises.h"
#include "workbench/experiments/condition/experiment_file.h"
#include "workbench/experiments/plan/plan.h"

namespace reorient {
namespace {

void require_condition(const Condition& condition) {
  constexpr double kDay = 86'400.0;  // s
  require(!condition.scenario.empty(), "a condition has a scenario");
  require(std::find(kImageWidths.begin(), kImageWidths.end(), condition.width) != kImageWidths.end(),
          "a width is one of the supported ones");
  require(condition.cameras == "upper" || condition.cameras == "both", "cameras are upper or both");
  require(condition.seconds >= 1.0 && condition.seconds <= kDay, "the duration of a trial is bounded");
  require(condition.measurement.limit >= 0.0 && condition.measurement.limit <= kDay, "a limit is at most a day");
  require(condition.measurement.hold >= 0.0 && condition.measurement.hold <= kDay, "a hold is at most a day");
  for (const ParameterChange& change : condition.parameters)
    require(!change.name.empty() && change.source.starts_with("experiment.toml:"),
            "a parameter contains the place where it is set");
  require(as_text(condition) == as_text(Condition(condition)), "equal conditions have equal texts");
}

void plan(const Experiment& experiment) {
  const std::vector<Cell> cells = cells_of(experiment);
  std::set<std::vector<std::string>> names;
  for (const Cell& cell : cells) {
    require(cell.choices.size() == experiment.axes.size(), "a cell has a choice on each axis");
    require(names.insert(cell.choices).second, "the names of cells differ");
  }
  const std::vector<Task> tasks = tasks_of(experiment, 1);
  require(tasks.size() == cells.size() * static_cast<std::size_t>(experiment.trials), "each trial is a task");
  for (std::size_t i = 0; i < tasks.size(); i += 1 + tasks.size() / 50)
    require_condition(condition_of(experiment, cells[tasks[i].cell], tasks[i]));
}

void try_experiment(std::string_view text) {
  const Haste haste(5.0);
  Experiment experiment;
  try {
    experiment = parse_experiment(text, "experiment.toml");
  } catch (const std::runtime_error& error) {
    require_message(error.what());
    require(std::string_view(error.what()).starts_with("experiment.toml:"), "a refusal names the file");
    return;
  }
  try {
    plan(experiment);
  } catch (const std::runtime_error& error) {  // too large
    require_message(error.what());
  }
}

/// The same bytes as a separate condition file.
void try_condition(std::string_view text) {
  const Haste haste(5.0);
  try {
    Condition condition;
    apply(parse_condition(text, "experiment.toml"), condition);
    if (!condition.scenario.empty()) require_condition(condition);
  } catch (const std::runtime_error& error) {
    require_message(error.what());
    require(std::string_view(error.what()).starts_with("experiment.toml:"), "a refusal names the file");
  }
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  reorient::try_experiment(text);
  reorient::try_condition(text);
  return 0;
}
