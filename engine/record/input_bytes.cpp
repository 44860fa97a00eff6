// SPDX-License-Identifier: MIT
#include "engine/record/input_bytes.h"

#include <string_view>

#include "engine/record/image_bytes.h"
#include "geometry/bytes.h"

namespace reorient {
namespace {

constexpr std::uint32_t kInputMagic = 0x364E4952;  // "RIN6": change it with the layout

/// A list that the inputs refer to without owning it.
template <typename Archive, typename T>
void archive_view(Archive& archive, auto& view, std::vector<T>& memory) {
  if constexpr (Archive::kReads) {
    archive(memory);
    view = memory;
  } else {
    archive(static_cast<std::uint32_t>(view.size()));
    for (const T& one : view) archive(one);
  }
}

/// Whether an optional has a value; reading creates the value.
template <typename Archive>
bool archive_presence(Archive& archive, auto& value) {
  bool is_there = value.has_value();
  archive(is_there);
  if constexpr (Archive::kReads) {
    if (is_there && !value) value.emplace();
  }
  return is_there;
}

template <typename Archive>
void archive_camera(Archive& archive, auto& frame, std::vector<std::uint8_t>& own, bool pixels) {
  if (!archive_presence(archive, frame)) return;
  archive(frame->time, frame->camera, frame->odometry, frame->robot_from_camera);
  ImageView none;
  pixels ? archive_image(archive, frame->image, own) : archive_image(archive, none, own);
}

/// An optional part at the end: without percepts, the bytes are those of a program that knows no percepts.
template <typename Archive>
void archive_percepts(Archive& archive, auto& percepts, InputMemory& memory) {
  if constexpr (Archive::kReads) {
    if (archive.left() > 0) percepts.emplace();
  }
  if (!percepts) return;
  archive(percepts->replaces_vision);
  archive_view(archive, percepts->list, memory.percepts);
}

template <typename Archive>
void archive_inputs(Archive& archive, auto& inputs, InputMemory& memory, bool pixels = true) {
  auto& seen = inputs.observation;
  archive(seen.time);
  archive_camera(archive, seen.upper, memory.images[0], pixels);
  archive_camera(archive, seen.lower, memory.images[1], pixels);
  archive(seen.body);
  archive_view(archive, seen.body_samples, memory.body_samples);
  archive(seen.odometry, seen.reported_posture);
  if (archive_presence(archive, seen.belief)) {
    archive(seen.belief->pose, seen.belief->covariance);
    archive_view(archive, seen.belief->particles, memory.particles);
  }
  archive(seen.external, inputs.parameter_changes, inputs.script_edits, inputs.external);
  archive_percepts(archive, seen.percepts, memory);
}

void write(const FrameInputs& inputs, bool pixels, std::vector<std::byte>& bytes) {
  ByteWriter out(bytes);
  out(kInputMagic);
  InputMemory none;
  archive_inputs(out, inputs, none, pixels);
}

}  // namespace

void write_inputs(const FrameInputs& inputs, std::vector<std::byte>& bytes) { write(inputs, true, bytes); }

void write_inputs_without_pixels(const FrameInputs& inputs, std::vector<std::byte>& bytes) {
  write(inputs, false, bytes);
}

StoredInputs::StoredInputs(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  std::uint32_t magic = 0;
  in(magic);
  check_bytes(magic == kInputMagic, "inputs: not written by this version of the program");
  archive_inputs(in, inputs_, memory_);
  in.finish();
}

void StoredInputs::put_pixels(std::size_t camera, const ImageView& image) {
  std::optional<CameraFrame>& frame = camera == 0 ? inputs_.observation.upper : inputs_.observation.lower;
  frame.value().image = image;
}

}  // namespace reorient
