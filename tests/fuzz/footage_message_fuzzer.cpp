// SPDX-License-Identifier: MIT
// Arbitrary bytes as messages of the types from which footage is read: read as a message or refused with one line, with
// no more memory than the bytes justify.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "robots/footage/camera_info.h"
#include "robots/footage/log_frames.h"
#include "robots/footage/messages/message_types.h"
#include "robots/footage/raw_image.h"
#include "tests/fuzz/promises.h"

namespace reorient {
namespace {

void use(const messages::RawImage& raw) {
  const Image image = image_of(raw);
  require(image.bytes().size() <= 4 * raw.data.size(), "an image is not larger than its data");
}

void use(const messages::CameraInfo& info) {
  for (const bool rectified : {false, true}) {
    const CameraModel camera =
        camera_of(info, static_cast<int>(info.width % 4096), static_cast<int>(info.height % 4096), rectified);
    require(camera.focal.allFinite() && camera.focal.minCoeff() > 0.0, "a camera has a focal length");
  }
}

template <typename Message>
void use(const Message& message) {
  LogFrameOptions options;
  options.camera.emplace();
  LogFrames frames(options);
  LogMessage given;
  given.where = "fuzzer";
  given.message = message;
  for (int i = 0; i < enum_count(messages::Content{}); ++i) {
    given.content = static_cast<messages::Content>(i);
    frames.add(given);
  }
  given.content = messages::Content::image;
  given.message = messages::RawImage{{1, "camera"}, 2, 1, "mono8", 2, messages::Bytes(2)};
  frames.add(given);
  frames.finish();
  for (FootageFrame frame; frames.next(frame);) {
    require(frame.robot_from_camera.matrix().allFinite(), "a frame has a camera pose");
    require(!frame.pose || frame.pose->position.allFinite(), "a pose is finite");
  }
}

/// The only encoding that does not refuse the first byte.
std::string_view encoding_of(std::span<const std::byte> bytes) {
  if (bytes.empty() || bytes[0] == std::byte{'{'}) return "json";
  return bytes[0] == std::byte{0} ? "cdr" : "protobuf";
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace reorient;
  const Haste haste(5.0);
  const auto bytes = std::as_bytes(std::span(data, size));
  for (const messages::MessageType& type : messages::message_types()) {
    if (type.encoding != encoding_of(bytes)) continue;
    try {
      const messages::Message message = type.decode(bytes);
      std::visit([](const auto& content) { use(content); }, message);
    } catch (const BadFootage& bad) {
      require_message(bad.what());
    }
  }
  return 0;
}
