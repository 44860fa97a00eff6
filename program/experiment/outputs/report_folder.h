// SPDX-License-Identifier: MIT
// --report: a page with figures, and files with all trials.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workbench/experiments/report/report.h"

namespace reorient {

/// This processor and the present time; `command` makes the report again.
Provenance provenance_here(const std::string& command);

/// index.html, rows.json, trials.csv and trials.json. Each file is written completely or not at all, independent of the
/// others. Returns a line for each file that could not be written.
std::vector<std::string> write_report(const Report& report, const std::filesystem::path& folder);

}  // namespace reorient
