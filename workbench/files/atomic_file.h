// SPDX-License-Identifier: MIT
// Files that are there as a whole or not at all: written beside, then renamed.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace reorient {

/// Throws std::runtime_error with one line; then the file is unchanged.
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

  /// Where to write; a pipe or a device stands for itself.
  const std::filesystem::path& path() const { return path_; }
  /// It is whole, and closed. Throws std::runtime_error with one line.
  void end();

 private:
  std::filesystem::path file_, target_, path_;
  bool is_ended_ = false;
};

/// One of several outputs, independent of the others: where `write` throws, `failures` gets one line more.
void try_to_write(std::vector<std::string>& failures, const std::function<void()>& write);

/// Nothing: it cannot be read.
std::optional<std::string> read_whole_file(const std::filesystem::path& file);

/// Finds out before a long run, not after it, that its results could not be written. `option`: what names the place on
/// the command line. Throws std::runtime_error with one line.
void require_writable_file(const std::filesystem::path& file, std::string_view option);
/// The same; makes the folder if it is not there.
void require_writable_folder(const std::filesystem::path& folder, std::string_view option);

}  // namespace reorient
