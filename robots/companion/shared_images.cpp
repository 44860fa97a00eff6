// SPDX-License-Identifier: MIT
#include "robots/companion/shared_images.h"

#include <atomic>
#include <utility>

#include <fcntl.h>
#include <linux/magic.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

// The thread sanitizer does not support fences. The fence below is between two processes.
#ifdef __SANITIZE_THREAD__
#pragma GCC diagnostic ignored "-Wtsan"
#endif

namespace reorient {
namespace {

/// Format of a camera whose image size is not 0, so that its format is known.
PixelFormat format_of(const reorient_camera& camera) {
  switch (camera.format) {
    case REORIENT_YUYV:
      return PixelFormat::yuyv;
    case REORIENT_NV12:
      return PixelFormat::nv12;
    case REORIENT_RGB:
      return PixelFormat::rgb;
    case REORIENT_BGR:
      return PixelFormat::bgr;
    default:
      return PixelFormat::gray;
  }
}

}  // namespace

OwnedDescriptor::~OwnedDescriptor() {
  if (descriptor_ >= 0) close(descriptor_);
}

OwnedDescriptor& OwnedDescriptor::operator=(OwnedDescriptor&& other) noexcept {
  if (this != &other) {
    if (descriptor_ >= 0) close(descriptor_);
    descriptor_ = other.release();
  }
  return *this;
}

int OwnedDescriptor::release() { return std::exchange(descriptor_, -1); }

SharedImages::SharedImages(const OwnedDescriptor& memory, const reorient_memory& layout, const reorient_camera& camera)
    : size_(std::size_t{REORIENT_SLOTS} * layout.slot_size),
      slot_size_(layout.slot_size),
      format_(format_of(camera)),
      image_bytes_(reorient_image_bytes(&camera)) {
  constexpr std::size_t kAligned = 64;
  if (image_bytes_ == 0) throw BadMessage("memory: the hello does not describe this camera");
  const std::size_t least = (REORIENT_SLOT_HEADER + image_bytes_ + kAligned - 1) / kAligned * kAligned;
  constexpr std::size_t kMost = REORIENT_SLOT_HEADER + std::size_t{REORIENT_LARGEST_IMAGE};
  if (slot_size_ % kAligned != 0 || slot_size_ < REORIENT_SLOT_HEADER + image_bytes_ || slot_size_ > kMost)
    throw BadMessage("memory: slot_size " + std::to_string(slot_size_) + " (expected a multiple of 64, at least " +
                     std::to_string(least) + ": header of 64 bytes and image of " + std::to_string(image_bytes_) +
                     " bytes; at most " + std::to_string(kMost) + ")");
  const int seals = fcntl(memory.get(), F_GET_SEALS);
  if (seals < 0 || (seals & F_SEAL_SHRINK) == 0)
    throw BadMessage("memory: expected a memfd with F_SEAL_SHRINK, found another file descriptor or no seal");
  // A memfd of huge pages has the seal, too, but reading a hole in it is a bus error if no huge page is free.
  struct statfs system {};
  if (fstatfs(memory.get(), &system) != 0 || system.f_type != TMPFS_MAGIC)
    throw BadMessage("memory: expected a memfd of ordinary pages, found huge pages or another file system");
  struct stat status {};
  if (fstat(memory.get(), &status) != 0 || status.st_size < static_cast<off_t>(size_))
    throw BadMessage("memory: smaller than its slots (expected at least " + std::to_string(size_) + " bytes)");
  void* const base = mmap(nullptr, size_, PROT_READ, MAP_SHARED, memory.get(), 0);
  if (base == MAP_FAILED) throw BadMessage("memory: mmap failed");
  base_ = static_cast<const std::byte*>(base);
}

SharedImages::~SharedImages() { munmap(const_cast<std::byte*>(base_), size_); }

bool SharedImages::copy(const reorient_image& which, Image& image) const {
  const std::byte* const slot = base_ + which.slot * slot_size_;
  const auto* const sequence = reinterpret_cast<const std::uint64_t*>(slot);
  if (which.sequence % 2 != 0 || __atomic_load_n(sequence, __ATOMIC_ACQUIRE) != which.sequence) return false;
  convert_image({reinterpret_cast<const std::uint8_t*>(slot + REORIENT_SLOT_HEADER), image_bytes_}, format_, image);
  std::atomic_thread_fence(std::memory_order_acquire);
  return __atomic_load_n(sequence, __ATOMIC_RELAXED) == which.sequence;
}

}  // namespace reorient
