// SPDX-License-Identifier: MIT
// A frame's inputs as bytes, and back: with them and the state before, anybody can make the same frame again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/frame_inputs.h"

namespace reorient {

/// Appends all of it, pixels included.
void write_inputs(const FrameInputs& inputs, std::vector<std::byte>& bytes);
/// The same, for whoever keeps the pixels elsewhere.
void write_inputs_without_pixels(const FrameInputs& inputs, std::vector<std::byte>& bytes);

/// What inputs see through views, where they are read from bytes.
struct InputMemory {
  std::array<std::vector<std::uint8_t>, 2> images;  ///< of the upper and of the lower camera
  std::vector<BodySample> body_samples;
  std::vector<ExternalBelief::Particle> particles;
};

/// Inputs with memory of their own.
class StoredInputs {
 public:
  /// Throws BadBytes where the bytes are none, or of another version.
  explicit StoredInputs(std::span<const std::byte> bytes);
  StoredInputs(const StoredInputs&) = delete;
  StoredInputs& operator=(const StoredInputs&) = delete;

  const FrameInputs& inputs() const { return inputs_; }

  /// Of the upper (0) or lower (1) camera, where the bytes were written without; there has to be a frame of it. The
  /// image must outlive this.
  void put_pixels(std::size_t camera, const ImageView& image);

 private:
  FrameInputs inputs_;
  InputMemory memory_;
};

}  // namespace reorient
