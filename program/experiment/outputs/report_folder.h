// SPDX-License-Identifier: MIT
// --report: a page for people, and all trials as files beside it.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workbench/experiments/report/report.h"

namespace reorient {

/// Of this processor, now; `command`: what makes the report again.
Provenance provenance_here(const std::string& command);

/// index.html, rows.json, trials.csv and trials.json. Each is there as a whole or not at all, whatever becomes of the
/// others. Returns a line for each that could not be written.
std::vector<std::string> write_report(const Report& report, const std::filesystem::path& folder);

}  // namespace reorient
