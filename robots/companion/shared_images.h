// SPDX-License-Identifier: MIT
// The images of one camera in memory that a client shares. It can neither be taken from under us, which its seal sees
// to, nor change while we look: an image is copied once, and what was written over meanwhile does not count.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "geometry/image.h"
#include "robots/companion/message.h"
#include "robots/image_formats.h"

namespace reorient {

/// A file descriptor that is closed.
class OwnedDescriptor {
 public:
  explicit OwnedDescriptor(int descriptor = -1) : descriptor_(descriptor) {}
  ~OwnedDescriptor();
  OwnedDescriptor(OwnedDescriptor&& other) noexcept : descriptor_(other.release()) {}
  OwnedDescriptor& operator=(OwnedDescriptor&& other) noexcept;

  int get() const { return descriptor_; }
  explicit operator bool() const { return descriptor_ >= 0; }
  int release();

 private:
  int descriptor_;
};

class SharedImages {
 public:
  /// For images of this camera. Throws BadMessage: what is handed over is not sealed, too small, or no memory at all.
  SharedImages(const OwnedDescriptor& memory, const reorient_memory& layout, const reorient_camera& camera);
  ~SharedImages();
  SharedImages(const SharedImages&) = delete;
  SharedImages& operator=(const SharedImages&) = delete;

  /// Copies the image with this sequence number from a slot that there is. False: the slot holds another one by now.
  bool copy(const reorient_image& which, Image& image) const;

 private:
  const std::byte* base_ = nullptr;
  std::size_t size_;
  std::size_t slot_size_;
  PixelFormat format_;
  std::size_t image_bytes_;
};

}  // namespace reorient
