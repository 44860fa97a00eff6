// SPDX-License-Identifier: MIT
// What a recording holds of one frame so that it can be made again exactly, and what came of it to compare with.
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

// Topics of a recording that decide. Their messages are bytes of our own (geometry/bytes.h) behind their number, which
// is how ROS 1 writes an array of bytes: viewers can open them, though there is nothing to see.
inline constexpr std::string_view kFrameTopic = "/reorient/frame";
inline constexpr std::string_view kStateTopic = "/reorient/state";
inline constexpr std::array<std::string_view, 2> kImageTopics{"/reorient/image/upper", "/reorient/image/lower"};
inline constexpr std::string_view kOwnEncoding = "ros1";
inline constexpr std::string_view kOwnSchema = "reorient/Bytes";
inline constexpr std::string_view kOwnSchemaEncoding = "ros1msg";
inline constexpr std::string_view kOwnSchemaText = "uint8[] data\n";

/// Of what these topics hold. It changes with what their bytes mean (the magic numbers of a frame's entry, its inputs,
/// its record and the engine's state tell it, too): frames of another format cannot be replayed, only viewed.
inline constexpr int kRecordingFormat = 9;

/// A topic that decides nothing.
struct ViewTopic {
  std::string name, encoding;
  std::string schema, schema_encoding, schema_text;  ///< schema: empty: no schema
  bool lasts = false;  ///< a message is valid until the next one: a reader that starts in between needs it
};

// Metadata of such a topic, and of the file, for readers.
inline constexpr std::string_view kLasts = "lasts", kFormat = "format";

/// A message to look at.
struct ViewMessage {
  std::size_t topic = 0;   ///< index in a list of the writer
  std::uint64_t time = 0;  ///< ns
  std::vector<std::byte> data;
};

/// One 64-bit fingerprint for each topic that is the same for the same inputs, in the topics' order.
using TopicDigests = std::vector<std::uint64_t>;
/// The topics that they are of.
constexpr Topics digested_topics() {
  Topics topics;
  for (const TopicInfo& row : kTopics) {
    if (row.always && row.reproducible) topics = topics | Topics{row.topic};
  }
  return topics;
}
/// Of a record as write_record() has written them into `bytes`, with their places.
void digest_topics(std::span<const std::byte> bytes, std::span<const std::size_t> places, TopicDigests& digests);

struct FrameEntry {
  std::uint64_t frame = 0;               ///< World::frame after it
  double time = 0.0;                     ///< s, of the robot
  bool sides_changed = false;            ///< then the stage's poses are turned against the hall's axes
  std::array<bool, 2> has_image{};       ///< the upper and the lower camera gave one
  std::array<bool, 2> image_is_exact{};  ///< and it is in the recording
  std::vector<std::byte> inputs;         ///< write_inputs_without_pixels()
  TopicDigests digests;
  std::vector<std::byte> record;  ///< write_record() of the digested topics
  SceneTruth scene;

  /// It can be made again, if the frame before it can.
  bool is_exact() const { return (!has_image[0] || image_is_exact[0]) && (!has_image[1] || image_is_exact[1]); }
};

/// As MCAP counts time, ns; what is no time, or before the robot was switched on, is 0.
std::uint64_t nanoseconds(double seconds);

void write_frame_entry(const FrameEntry& message, std::vector<std::byte>& bytes);
/// Throws BadBytes: they are none, or of another version.
void read_frame_entry(std::span<const std::byte> bytes, FrameEntry& message);

}  // namespace reorient
