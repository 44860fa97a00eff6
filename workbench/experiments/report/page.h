// SPDX-License-Identifier: MIT
// The report as one page for a browser: it needs no network, no script and no other file.
#pragma once

#include <string>

#include "workbench/experiments/report/report.h"

namespace reorient {

/// HTML that is well-formed XML, too. Equal reports have equal pages.
std::string report_page(const Report& report);

}  // namespace reorient
