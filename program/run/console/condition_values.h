// SPDX-License-Identifier: MIT
// The world fields that the condition of a transition reads, by the text of its script.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// The full names, as "confidence.evidence", in the order of the text. `line`: where the transition begins. Includes
/// those of local functions of the same file that the condition names, but not of libraries. Never fails: unusual text
/// gives fewer names.
std::vector<std::string> fields_read_at(std::string_view script, int line);

}  // namespace reorient
