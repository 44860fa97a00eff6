// SPDX-License-Identifier: MIT
#include "workbench/files/atomic_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <exception>
#include <mutex>
#include <set>
#include <span>
#include <stdexcept>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/script/script_texts.h"
#include "workbench/files/write_all.h"

namespace reorient {
namespace {

[[noreturn]] void fail() { throw std::system_error(errno, std::generic_category()); }

/// A file that is open for writing. Throws std::system_error if a call fails.
class OpenFile {
 public:
  OpenFile(const std::filesystem::path& file, int flags) : descriptor_(open(file.c_str(), flags | O_CLOEXEC, 0666)) {
    if (descriptor_ < 0) fail();
  }
  ~OpenFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
  }
  OpenFile(const OpenFile&) = delete;
  OpenFile& operator=(const OpenFile&) = delete;

  void write(std::string_view bytes) const {
    if (!write_all(descriptor_, std::as_bytes(std::span(bytes)))) fail();
  }
  void set_mode(mode_t mode) const { fchmod(descriptor_, mode); }
  /// Flushes to the disk: otherwise a power cut after the rename leaves an empty file.
  void sync() const {
    if (fsync(descriptor_) != 0 && errno != EINVAL && errno != EROFS) fail();
  }
  void close() {
    if (::close(std::exchange(descriptor_, -1)) != 0 && errno != EINTR) fail();
  }

 private:
  int descriptor_;
};

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : ".";
}

