// SPDX-License-Identifier: MIT
// Writes a recording as CSV tables, for spreadsheets and plots.
#pragma once

#include <cstdint>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/recording/recording.h"

namespace reorient {

/// Names of the tables: "world", "events".
std::vector<std::string> csv_topics();

/// Whether a text begins as a table.
bool begins_csv(std::string_view text);

/// world: one line for each frame with all world fields, and with the true pose if it is known. events: one line for
/// each command and change of state. Returns the number of frames whose record cannot be read; each is a damage of the
/// recording. Ends early if `out` fails. Throws std::runtime_error with one line for an unknown table.
std::uint64_t write_csv(Recording& recording, std::string_view topic, std::ostream& out);

}  // namespace reorient
