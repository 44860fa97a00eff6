#include "engine/record/input_bytes.h"

#include <string_view>

#include "engine/record/image_bytes.h"
#include "geometry/bytes.h"

namespace reorient {
namespace {

constexpr std::uint32_t kInputMagic = 0x354E4952;  // "RIN5": another layout gets another number

/// Where what is seen through a view is kept while it is read; a writer leaves it empty.
struct Memory {
  std::array<std::vector<std::uint8_t>, 2>& images;
  std::vector<BodySample>& body_samples;
  std::vector<ExternalBelief::Particle>& particles;
};

/// A list that the inputs only look at.
template <typename Archive, typename T>
void archive_view(Archive& archive, std::span<const T>& view, std::vector<T>& memory) {
  if constexpr (Archive::kReads) {
    archive(memory);
    view = memory;
  } else {
    archive(static_cast<std::uint32_t>(view.size()));
    for (const T& one : view) archive(one);
  }
}

template <typename Archive>
void archive_camera(Archive& archive, std::optional<CameraFrame>& frame, std::vector<std::uint8_t>& own, bool pixels) {
  bool is_there = frame.has_value();
  archive(is_there);
  if (!is_there) return;
  if (!frame) frame.emplace();
  archive(frame->time, frame->camera, frame->odometry, frame->robot_from_camera);
  ImageView none;
  archive_image(archive, pixels ? frame->image : none, own);
}

template <typename Archive>
void archive_belief(Archive& archive, std::optional<ExternalBelief>& belief,
                    std::vector<ExternalBelief::Particle>& memory) {
  bool is_there = belief.has_value();
  archive(is_there);
  if (!is_there) return;
  if (!belief) belief.emplace();
  archive(belief->pose, belief->covariance);
  archive_view(archive, belief->particles, memory);
}

template <typename Archive>
void archive_inputs(Archive& archive, FrameInputs& inputs, const Memory& memory, bool pixels = true) {
  Observation& seen = inputs.observation;
  archive(seen.time);
  archive_camera(archive, seen.upper, memory.images[0], pixels);
  archive_camera(archive, seen.lower, memory.images[1], pixels);
  archive(seen.body);
  archive_view(archive, seen.body_samples, memory.body_samples);
  archive(seen.odometry, seen.reported_posture);
  archive_belief(archive, seen.belief, memory.particles);
  archive(seen.told, inputs.parameter_changes, inputs.script_edits, inputs.told);
}

void write(const FrameInputs& inputs, bool pixels, std::vector<std::byte>& bytes) {
  ByteWriter out(bytes);
  out(kInputMagic);
  std::array<std::vector<std::uint8_t>, 2> no_images;
  std::vector<BodySample> no_samples;
  std::vector<ExternalBelief::Particle> no_particles;
  archive_inputs(out, const_cast<FrameInputs&>(inputs), {no_images, no_samples, no_particles},
                 pixels);  // a writer only looks
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
  check_bytes(magic == kInputMagic, "these are no inputs of this version of the program");
  archive_inputs(in, inputs_, {images_, body_samples_, particles_});
  in.finish();
}

void StoredInputs::put_pixels(std::size_t camera, const ImageView& image) {
  std::optional<CameraFrame>& frame = camera == 0 ? inputs_.observation.upper : inputs_.observation.lower;
  frame.value().image = image;
}

}  // namespace reorient
