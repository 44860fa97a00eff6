// SPDX-License-Identifier: MIT
// Writes a recording as CSV tables, for spreadsheets and plots.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/recording.h"

namespace reorient {

/// Names of the tables: "world", "events".
std::vector<std::string> csv_topics();

/// world: one line for each frame with all world fields, and with the true pose if it is known. events: one line for
/// each command and change of state. Throws std::runtime_error with one line for an unknown table.
void write_csv(Recording& recording, std::string_view topic, std::ostream& out);

}  // namespace reorient
