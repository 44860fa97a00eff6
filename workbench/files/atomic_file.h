// SPDX-License-Identifier: MIT
// Files that are written completely or not at all: written to a temporary file, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// Throws std::runtime_error with one line; the file is then unchanged.
void write_whole_file(const std::filesystem::path& file, std::string_view bytes);

/// For files that are written in parts: a temporary file beside `file`, which replaces it once it is complete.
class FileInTheMaking {
 public:
  /// Throws std::runtime_error with one line.
  explicit FileInTheMaking(std::filesystem::path file);
  /// Removes a file that was not completed.
  ~FileInTheMaking();
  FileInTheMaking(const FileInTheMaking&) = delete;
  FileInTheMaking& operator=(const FileInTheMaking&) = delete;

  /// The path to write to; for a pipe or a device the path itself.
  const std::filesystem::path& path() const { return path_; }
  /// Call when the file is complete and closed. Throws std::runtime_error with one line.
  void end();

 private:
  std::filesystem::path file_, target_, path_;
  bool is_ended_ = false;
};

/// Writes one of several independent outputs: if `write` throws, adds a line to `failures`.
void try_to_write(std::vector<std::string>& failures, const std::function<void()>& write);

/// Checks before a long run that its results can be written. `option`: the option that names the file. Throws
/// std::runtime_error with one line.
void require_writable_file(const std::filesystem::path& file, std::string_view option);
/// The same for a folder; creates it if it is missing.
void require_writable_folder(const std::filesystem::path& folder, std::string_view option);

}  // namespace reorient
