// SPDX-License-Identifier: MIT
// Notices that files below a folder were changed, in place or by renaming, one or many at once.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>

namespace reorient {

/// Watches the directories with inotify; if that is impossible for some of them, or does not report what other
/// machines change, compares times and sizes now and then. Where the
/// folder itself gives way to another, by a rename or as a symbolic link, that one is watched.
class FileWatcher {
 public:
  enum class Means { automatic, polling };

  explicit FileWatcher(std::filesystem::path root, Means means = Means::automatic);
  ~FileWatcher();
  FileWatcher(const FileWatcher&) = delete;
  FileWatcher& operator=(const FileWatcher&) = delete;

  /// Never blocks. True once after something has changed and then been quiet for a moment (or has not been quiet for
  /// `kPatience`): files that are saved together are reported together. `time` in s, from any steady clock.
  bool poll(double time);

  bool uses_inotify() const { return descriptor_ >= 0; }

  static constexpr double kQuiet = 0.04;    ///< s
  static constexpr double kPatience = 0.1;  ///< s
  static constexpr double kInterval = 0.2;  ///< s between two looks at the folder, and without inotify at the files

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
  bool has_all_ = true;                   // folders that there are could be watched
  std::optional<Identity> watched_root_;  ///< nothing: the folder is gone
  double first_change_ = -1.0;
  double last_change_ = -1.0;
  bool pending_ = false;
  double next_look_ = 0.0;
  bool looked_ = false;
  std::uint64_t signature_ = 0;
};

}  // namespace reorient
