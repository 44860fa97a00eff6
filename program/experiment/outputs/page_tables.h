// SPDX-License-Identifier: MIT
// Tables of a Markdown page that are made from stored results, so that each figure stays up to date.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace reorient {

/// The page with all tables between two comments updated (docs/experiments.md):
///
///     <!-- rows table1.json: test, mode | trials, failed, mean_s | light = hard, mode = default, mode = paper -->
///     <!-- end of rows -->
///
/// The comment names a file that --json wrote, after the colon the columns, and last the rows. `read`: returns the text
/// of a file that the page names; for FILE.run.json, what tools/evidence writes beside FILE.json, or nothing if it is
/// missing. Throws std::runtime_error with one line: the line of the page, and what is wrong.
std::string with_tables(std::string_view page,
                        const std::function<std::string(const std::filesystem::path& file)>& read);

}  // namespace reorient
