// SPDX-License-Identifier: MIT
// The images of one camera in memory that a client shares. The seal prevents the client from shrinking the memory. An
// image is copied once; a copy that the client overwrote meanwhile is dropped.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "geometry/image.h"
#include "robots/companion/message.h"
#include "robots/image_formats.h"

namespace reorient {

/// A file descriptor that is closed by the destructor.
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
  /// Maps the memory for images of this camera. Throws BadMessage if the descriptor is not a sealed memfd of sufficient
  /// size.
  SharedImages(const OwnedDescriptor& memory, const reorient_memory& layout, const reorient_camera& camera);
  ~SharedImages();
  SharedImages(const SharedImages&) = delete;
  SharedImages& operator=(const SharedImages&) = delete;

  /// Copies the image with this sequence number from an existing slot. Returns false if it was overwritten.
  bool copy(const reorient_image& which, Image& image) const;

 private:
  const std::byte* base_ = nullptr;
  std::size_t size_;
  std::size_t slot_size_;
  PixelFormat format_;
  std::size_t image_bytes_;
};

}  // namespace reorient
