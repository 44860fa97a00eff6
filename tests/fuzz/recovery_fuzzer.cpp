// SPDX-License-Identifier: MIT
// A recording through another tool and `recording recover`: the input chooses the shape of the file, changes messages,
// and flips bytes. No frame is lost without a word, and the recovered recording is whole.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include <unistd.h>

#include "geometry/bytes.h"
#include "tests/fuzz/promises.h"
#include "tests/paths.h"
#include "tests/workbench/recording/foreign_recording.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/rewriting.h"

namespace reorient {
namespace {

const RawRecording& whole() {
  static const RawRecording recording =
      raw_recording(std::filesystem::path(kSourceFolder) / "tests/workbench/recording/golden" /
                    ("format_" + std::to_string(kRecordingFormat) + ".mcap"));
  return recording;
}

/// Numbers from the input; 0 after its end.
class Choices {
 public:
  explicit Choices(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  bool left() const { return !bytes_.empty(); }
  std::size_t below(std::size_t count) {
    std::size_t value = 0;
    for (int i = 0; i < 3 && left(); ++i) {
      value = 256 * value + bytes_.front();
      bytes_ = bytes_.subspan(1);
    }
    return count == 0 ? 0 : value % count;
  }

 private:
  std::span<const std::uint8_t> bytes_;
};

void change(RawRecording& recording, Choices& choices) {
  auto& messages = recording.messages;
  if (messages.empty()) return;
  RawRecording::Message& message = messages[choices.below(messages.size())];
  switch (choices.below(6)) {
    case 0:
      messages.erase(messages.begin() + (&message - messages.data()));
      return;
    case 1:
      messages.push_back(message);
      return;
    case 2:
      message.channel = recording.channels[choices.below(recording.channels.size())].id;
      return;
    case 3:
      message.data.resize(choices.below(message.data.size() + 100));
      return;
    case 4:
      message.time = messages[choices.below(messages.size())].time;
      return;
    default:
      if (!message.data.empty()) message.data[choices.below(message.data.size())] ^= std::byte{1};
  }
}

std::filesystem::path scratch_file() {
  return std::filesystem::temp_directory_path() / ("recovery_fuzzer." + std::to_string(getpid()) + ".mcap");
}

void try_recovery(std::span<const std::uint8_t> data) {
  static const std::vector<ForeignShape> shapes = all_foreign_shapes();
  Choices choices(data);
  RawRecording recording = whole();
  const ForeignShape& shape = shapes[choices.below(shapes.size())];
  for (std::size_t changes = choices.below(8); changes > 0; --changes) change(recording, choices);
  std::vector<std::byte> bytes = written_as(recording, shape);
  const bool is_damaged = choices.left();
  for (int flips = 0; flips < 20 && choices.left(); ++flips)
    bytes[choices.below(bytes.size())] ^= static_cast<std::byte>(1 + choices.below(255));
  const std::size_t frames = recording.of(kFrameTopic).size();
  try {
    Recording read(std::make_unique<mcap::MemorySource>(bytes));
    const Rewritten done = recover_recording(read, scratch_file());
    require(is_damaged || done.frames <= frames, "no frame is invented");
    // A flipped byte may hide the last frame of a file that has neither checksums nor statistics.
    require(is_damaged || done.frames == frames || done.losses.any() || !read.damages().empty(),
            "no frame is lost without a word");
    for (const std::string& damage : read.damages()) require_message(damage);
    Recording again(scratch_file());
    RecordedFrame frame;
    std::uint64_t count = 0;
    while (again.next(frame)) ++count;
    require(again.damages().empty() && count == done.frames, "the recovered recording is whole");
  } catch (const std::runtime_error& error) {
    require_message(error.what());
    require(is_damaged, "a recording of another shape is recovered");
  }
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerInitialize(int* /*argc*/, char*** /*argv*/) {
  std::atexit([] { std::filesystem::remove(reorient::scratch_file()); });
  return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const reorient::Haste haste(10.0);
  reorient::try_recovery(std::span(data, size));
  return 0;
}
