// SPDX-License-Identifier: MIT
#include "workbench/experiments/tables/cell_results.h"

#include <algorithm>
#include <iterator>

namespace reorient {

std::vector<CellResults> pooled_over_rooms(const Experiment& experiment, const std::vector<CellResults>& cells) {
  const auto axis =
      std::find_if(experiment.axes.begin(), experiment.axes.end(), [](const Axis& one) { return one.name == "room"; });
  if (axis == experiment.axes.end()) return {};
  const auto room = static_cast<std::size_t>(std::distance(experiment.axes.begin(), axis));
  if (std::all_of(cells.begin(), cells.end(),
                  [&](const CellResults& cell) { return cell.choices[room] == cells.front().choices[room]; }))
    return {};
  std::vector<CellResults> pooled;
  for (const CellResults& cell : cells) {
    std::vector<std::string> choices = cell.choices;
    choices[room] = kAllRooms;
    auto row = std::find_if(pooled.begin(), pooled.end(),
                            [&choices](const CellResults& one) { return one.choices == choices; });
    if (row == pooled.end()) row = pooled.insert(pooled.end(), {std::move(choices), {}, {}});
    row->trials.insert(row->trials.end(), cell.trials.begin(), cell.trials.end());
  }
  for (CellResults& row : pooled) {
    row.row = row_of(row.trials);
    row.trials.clear();
  }
  return pooled;
}

std::string not_started_note(const CellResults& cell) {
  if (cell.row.not_started == 0) return {};
  std::string note;
  for (const std::string& choice : cell.choices) note += (note.empty() ? "" : ", ") + choice;
  return note + (note.empty() ? "" : ": ") + std::to_string(cell.row.not_started) + " of " +
         std::to_string(cell.row.trials) +
         " trials never reached the state from which they are measured, and count as failed: perhaps 'seconds' is too "
         "short";
}

}  // namespace reorient
