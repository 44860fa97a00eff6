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

// It does not see fences. The one below is between two processes, of which it sees one.
#ifdef __SANITIZE_THREAD__
#pragma GCC diagnostic ignored "-Wtsan"
#endif

namespace reorient {
namespace {

/// Of a camera whose image size is not 0, so that its format is known.
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
  if (image_bytes_ == 0) throw BadMessage("memory for a camera that the hello does not have");
  if (slot_size_ % kAligned != 0 || slot_size_ < REORIENT_SLOT_HEADER + image_bytes_ ||
      slot_size_ > REORIENT_SLOT_HEADER + std::size_t{REORIENT_LARGEST_IMAGE})
    throw BadMessage("slots of " + std::to_string(slot_size_) + " bytes do not fit images of " +
                     std::to_string(image_bytes_));
  const int seals = fcntl(memory.get(), F_GET_SEALS);
  if (seals < 0 || (seals & F_SEAL_SHRINK) == 0)
    throw BadMessage("the memory for images is no memfd, or has no F_SEAL_SHRINK");
  // One of huge pages has the seal as well, and where there are no more of them, to read a hole in it is a bus error.
  struct statfs system {};
  if (fstatfs(memory.get(), &system) != 0 || system.f_type != TMPFS_MAGIC)
    throw BadMessage("the memory for images is no memfd of ordinary pages");
  struct stat status {};
  if (fstat(memory.get(), &status) != 0 || status.st_size < static_cast<off_t>(size_))
    throw BadMessage("the memory for images is smaller than its slots");
  void* const base = mmap(nullptr, size_, PROT_READ, MAP_SHARED, memory.get(), 0);
  if (base == MAP_FAILED) throw BadMessage("the memory for images cannot be mapped");
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
