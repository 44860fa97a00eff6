// SPDX-License-Identifier: MIT
#include "robots/nao/guard/shared_body.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

namespace reorient::nao {

void SharedBody::add(const Measurement& measurement) {
  const std::uint64_t number = measured.load(std::memory_order_relaxed);
  measurements[number % kMeasurements].write(measurement);
  measured.store(number + 1, std::memory_order_release);
}

bool SharedBody::newest(Measurement& measurement) const {
  const std::uint64_t count = measured.load(std::memory_order_acquire);
  return count > 0 && measurements[(count - 1) % kMeasurements].read(measurement);
}

std::uint64_t SharedBody::news(std::uint64_t seen, std::vector<Measurement>& later) const {
  const std::uint64_t count = measured.load(std::memory_order_acquire);
  if (seen > count) seen = 0;  // the guard has restarted
  const std::uint64_t oldest = count < kMeasurements ? 0 : count - kMeasurements;
  for (std::uint64_t i = std::max(seen, oldest); i < count; ++i) {
    Measurement measurement;
    if (!measurements[i % kMeasurements].read(measurement)) continue;
    // The guard may have overwritten it meanwhile: then this is a later measurement, which its own index returns.
    if (!later.empty() && measurement.time <= later.back().time) continue;
    later.push_back(measurement);
  }
  return count;
}

std::filesystem::path default_body_file() { return "/dev/shm/reorient-nao-" + std::to_string(geteuid()); }

namespace {

/// Locks the file for the only engine. The guard uses another type of lock, so the two do not conflict.
bool lock_as_engine(int file) {
  struct flock first_byte {};
  first_byte.l_type = F_WRLCK;
  first_byte.l_whence = SEEK_SET;
  first_byte.l_len = 1;
  return fcntl(file, F_OFD_SETLK, &first_byte) == 0;
}

constexpr auto kSize = static_cast<off_t>(sizeof(SharedBody));

/// Whether a guard wrote this file, perhaps one of another version or one that was killed while it created the file.
bool is_of_a_guard(int file, off_t size) {
  constexpr unsigned kVersionBits = 8;
  std::uint64_t layout = 0;
  if (size == 0) return true;
  if (pread(file, &layout, sizeof(layout), 0) != static_cast<ssize_t>(sizeof(layout))) return false;
  return layout == 0 ? size == kSize : layout >> kVersionBits == SharedBody::kLayout >> kVersionBits;
}

/// Whether the path still leads to the open file: a guard that ends removes its file.
bool is_at(const std::filesystem::path& path, const struct stat& opened) {
  struct stat now {};
  return lstat(path.c_str(), &now) == 0 && now.st_dev == opened.st_dev && now.st_ino == opened.st_ino;
}

/// The mappings of this process, for the handler of SIGBUS.
struct KnownMapping {
  std::atomic<char*> begin = nullptr;
  std::atomic<int> file = -1;
};
std::array<KnownMapping, 8> known_mappings;
std::atomic<int> unexplained = 0;

/// Access to a page beyond the end of a truncated file raises SIGBUS. Extends the file again, so that the access is
/// repeated and finds zeros. Any other SIGBUS ends the process as usual. Only async-signal-safe calls.
void extend_truncated_file(int /*signal*/, siginfo_t* info, void* /*context*/) {
  const int error = errno;
  const char* const place = static_cast<const char*>(info->si_addr);
  for (const KnownMapping& mapping : known_mappings) {
    const char* const begin = mapping.begin;
    if (begin == nullptr || place < begin || place >= begin + sizeof(SharedBody)) continue;
    struct stat status {};
    if (fstat(mapping.file, &status) != 0) break;
    // Another process that maps the file may have extended it at the same time. A full disk looks the same.
    constexpr int kMostRaces = 100;
    const bool is_extended = status.st_size >= kSize ? ++unexplained < kMostRaces : ftruncate(mapping.file, kSize) == 0;
    errno = error;
    if (is_extended) return;
    break;
  }
  signal(SIGBUS, SIG_DFL);
  raise(SIGBUS);  // delivered when this handler returns
}

void survive_truncation(SharedBody* body, int file) {
  for (KnownMapping& mapping : known_mappings) {
    char* none = nullptr;
    if (!mapping.begin.compare_exchange_strong(none, reinterpret_cast<char*>(body))) continue;
    mapping.file = file;
    break;
  }
  struct sigaction action {};
  action.sa_sigaction = extend_truncated_file;
  action.sa_flags = SA_SIGINFO;
  sigaction(SIGBUS, &action, nullptr);
}

void forget_mapping(SharedBody* body) {
  for (KnownMapping& mapping : known_mappings) {
    char* begin = reinterpret_cast<char*>(body);
    mapping.begin.compare_exchange_strong(begin, nullptr);
  }
}

}  // namespace

MappedBody::MappedBody(const std::filesystem::path& file, Side side) : path_(file), side_(side) {
  const auto give_up = [&](const std::string& why) {
    close_all();
    throw std::runtime_error(file.string() + ": " + why);
  };
  constexpr const char* kOtherVersion = "file of another version of the guard; start the guard of this version";
  const int making = side == Side::guard ? O_CREAT : 0;
  struct stat status {};
  while (true) {
    file_ = open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | making, 0600);
    if (file_ < 0 && side != Side::guard && errno == ENOENT) return;
    if (file_ < 0) give_up(std::strerror(errno));
    if (fstat(file_, &status) != 0 || !S_ISREG(status.st_mode) || status.st_uid != geteuid())
      give_up("expected a guard's file of this user, found another; choose another file");
    if ((status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
      give_up("expected a file that only its user may write, found one that others may write; remove it");
    if (side != Side::guard) break;
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) give_up("another guard controls the body; stop it first");
    if (is_at(file, status)) break;
    close(std::exchange(file_, -1));  // a guard that was ending has removed it meanwhile
  }
  if (side == Side::guard) {
    if (!is_of_a_guard(file_, status.st_size))
      give_up("expected a guard's file or no file, found another file; choose another file");
    if (status.st_size != kSize && ftruncate(file_, kSize) != 0) give_up(std::strerror(errno));
  } else if (status.st_size == 0) {
    close_all();  // the guard is creating it
    return;
  } else if (status.st_size != kSize) {
    give_up(kOtherVersion);
  } else if (side == Side::engine && !lock_as_engine(file_)) {
    give_up("another program uses this guard; stop it first, for example: systemctl --user stop reorient");
  }
  void* const memory = mmap(nullptr, sizeof(SharedBody), PROT_READ | PROT_WRITE, MAP_SHARED, file_, 0);
  if (memory == MAP_FAILED) give_up(std::strerror(errno));
  survive_truncation(static_cast<SharedBody*>(memory), file_);
  body_ = side == Side::guard ? new (memory) SharedBody : static_cast<SharedBody*>(memory);
  if (side == Side::guard) {
    body_->layout.store(SharedBody::kLayout, std::memory_order_release);
  } else if (const std::uint64_t layout = body_->layout.load(std::memory_order_acquire); layout == 0) {
    close_all();  // the guard is creating it
  } else if (layout != SharedBody::kLayout) {
    give_up(kOtherVersion);
  }
}

MappedBody::~MappedBody() {
  struct stat status {};
  if (side_ == Side::guard && body_ != nullptr && fstat(file_, &status) == 0 && is_at(path_, status))
    unlink(path_.c_str());
  close_all();
}

bool MappedBody::restore() {
  struct stat status {};
  const bool is_short = fstat(file_, &status) == 0 && status.st_size < kSize;
  if (!is_short && body_->layout.load(std::memory_order_relaxed) == SharedBody::kLayout) return false;
  if (is_short && ftruncate(file_, kSize) != 0) return false;
  body_->layout.store(SharedBody::kLayout, std::memory_order_release);
  return true;
}

void MappedBody::close_all() {
  if (body_ != nullptr) {
    forget_mapping(body_);
    munmap(body_, sizeof(SharedBody));
  }
  if (file_ >= 0) close(file_);
  body_ = nullptr;
  file_ = -1;
}

}  // namespace reorient::nao
