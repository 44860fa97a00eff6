// SPDX-License-Identifier: MIT
// A frame's inputs as bytes, and back: with them and the state before the frame, the frame can be computed again.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/frame_inputs.h"

namespace reorient {

/// Appends all inputs including pixels.
void write_inputs(const FrameInputs& inputs, std::vector<std::byte>& bytes);
/// The same for callers that store the pixels separately.
void write_inputs_without_pixels(const FrameInputs& inputs, std::vector<std::byte>& bytes);

/// Memory to which inputs refer after they were read from bytes.
struct InputMemory {
  std::array<std::vector<std::uint8_t>, 2> images;  ///< of the upper and of the lower camera
  std::vector<BodySample> body_samples;
  std::vector<ExternalBelief::Particle> particles;
  std::vector<ExternalPercept> percepts;
};

/// Inputs with memory of their own.
class StoredInputs {
 public:
  /// Throws BadBytes if the bytes are invalid or of another version.
  explicit StoredInputs(std::span<const std::byte> bytes);
  StoredInputs(const StoredInputs&) = delete;
  StoredInputs& operator=(const StoredInputs&) = delete;

  const FrameInputs& inputs() const { return inputs_; }

  /// Sets the pixels of the upper (0) or lower (1) camera if the bytes have none; the camera must have a frame. The
  /// image must outlive this.
  void put_pixels(std::size_t camera, const ImageView& image);

 private:
  FrameInputs inputs_;
  InputMemory memory_;
};

}  // namespace reorient
