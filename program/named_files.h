// SPDX-License-Identifier: MIT
// The files of a command line: no file is written twice, and no file that is read is written.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace reorient {

class NamedFiles {
 public:
  /// `name`: the option, or a description such as "the recording".
  void reads(const std::filesystem::path& file, const std::string& name);
  /// All scripts below a root.
  void reads_scripts(const std::filesystem::path& root);
  /// Throws std::runtime_error with one line if the file was named before. An empty path names no file.
  void writes(const std::filesystem::path& file, const std::string& option);
  /// The same; also throws if the file cannot be written.
  void require_writable(const std::filesystem::path& file, const std::string& option);

 private:
  std::vector<std::pair<std::filesystem::path, std::string>> named_;  // and the option that names it
  std::vector<std::filesystem::path> roots_;                          // of scripts
};

/// For a command that writes at most one file and reads scripts. Throws std::runtime_error with one line if the file
/// cannot be written or is among the scripts.
void require_writable_output(const std::filesystem::path& file, const std::string& option,
                             const std::filesystem::path& scripts);

}  // namespace reorient
