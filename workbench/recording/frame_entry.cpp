// SPDX-License-Identifier: MIT
#include "workbench/recording/frame_entry.h"

#include <algorithm>
#include <cmath>

#include "engine/record/digest.h"
#include "engine/record/record_bytes.h"
#include "geometry/bytes.h"

namespace reorient {
namespace {

constexpr std::size_t kDigests =
    std::count_if(kTopics.begin(), kTopics.end(), [](const TopicInfo& row) { return row.always && row.reproducible; });

constexpr std::uint32_t kFrameMagic = 0x314D4652;  // "RFM1": change it with the layout

template <typename Archive>
void archive_message(Archive& archive, auto& message) {
  archive(message.frame, message.time, message.sides_changed, message.has_image, message.image_is_exact, message.inputs,
          message.digests, message.record, message.scene);
}

}  // namespace

void digest_topics(std::span<const std::byte> bytes, std::span<const std::size_t> places, TopicDigests& digests) {
  digests.clear();
  for (std::size_t i = 1; i < places.size(); ++i) {
    Digest digest;
    digest.add(bytes.subspan(places[i - 1], places[i] - places[i - 1]));
    digests.push_back(digest.value());
  }
}

void take_frame(const FrameRecord& frame, const SceneTruth& scene, FrameEntry& entry,
                std::vector<std::size_t>& places) {
  entry.frame = frame.world.frame;
  entry.time = frame.world.time;
  entry.sides_changed = frame.world.sides_changed;
  entry.record.clear();
  write_record(frame, entry.record, digested_topics(), &places);
  entry.scene = scene;
}

std::uint64_t nanoseconds(double seconds) {
  constexpr double kMost = 9e9;  // s
  return seconds > 0.0 && seconds < kMost ? static_cast<std::uint64_t>(std::llround(1e9 * seconds)) : 0;
}

void write_frame_entry(const FrameEntry& message, std::vector<std::byte>& bytes) {
  ByteWriter out(bytes);
  out(kFrameMagic);
  archive_message(out, message);
}

void read_frame_entry(std::span<const std::byte> bytes, FrameEntry& message) {
  ByteReader in(bytes);
  std::uint32_t magic = 0;
  in(magic);
  check_bytes(magic == kFrameMagic, "a frame has the format of another version of the program");
  archive_message(in, message);
  in.finish();
  check_bytes(message.digests.size() == kDigests, "a frame has the format of another version of the program");
}

}  // namespace reorient
