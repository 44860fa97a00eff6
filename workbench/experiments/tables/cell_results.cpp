#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

std::string not_started_note(const CellResults& cell) {
  if (cell.row.not_started == 0) return {};
  std::string note;
  for (const std::string& choice : cell.choices) note += (note.empty() ? "" : ", ") + choice;
  return note + (note.empty() ? "" : ": ") + std::to_string(cell.row.not_started) + " of " +
         std::to_string(cell.row.trials) +
         " trials never came to the state from which they are measured, and count as failed: perhaps 'seconds' is too "
         "short";
}

}  // namespace reorient
