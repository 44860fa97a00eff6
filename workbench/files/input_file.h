// SPDX-License-Identifier: MIT
// Reads the input files of the program, each with a limit: a wrong or a sparse file of many GB must cost neither time
// nor memory.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace reorient {

/// Bytes: the usual limit of a text that this program reads.
inline constexpr std::uintmax_t kLargestText = std::uintmax_t{64} << 20;

/// The whole content of a plain file of at most `most` bytes; links are followed. `what`: the expected content, as in
/// "a parameter file". Throws std::runtime_error with the true reason, without the file's name: "expected a parameter
/// file, found a folder".
std::string read_input(const std::filesystem::path& file, const std::string& what, std::uintmax_t most = kLargestText);

/// The same. The message is one line that begins with the file's name.
std::string read_named_input(const std::filesystem::path& file, const std::string& what,
                             std::uintmax_t most = kLargestText);

}  // namespace reorient
