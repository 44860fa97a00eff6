// SPDX-License-Identifier: MIT
// Arbitrary bytes as a recording and as the content of a recording: damage is reported with its position, the rest is
// read, and neither needs more memory than the bytes justify.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <vector>

#include "engine/record/input_bytes.h"
#include "engine/record/record_bytes.h"
#include "geometry/bytes.h"
#include "tests/fuzz/promises.h"
#include "workbench/recording/packed_image.h"
#include "workbench/recording/recording.h"

namespace reorient {
namespace {

void try_file(std::span<const std::byte> bytes) {
  const mcap::MemorySource source(bytes);
  try {
    const mcap::Contents contents = mcap::read_contents(source);
    require(contents.is_complete || contents.damage, "a file is complete, or its damage is reported");
    for (const mcap::AttachmentPlace& place : contents.attachments) {
      try {
        require(read_attachment(source, place).size() <= bytes.size(), "an attachment lies in its file");
      } catch (const mcap::Damage& damage) {
        require(damage.where <= bytes.size(), "a damage has a place");
      }
    }
  } catch (const mcap::Damage& damage) {
    require(damage.where <= bytes.size(), "a damage has a place");
  }
  try {
    Recording recording(std::make_unique<mcap::MemorySource>(bytes));
    recording.read_views();
    RecordedFrame frame;
    for (int i = 0; i < 100 && recording.next(frame); ++i)
      require(frame.entry.digests.size() <= kTopics.size(), "a frame has at most one digest per topic");
    static_cast<void>(recording.go_to(1.0));
  } catch (const BadBytes&) {  // of another version, or invalid
  } catch (const std::runtime_error&) {
  }
}

void try_message(std::span<const std::byte> bytes) {
  try {
    FrameEntry entry;
    read_frame_entry(bytes, entry);
    std::vector<std::byte> again;
    write_frame_entry(entry, again);
    require(again.size() == bytes.size(), "a frame is written with the size that was read");
    const StoredInputs inputs(entry.inputs);
    static_cast<void>(read_record(entry.record));
  } catch (const BadBytes&) {
  }
  try {
    Image image;
    unpack_image(bytes, image);
    std::vector<std::byte> again;
    pack_image(image.view(), again);
    require(again == std::vector<std::byte>(bytes.begin(), bytes.end()), "an image is packed into the same bytes");
  } catch (const BadBytes&) {
  }
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const reorient::Haste haste(10.0);
  const auto bytes = std::as_bytes(std::span(data, size));
  reorient::try_file(bytes);
  reorient::try_message(bytes);
  return 0;
}
