// SPDX-License-Identifier: MIT
// Tables of a Markdown page that are made from stored results, so that no figure on it can drift.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

namespace reorient {

/// The page with every table made anew that stands between two comments (docs/experiments.md):
///
///     <!-- rows evidence/table1.json: test, mode | trials, failed, mean_s | light = hard -->
///     <!-- end of rows -->
///
/// Before the colon stands a file that --json wrote, behind it the columns, and at last which rows. `read`: the text of
/// a file that the page names; of FILE.run.json, what tools/evidence notes beside FILE.json, nothing where there is
/// none. Throws std::runtime_error with one line: the line of the page, what is wrong.
std::string with_tables(std::string_view page,
                        const std::function<std::string(const std::filesystem::path& file)>& read);

}  // namespace reorient
