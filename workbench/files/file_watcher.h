// SPDX-License-Identifier: MIT
// Detects changed files below some folders, changed in place or by renaming, one or many at once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace reorient {

/// Compares times and sizes of the files periodically, because no list of file systems says which ones report changes
/// by other computers. In addition inotify reports changes by this computer at once. If the root itself is replaced, by
/// a rename or a switched symbolic link, watches the new one. Each call may take as long as the file system takes, so
/// no frame calls it.
class FileWatcher {
 public:
  enum class Means { automatic, polling };

  /// `folders`: the watched folders below the root, with all that they contain; empty: the whole root.
  explicit FileWatcher(std::filesystem::path root, Means means = Means::automatic,
                       std::vector<std::filesystem::path> folders = {});
  ~FileWatcher();
  FileWatcher(const FileWatcher&) = delete;
  FileWatcher& operator=(const FileWatcher&) = delete;

  /// True once after a change, when there was no further change for `kQuiet` (at the latest after `kPatience`): files
  /// that are saved together are reported together. `time` in s, from any steady clock.
  bool poll(double time);

  static constexpr double kQuiet = 0.04;    ///< s
  static constexpr double kPatience = 0.1;  ///< s
  static constexpr double kInterval = 0.2;  ///< s between two comparisons, at least

 private:
  struct Identity {
    std::uint64_t device = 0, number = 0;
    bool operator==(const Identity&) const = default;
  };

  std::optional<Identity> identity() const;
  void begin_watching();
  void stop_watching();
  bool follow_root();
  void watch_directories();
  bool read_events();
  bool compare_files(double time);
  std::uint64_t signature() const;

  std::filesystem::path root_;
  std::vector<std::filesystem::path> folders_;  // with the root
  int descriptor_ = -1;
  std::map<int, std::filesystem::path> watched_;
  int root_watch_ = -1;
  bool has_all_ = true;                   // all existing folders are watched
  std::optional<Identity> watched_root_;  // nothing: the folder is missing
  double first_change_ = -1.0;
  double last_change_ = -1.0;
  bool pending_ = false;
  double next_look_ = 0.0;
  bool looked_ = false;
  std::uint64_t signature_ = 0;
};

}  // namespace reorient
