// SPDX-License-Identifier: MIT
// The data of one frame in a recording: its inputs, with which it can be replayed exactly, and its record for
// comparison.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/record/frame_record.h"
#include "workbench/run/observer.h"

namespace reorient {

// Topics that replay needs. Their messages are our own bytes (geometry/bytes.h) after their number, which is how ROS 1
// writes an array of bytes. So viewers can open them, although they do not show anything.
inline constexpr std::string_view kFrameTopic = "/reorient/frame";
inline constexpr std::string_view kStateTopic = "/reorient/state";
inline constexpr std::array<std::string_view, 2> kImageTopics{"/reorient/image/upper", "/reorient/image/lower"};
inline constexpr std::string_view kOwnEncoding = "ros1";
inline constexpr std::string_view kOwnSchema = "reorient/Bytes";
inline constexpr std::string_view kOwnSchemaEncoding = "ros1msg";
inline constexpr std::string_view kOwnSchemaText = "uint8[] data\n";

/// Format of these topics. It changes with the meaning of their bytes, as do the magic numbers of a frame's entry, its
/// inputs, its record and the engine's state. Frames of another format cannot be replayed, only viewed.
inline constexpr int kRecordingFormat = 12;

/// A topic for viewers, which replay does not use.
struct ViewTopic {
  std::string name, encoding;
  std::string schema, schema_encoding, schema_text;  ///< empty schema: no schema
  bool lasts = false;  ///< a message is valid until the next one, so a reader that starts in between needs it
};

// Keys of the metadata of such a topic, and of the file, for readers.
inline constexpr std::string_view kLasts = "lasts", kFormat = "format";

/// A message for viewers.
struct ViewMessage {
  std::size_t topic = 0;   ///< index in a list of the writer
  std::uint64_t time = 0;  ///< ns
  std::vector<std::byte> data;
};

/// 64-bit fingerprints of the topics that depend only on the inputs, in the order of the topics.
using TopicDigests = std::vector<std::uint64_t>;
/// The topics with a fingerprint.
constexpr Topics digested_topics() {
  Topics topics;
  for (const TopicInfo& row : kTopics) {
    if (row.always && row.reproducible) topics = topics | Topics{row.topic};
  }
  return topics;
}
/// Computes the fingerprints of the topics that write_record() has written into `bytes`, at these positions.
void digest_topics(std::span<const std::byte> bytes, std::span<const std::size_t> places, TopicDigests& digests);

struct FrameEntry {
  std::uint64_t frame = 0;               ///< World::frame after it
  double time = 0.0;                     ///< s, of the robot
  bool sides_changed = false;            ///< then the stage's poses are rotated by 180 degrees against the hall's axes
  std::array<bool, 2> has_image{};       ///< the upper and the lower camera provided an image
  std::array<bool, 2> image_is_exact{};  ///< the recording contains its exact pixels
  std::vector<std::byte> inputs;         ///< write_inputs_without_pixels()
  TopicDigests digests;
  std::vector<std::byte> record;  ///< write_record() of the digested topics
  SceneTruth scene;

  /// The frame can be replayed exactly if the previous one can.
  bool is_exact() const { return (!has_image[0] || image_is_exact[0]) && (!has_image[1] || image_is_exact[1]); }
};

/// Fills the parts that come from the frame's record, and the positions of the topics in `entry.record`; not the
/// digests, which take longer. Reuses the memory of both.
void take_frame(const FrameRecord& frame, const SceneTruth& scene, FrameEntry& entry, std::vector<std::size_t>& places);

/// Time in ns, as in MCAP. Invalid and negative times give 0.
std::uint64_t nanoseconds(double seconds);

void write_frame_entry(const FrameEntry& message, std::vector<std::byte>& bytes);
/// Throws BadBytes if the bytes are invalid or of another version.
void read_frame_entry(std::span<const std::byte> bytes, FrameEntry& message);

}  // namespace reorient
