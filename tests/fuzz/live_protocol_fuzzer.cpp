// SPDX-License-Identifier: MIT
// Arbitrary bytes from a viewer of the live view: as frames of WebSocket, and as messages of the protocol. With any
// bytes, memory and time are bounded, and a refusal is one line.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <variant>

#include "tests/fuzz/promises.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"
#include "workbench/views/live/protocol/websocket_frames.h"

namespace reorient::live {
namespace {

template <typename Read>
void read_message(const Read& read) {
  try {
    const ClientMessage message = read();
    if (const auto* set = std::get_if<SetParameters>(&message))
      require(set->parameters.size() <= kLargestClientMessage, "the number of parameters is bounded");
    if (const auto* control = std::get_if<ControlPlayback>(&message))
      require(control->speed >= 0.0f, "a speed is not negative");
  } catch (const BadClientMessage& bad) {
    require_message(bad.what());
  }
}

void read_frames(std::span<const std::byte> bytes) {
  constexpr std::size_t kLargest = 1024;
  WebSocketReader reader(kLargest);
  // In two pieces, as a stream may arrive.
  const std::size_t first = bytes.empty() ? 0 : std::to_integer<std::size_t>(bytes[0]) % bytes.size();
  for (const std::span<const std::byte> part : {bytes.first(first), bytes.subspan(first)}) {
    reader.add(part);
    while (const auto message = reader.next()) {
      require(message->data.size() <= kLargest, "a message is bounded");
      const std::span<const std::byte> data = message->data;
      if (message->type == WebSocketType::binary) read_message([&] { return read_client_binary(data); });
      if (message->type == WebSocketType::text)
        read_message([&] { return read_client_text({reinterpret_cast<const char*>(data.data()), data.size()}); });
    }
  }
  if (reader.failure().empty()) return;
  require_message(reader.failure());
  require(websocket_close(reader.failure_code(), reader.failure()).size() <= 127, "a close frame is short");
}

}  // namespace
}  // namespace reorient::live

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace reorient::live;
  const reorient::Haste haste(5.0);
  const std::span<const std::byte> bytes = std::as_bytes(std::span(data, size));
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read_frames(bytes);
  read_message([&] { return read_client_binary(bytes); });
  read_message([&] { return read_client_text(text); });
  choose_subprotocol(text);
  return 0;
}
