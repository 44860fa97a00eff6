// SPDX-License-Identifier: MIT
#include "robots/nao/guard/shared_body.h"

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <new>
#include <stdexcept>
#include <string>

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

}  // namespace

MappedBody::MappedBody(const std::filesystem::path& file, Side side) {
  const int making = side == Side::guard ? O_CREAT : 0;
  file_ = open(file.c_str(), O_RDWR | O_CLOEXEC | O_NOFOLLOW | making, 0600);
  if (file_ < 0 && side != Side::guard && errno == ENOENT) return;
  const auto give_up = [&](const std::string& why) {
    close_all();
    throw std::runtime_error(file.string() + ": " + why);
  };
  constexpr const char* kOtherVersion = "file of another version of the guard; start the guard of this version";
  if (file_ < 0) give_up(std::strerror(errno));
  struct stat status {};
  if (fstat(file_, &status) != 0 || !S_ISREG(status.st_mode) || status.st_uid != geteuid())
    give_up("expected a guard's file of this user, found another; choose another file");
  constexpr auto kSize = static_cast<off_t>(sizeof(SharedBody));
  if (side == Side::guard) {
    if (flock(file_, LOCK_EX | LOCK_NB) != 0) give_up("another guard controls the body; stop it first");
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
  body_ = side == Side::guard ? new (memory) SharedBody : static_cast<SharedBody*>(memory);
  if (side == Side::guard) {
    body_->layout.store(SharedBody::kLayout, std::memory_order_release);
  } else if (const std::uint64_t layout = body_->layout.load(std::memory_order_acquire); layout == 0) {
    close_all();  // the guard is creating it
  } else if (layout != SharedBody::kLayout) {
    give_up(kOtherVersion);
  }
}

MappedBody::~MappedBody() { close_all(); }

void MappedBody::close_all() {
  if (body_ != nullptr) munmap(body_, sizeof(SharedBody));
  if (file_ >= 0) close(file_);
  body_ = nullptr;
  file_ = -1;
}

}  // namespace reorient::nao
