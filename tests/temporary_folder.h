// SPDX-License-Identifier: MIT
// A folder for one test, which is removed at the end.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>

#include <unistd.h>

namespace reorient {

class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string pattern = (std::filesystem::temp_directory_path() / "reorient-XXXXXX").string();
    path_ = mkdtemp(pattern.data());
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }

  const std::filesystem::path& path() const { return path_; }

  /// Writes the file in place, as many editors do. Creates missing folders.
  std::filesystem::path write(const std::filesystem::path& name, std::string_view text) const {
    std::filesystem::path file = path_ / name;
    std::filesystem::create_directories(file.parent_path());
    std::ofstream(file, std::ios::binary) << text;
    return file;
  }

  /// Writes a second file and renames it to this one, as other editors do.
  void write_by_rename(const std::filesystem::path& name, std::string_view text) const {
    const std::filesystem::path beside = write(name.string() + ".new", text);
    std::filesystem::rename(beside, path_ / name);
  }

 private:
  std::filesystem::path path_;
};

}  // namespace reorient
