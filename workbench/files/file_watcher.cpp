// SPDX-License-Identifier: MIT
#include "workbench/files/file_watcher.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <set>
#include <utility>

#include <sys/inotify.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include "engine/script/script_texts.h"

namespace reorient {
namespace {

constexpr std::uint32_t kEvents = IN_MODIFY | IN_CLOSE_WRITE | IN_CREATE | IN_DELETE | IN_MOVED_FROM | IN_MOVED_TO |
                                  IN_DELETE_SELF | IN_MOVE_SELF | IN_ONLYDIR;
constexpr auto kSkip = std::filesystem::directory_options::skip_permission_denied;

/// File systems without events for changes by other computers: NFS, CIFS, SMB, FUSE (sshfs), 9p (a virtual machine's
/// host). Numbers: statfs(2).
bool is_of_another_machine(const std::filesystem::path& folder) {
  struct statfs status {};
  if (statfs(folder.c_str(), &status) != 0) return false;
  constexpr std::array<std::uint32_t, 5> kTypes{0x6969, 0xff534d42, 0xfe534d42, 0x65735546, 0x01021997};
  return std::find(kTypes.begin(), kTypes.end(), static_cast<std::uint32_t>(status.f_type)) != kTypes.end();
}

}  // namespace

FileWatcher::FileWatcher(std::filesystem::path root, Means means) : root_(std::move(root)) {
  if (means == Means::automatic && !is_of_another_machine(root_)) begin_watching();
  if (watched_.empty()) stop_watching();
  signature_ = signature();
}

FileWatcher::~FileWatcher() { stop_watching(); }

/// Compares files from now on.
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

/// The root and all directories below it. Watching one again adds no watch.
void FileWatcher::watch_directories() {
  std::error_code error;
  const auto watch = [this](const std::filesystem::path& directory) {
    const int watch_id = inotify_add_watch(descriptor_, directory.c_str(), kEvents);
    if (watch_id >= 0) watched_[watch_id] = directory;
    has_all_ &= watch_id >= 0 || errno == ENOENT || errno == EACCES;
    return watch_id;
  };
  root_watch_ = watch(root_);
  for (std::filesystem::recursive_directory_iterator entry(root_, kSkip, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code gone;
    if (entry->is_directory(gone)) watch(entry->path());
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
  std::error_code error;
  for (std::filesystem::recursive_directory_iterator entry(root_, kSkip, error), end; !error && entry != end;
       entry.increment(error)) {
    std::error_code gone;
    if (!entry->is_regular_file(gone)) continue;
    const auto time = entry->last_write_time(gone).time_since_epoch().count();
    lines.insert(entry->path().string() + " " + std::to_string(time) + " " + std::to_string(entry->file_size(gone)));
  }
  std::uint64_t hash = 0;
  for (const std::string& line : lines) hash = hash * 31 + content_hash(line);
  return hash;
}

bool FileWatcher::compare_files() {
  const std::uint64_t now = signature();
  return std::exchange(signature_, now) != now;
}

bool FileWatcher::poll(double time) {
  const bool is_due = !looked_ || time >= next_look_;
  bool changed = false;
  if (uses_inotify()) {
    changed = read_events();
    changed |= is_due && follow_root();
    if (!has_all_) stop_watching();  // the limit of watches is reached (fs.inotify.max_user_watches)
  } else if (is_due || pending_) {
    changed = compare_files();
  }
  if (is_due) {
    looked_ = true;
    next_look_ = time + kInterval;
  }
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
