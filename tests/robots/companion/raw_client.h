// SPDX-License-Identifier: MIT
// A client of the companion that can send any bytes, also invalid messages.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robots/companion/companion.h"
#include "robots/companion/message.h"
#include "robots/companion/shared_images.h"

namespace reorient {

/// The hello of a NAO with one small camera, which contains the numbers of its body.
reorient_hello small_hello(std::uint64_t client = 7, std::uint32_t way = REORIENT_OUR_LOCALIZATION);
/// A frame of this NAO while it stands upright, with an image in the slot with this sequence number.
reorient_frame standing_frame(std::uint64_t number, double time, std::uint64_t sequence);

/// Knows no robot and no field by name.
KnownRobots no_known_robots();

class RawClient {
 public:
  explicit RawClient(const std::filesystem::path& path);
  bool is_connected() const { return static_cast<bool>(socket_); }
  void end() { socket_ = OwnedDescriptor(); }

  /// Returns false if it does not fit or no process listens any more.
  bool send_bytes(std::span<const std::byte> bytes, int descriptor = -1);
  template <typename Message>
  bool send(std::uint16_t kind, const Message& message, int descriptor = -1) {
    std::vector<std::byte> bytes;
    append_message(kind, message, bytes);
    return send_bytes(bytes, descriptor);
  }
  /// Sends the hello and the shared memory.
  void introduce(const reorient_hello& hello);
  /// The same with the whole message of the hello.
  void introduce(std::span<const std::byte> hello);
  /// Writes an image of one gray to the next slot and returns its sequence number.
  std::uint64_t paint(std::uint8_t gray);
  bool send_frame(double time, std::uint64_t number);

  struct Heard {
    std::uint16_t kind = 0;
    std::vector<std::byte> body;
    template <typename Message>
    Message as() const {
      std::span<const std::byte> bytes = body;
      return take_message<Message>(bytes, "received message");
    }
  };
  /// All messages that have arrived.
  std::vector<Heard> hear();
  /// The last answer among them.
  std::optional<reorient_answer> answer();
  /// The reason of a refusal; empty if none has arrived.
  std::string refusal();

  std::byte* slots() { return slots_.get(); }
  int memory() const { return memory_.get(); }
  std::uint32_t slot_size() const { return slot_size_; }

 private:
  OwnedDescriptor socket_;
  OwnedDescriptor memory_;
  std::shared_ptr<std::byte> slots_;
  std::uint32_t slot_size_ = 0;
  std::uint64_t sequence_ = 0;
  std::vector<std::byte> in_;
};

/// A memfd of this size.
OwnedDescriptor memory_of(std::size_t bytes, bool sealed);

}  // namespace reorient
