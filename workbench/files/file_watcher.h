// SPDX-License-Identifier: MIT
// Detects changed files below a folder, changed in place or by renaming, one or many at once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace reorient {

/// Watches the directories with inotify. If that is impossible for some of them, or does not report changes by other
/// machines, compares times and sizes periodically. If the folder itself is replaced, by a rename or a switched
/// symbolic link, watches the new one.
class FileWatcher {
 public:
  enum class Means { automatic, polling };

  explicit FileWatcher(std::filesystem::path root, Means means = Means::automatic);
  ~FileWatcher();
  FileWatcher(const FileWatcher&) = delete;
  FileWatcher& operator=(const FileWatcher&) = delete;

  /// Never blocks. True once after a change, when there was no further change for `kQuiet` (at the latest after
  /// `kPatience`): files that are saved together are reported together. `time` in s, from any steady clock.
  bool poll(double time);

  bool uses_inotify() const { return descriptor_ >= 0; }

  static constexpr double kQuiet = 0.04;    ///< s
  static constexpr double kPatience = 0.1;  ///< s
  static constexpr double kInterval = 0.2;  ///< s between two checks of the folder, and without inotify of the files

 private:
  using Identity = std::pair<std::uint64_t, std::uint64_t>;  // device and inode

  std::optional<Identity> identity() const;
  void begin_watching();
  void stop_watching();
  bool follow_root();
  void watch_directories();
  bool read_events();
  bool compare_files();
  std::uint64_t signature() const;

  std::filesystem::path root_;
  int descriptor_ = -1;
  std::map<int, std::filesystem::path> watched_;
  int root_watch_ = -1;
  bool has_all_ = true;                   // all existing folders are watched
  std::optional<Identity> watched_root_;  ///< nothing: the folder is missing
  double first_change_ = -1.0;
  double last_change_ = -1.0;
  bool pending_ = false;
  double next_look_ = 0.0;
  bool looked_ = false;
  std::uint64_t signature_ = 0;
};

}  // namespace reorient
