// SPDX-License-Identifier: MIT
// Tables as text (RFC 4180).
#pragma once

#include <string>
#include <string_view>

namespace reorient {

/// One cell, in quotes if necessary. A text that a spreadsheet would execute as a formula, because it begins with
/// = + - or @, gets an apostrophe before it; numbers do not.
std::string csv_cell(std::string_view text);

}  // namespace reorient