/// Flushes the folder entry, too. Some file systems do not support it.
void sync_folder_of(const std::filesystem::path& file) {
  const int descriptor = open(folder_of(file).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return;
  static_cast<void>(fsync(descriptor));
  ::close(descriptor);
}

/// Identity of the system in which a process number is unique: a folder may be shared with another computer or
/// container.
const std::string& this_system() {
  static const std::string system = [] {
    std::array<char, 256> name{};  // of the host; at most 64 bytes on Linux
    gethostname(name.data(), name.size() - 1);
    std::error_code error;
    const std::string processes = std::filesystem::read_symlink("/proc/self/ns/pid", error).string();
    return std::to_string(content_hash(name.data() + processes) % 1'000'000'000);
  }();
  return system;
}

/// The process that writes a temporary file of this name; nothing: another name, or a process of another system.
std::optional<pid_t> writer_of(std::string_view name) {
  // FILE.SYSTEM-PROCESS-NUMBER.partial
  constexpr std::string_view kEnd = ".partial";
  if (!name.ends_with(kEnd)) return std::nullopt;
  name.remove_suffix(kEnd.size());
  name.remove_prefix(std::min(name.size(), name.rfind('.')));
  const std::string begin = "." + this_system() + "-";
  if (!name.starts_with(begin)) return std::nullopt;
  pid_t process = 0;
  const auto [end, error] = std::from_chars(name.data() + begin.size(), name.data() + name.size(), process);
  const bool is_ours = error == std::errc() && process > 0 && end != name.data() + name.size() && *end == '-';
  return is_ours ? std::optional(process) : std::nullopt;
}

/// Removes the temporary files of processes that were killed: once for each folder, because it may be large.
void remove_abandoned_files_of(const std::filesystem::path& folder) {
  static std::mutex mutex;
  static std::set<std::filesystem::path> cleaned;
  {
    const std::lock_guard lock(mutex);
    if (!cleaned.insert(folder).second) return;
  }
  std::error_code error;
  for (std::filesystem::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::optional<pid_t> writer = writer_of(entry->path().filename().native());
    std::error_code gone;
    if (!writer || entry->symlink_status(gone).type() != std::filesystem::file_type::regular) continue;
    if (kill(*writer, 0) != 0 && errno == ESRCH) unlink(entry->path().c_str());
  }
}

/// A name that no other process and no other call uses.
std::filesystem::path fresh_name_beside(const std::filesystem::path& file) {
  static std::atomic<unsigned> count{0};
  remove_abandoned_files_of(folder_of(file));
  std::filesystem::path name = file;
  do {
    name = file;
    name += "." + this_system() + "-" + std::to_string(getpid()) + "-" + std::to_string(count++) + ".partial";
  } while (std::filesystem::exists(std::filesystem::symlink_status(name)));
  return name;
}

/// A new file beside `file`, removed at the end unless it was renamed to `file`.
class FileBeside {
 public:
  explicit FileBeside(const std::filesystem::path& file) : name_(fresh_name_beside(file)), open_(name_, kNew) {}
  ~FileBeside() {
    if (!kept_) unlink(name_.c_str());
  }
  FileBeside(const FileBeside&) = delete;
  FileBeside& operator=(const FileBeside&) = delete;

  OpenFile& open() { return open_; }
  void rename_to(const std::filesystem::path& file) {
    if (rename(name_.c_str(), file.c_str()) != 0) fail();
    kept_ = true;
    sync_folder_of(file);
  }

 private:
  /// O_EXCL: never write to something that exists there, such as a link to elsewhere.
  static constexpr int kNew = O_WRONLY | O_CREAT | O_EXCL;

  std::filesystem::path name_;
  OpenFile open_;
  bool kept_ = false;
};

/// The target of a chain of links, because a rename would replace the link. A missing file is its own target.
std::filesystem::path behind_links(const std::filesystem::path& file) {
  std::error_code error;
  if (!std::filesystem::is_symlink(file, error)) return file;
  std::filesystem::path target = std::filesystem::canonical(file, error);
  return error ? file : target;
}

/// Whether it is a device or a pipe, which a rename would replace.
bool is_special(const std::filesystem::path& file) {
  std::error_code error;
  const std::filesystem::file_status status = std::filesystem::status(file, error);
  return std::filesystem::is_other(status);
}

/// Why a file of this name cannot be created; nothing: it can. Leaves no file behind.
std::optional<std::string> why_not_writable(const std::filesystem::path& file) {
  try {
    const std::filesystem::path target = behind_links(file);
    if (is_special(target)) {
      const OpenFile device(target, O_WRONLY | O_NONBLOCK);
    } else {
      FileBeside(target).open().write("x");
    }
    return std::nullopt;
  } catch (const std::system_error& error) {
    return error.code().message();
  }
}

}  // namespace

void write_whole_file(const std::filesystem::path& file, std::string_view bytes) {
  try {
    const std::filesystem::path target = behind_links(file);
    if (is_special(target)) {
      OpenFile device(target, O_WRONLY);
      device.write(bytes);
      device.close();
      return;
    }
    FileBeside partial(target);
    struct stat before {};
    if (stat(target.c_str(), &before) == 0) partial.open().set_mode(before.st_mode & 07777U);
    partial.open().write(bytes);
    partial.open().sync();
    partial.open().close();
    partial.rename_to(target);
  } catch (const std::system_error& error) {
    throw std::runtime_error("cannot write '" + file.string() + "': " + error.code().message());
  }
}

FileInTheMaking::FileInTheMaking(std::filesystem::path file)
    : file_(std::move(file)), target_(behind_links(file_)), path_(target_) {
  if (is_special(target_)) return;
  path_ = fresh_name_beside(target_);
  try {
    const OpenFile made(path_, O_WRONLY | O_CREAT | O_EXCL);
    struct stat before {};
    if (stat(target_.c_str(), &before) == 0) made.set_mode(before.st_mode & 07777U);
  } catch (const std::system_error& error) {
    throw std::runtime_error("cannot write '" + file_.string() + "': " + error.code().message());
  }
}

FileInTheMaking::~FileInTheMaking() {
  if (!is_ended_ && path_ != target_) unlink(path_.c_str());
}

void FileInTheMaking::end() {
  if (path_ == target_) return;
  try {
    OpenFile written(path_, O_WRONLY);
    written.sync();
    written.close();
    if (rename(path_.c_str(), target_.c_str()) != 0) fail();
  } catch (const std::system_error& error) {
    throw std::runtime_error("cannot write '" + file_.string() + "': " + error.code().message());
  }
  is_ended_ = true;
  sync_folder_of(target_);
}

void try_to_write(std::vector<std::string>& failures, const std::function<void()>& write) {
  try {
    write();
  } catch (const std::exception& error) {
    failures.emplace_back(error.what());
  }
}

void require_writable_file(const std::filesystem::path& file, std::string_view option) {
  std::error_code failed;
  const bool is_folder = std::filesystem::is_directory(file, failed);
  const std::optional<std::string> reason = is_folder ? "expected a file, found a folder" : why_not_writable(file);
  if (!reason) return;
  throw std::runtime_error("cannot write '" + file.string() + "': " + *reason + "; name another file with " +
                           std::string(option));
}

void require_writable_folder(const std::filesystem::path& folder, std::string_view option) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  const std::optional<std::string> reason = failed ? failed.message() : why_not_writable(folder / ".reorient-probe");
  if (!reason) return;
  throw std::runtime_error("cannot write into '" + folder.string() + "': " + *reason + "; name another folder with " +
                           std::string(option));
}

}  // namespace reorient
