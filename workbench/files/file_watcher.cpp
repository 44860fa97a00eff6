// SPDX-License-Identifier: MIT
#include "workbench/files/file_watcher.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <set>
#include <utility>

#include <sys/inotify.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/script/script_texts.h"
#include "workbench/files/folder_tree.h"

namespace reorient {
namespace {

constexpr std::uint32_t kEvents = IN_MODIFY | IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO |
                                  IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;

}  // namespace

FileWatcher::FileWatcher(std::filesystem::path root, Means means, std::vector<std::filesystem::path> folders)
    : root_(std::move(root)), folders_(std::move(folders)) {
  for (std::filesystem::path& folder : folders_) folder = root_ / folder;
  if (folders_.empty()) folders_.push_back(root_);
  if (means == Means::automatic) begin_watching();
  if (watched_.empty()) stop_watching();
  signature_ = signature();
}

FileWatcher::~FileWatcher() { stop_watching(); }

/// Only compares files from now on.
void FileWatcher::stop_watching() {
  if (descriptor_ >= 0) close(descriptor_);
  descriptor_ = -1;
}

std::optional<FileWatcher::Identity> FileWatcher::identity() const {
  struct stat status {};
  if (stat(root_.c_str(), &status) != 0) return std::nullopt;
  return Identity{status.st_dev, status.st_ino};
}

/// Restart: earlier watches report no more events.
void FileWatcher::begin_watching() {
  stop_watching();
  descriptor_ = inotify_init1(IN_NONBLOCK | IN_CLOEXEC);
  watched_.clear();
  watched_root_ = identity();
  if (descriptor_ >= 0) watch_directories();
}

/// Whether the root was replaced or created: a watch stays with its folder, even if that is moved.
bool FileWatcher::follow_root() {
  const std::optional<Identity> now = identity();
  if (now == watched_root_ && watched_.contains(root_watch_)) return false;
  watched_root_ = now;
  if (!now) return false;
  begin_watching();
  return true;
}

/// The root, and the watched folders with all directories below them. Watching one again adds no watch.
void FileWatcher::watch_directories() {
  const auto watch = [this](const std::filesystem::path& directory) {
    const int watch_id = inotify_add_watch(descriptor_, directory.c_str(), kEvents);
    if (watch_id >= 0) watched_[watch_id] = directory;
    has_all_ &= watch_id >= 0 || errno == ENOENT || errno == EACCES;
    return watch_id;
  };
  root_watch_ = watch(root_);
  for (const std::filesystem::path& folder : folders_) {
    if (folder != root_) watch(folder);
    visit_below(folder, [&watch](const std::filesystem::directory_entry& entry) {
      std::error_code gone;
      if (entry.is_directory(gone)) watch(entry.path());
    });
  }
}

/// Whether there was any event. Also watches new directories. Their files may be older than the watch, but the new
/// directory is an event itself, and the caller reads everything again.
bool FileWatcher::read_events() {
  alignas(inotify_event) std::array<char, 16 * 1024> buffer;
  bool any = false;
  bool rescan = false;
  for (ssize_t length = 0; (length = read(descriptor_, buffer.data(), buffer.size())) > 0;) {
    any = true;
    for (const char* at = buffer.data(); at < buffer.data() + length;) {
      inotify_event event;
      std::memcpy(&event, at, sizeof(event));
      at += sizeof(event) + event.len;
      if ((event.mask & IN_IGNORED) != 0) watched_.erase(event.wd);
      rescan |= (event.mask & (IN_ISDIR | IN_Q_OVERFLOW | IN_DELETE_SELF | IN_MOVE_SELF | IN_IGNORED)) != 0;
    }
  }
  if (rescan) watch_directories();
  return any;
}

std::uint64_t FileWatcher::signature() const {
  std::set<std::string> lines;
  for (const std::filesystem::path& folder : folders_) {
    visit_below(folder, [&lines](const std::filesystem::directory_entry& entry) {
      struct stat file {};
      if (stat(entry.path().c_str(), &file) != 0 || !S_ISREG(file.st_mode)) return;
      std::string line = entry.path().string();
      // An edit may keep the size, and a copy the time of its original.
      for (const auto value : {static_cast<std::int64_t>(file.st_ino), static_cast<std::int64_t>(file.st_size),
                               static_cast<std::int64_t>(file.st_mtim.tv_sec), std::int64_t{file.st_mtim.tv_nsec},
                               static_cast<std::int64_t>(file.st_ctim.tv_sec), std::int64_t{file.st_ctim.tv_nsec}})
        line += " " + std::to_string(value);
      lines.insert(std::move(line));
    });
  }
  std::uint64_t hash = 0;
  for (const std::string& line : lines) hash = hash * 31 + content_hash(line);
  return hash;
}

/// Whether the files changed since the last comparison. A slow file system is compared less often.
bool FileWatcher::compare_files(double time) {
  constexpr double kRest = 10.0;  // times as long as the comparison
  const auto start = std::chrono::steady_clock::now();
  const std::uint64_t now = signature();
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  next_look_ = time + std::max(kInterval, kRest * took.count());
  looked_ = true;
  return std::exchange(signature_, now) != now;
}

bool FileWatcher::poll(double time) {
  const bool is_due = !looked_ || time >= next_look_;
  bool changed = false;
  if (descriptor_ >= 0) {
    changed = read_events();
    changed |= is_due && follow_root();
    if (!has_all_) stop_watching();  // the limit of watches is reached (fs.inotify.max_user_watches)
  }
  // A change that inotify reported is not reported again. While files change, look at each call for the next change.
  const bool looks = is_due || changed || (pending_ && descriptor_ < 0);
  changed |= looks && compare_files(time);
  if (changed) {
    if (!pending_) first_change_ = time;
    last_change_ = time;
    pending_ = true;
  }
  if (!pending_) return false;
  const bool settled = time - last_change_ >= kQuiet || time - first_change_ >= kPatience;
  if (settled) pending_ = false;
  return settled;
}

}  // namespace reorient
