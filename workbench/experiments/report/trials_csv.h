// SPDX-License-Identifier: MIT
// All trials as a table for spreadsheets.
#pragma once

#include <string>

#include "workbench/experiments/report/report.h"

namespace reorient {

/// RFC 4180, UTF-8: a line of names, then one for each trial: the axes' choices, then what was measured, without the
/// confidences. Unknown values are empty.
std::string trials_as_csv(const Report& report);

}  // namespace reorient
