// SPDX-License-Identifier: MIT
// The files that a command line names: none is written twice, and none that is read is written.
#pragma once

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace reorient {

class NamedFiles {
 public:
  /// `name`: the option, or what else a person calls it: "the recording".
  void reads(const std::filesystem::path& file, const std::string& name);
  /// All scripts below a root.
  void reads_scripts(const std::filesystem::path& root);
  /// Throws std::runtime_error with one line where it is one of those that were named before. Nothing is named: no
  /// path.
  void writes(const std::filesystem::path& file, const std::string& option);
  /// The same, and where it cannot be written.
  void require_writable(const std::filesystem::path& file, const std::string& option);

 private:
  std::vector<std::pair<std::filesystem::path, std::string>> named_;  // and what names it
  std::vector<std::filesystem::path> roots_;                          // of scripts
};

/// Of a command that writes one file, if any, and reads scripts. Throws std::runtime_error with one line where that
/// file cannot be written or lies among the scripts.
void require_writable_output(const std::filesystem::path& file, const std::string& option,
                             const std::filesystem::path& scripts);

}  // namespace reorient
