// SPDX-License-Identifier: MIT
// Arbitrary bytes as the log of a robot: read as frames whose times increase, or refused with one line.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>

#include "tests/fuzz/promises.h"
#include "workbench/footage/mcap_log.h"

namespace reorient {
namespace {

void read_log(std::span<const std::byte> bytes) {
  McapLogOptions options;
  options.frames.decode_image = [](std::span<const std::byte>, const std::string&) { return Image(4, 2); };
  std::string failure;
  try {
    McapLog log(std::make_unique<mcap::MemorySource>(bytes), "log", options);
    double last = 0.0;
    try {
      bool is_first = true;
      for (FootageFrame frame; log.next(frame); is_first = false) {
        require(is_first || frame.time >= last, "times increase");
        last = frame.time;
        require(frame.image.width() % 2 == 0 && frame.image.width() == frame.camera.width,
                "the sizes of image and camera agree");
      }
    } catch (const BadFootage& bad) {
      failure = bad.what();
      FootageFrame frame;
      log.next(frame);
      require(false, "a log that has failed fails again");
    }
  } catch (const BadFootage& bad) {
    require_message(bad.what());
    require(failure.empty() || failure == bad.what(), "a failure stays the same");
  }
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const reorient::Haste haste(10.0);
  reorient::read_log(std::as_bytes(std::span(data, size)));
  return 0;
}
