// SPDX-License-Identifier: MIT
// Tables of a Markdown page that are generated from stored results, so that they always show what was measured.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace reorient {

/// Whether a page has a comment that requests a table.
bool has_tables(std::string_view page);

/// The page with each table generated again that stands between two comments (docs/experiments.md):
///
///     <!-- rows table1.json: test, mode | trials, failed, mean_s | light = hard, mode = default, mode = paper -->
///     <!-- end of rows -->
///
/// A file that --json wrote stands before the colon, the columns behind it, and the values that a row must have at the
/// end. If a key stands there several times, a row must have one of these values. `read` returns the text of a file
/// that the page names. For FILE.run.json, which tools/evidence writes beside FILE.json, it returns an empty text if
/// there is no such file. Throws std::runtime_error with one line: the line of the page, and what is wrong there.
std::string with_tables(std::string_view page,
                        const std::function<std::string(const std::filesystem::path& file)>& read);

}  // namespace reorient
