// SPDX-License-Identifier: MIT
// The messages that wait for one viewer, in a bounded memory. A slow viewer loses data; the threads that add messages
// never wait for it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "workbench/views/live/protocol/websocket_frames.h"

namespace reorient::live {

/// Order in which data is dropped when the memory is full: images first.
enum class Importance { image, data, lasting };

/// One message: some bytes of its own, then a text that several viewers share.
struct Outgoing {
  WebSocketType type = WebSocketType::text;
  std::vector<std::byte> own;
  std::shared_ptr<const std::string> shared;  ///< may be nullptr

  std::size_t size() const { return own.size() + (shared ? shared->size() : 0); }
};

/// Exactly this text, to which viewers add advice.
inline constexpr const char* kDroppedText = "Send buffer limit reached";
inline constexpr const char* kDroppedId = "dropped";

class ViewerMailbox {
 public:
  struct Limits {
    std::size_t data_bytes = std::size_t{8} << 20;
    std::size_t data_messages = 4096;
    std::size_t control_bytes = std::size_t{4} << 20;
    std::size_t control_messages = 512;
  };
  using Clock = std::chrono::steady_clock;

  ViewerMailbox() : ViewerMailbox(Limits()) {}
  explicit ViewerMailbox(Limits limits) : limits_(limits) {}

  /// A message of a topic. If the memory is full, the oldest images are dropped, then the oldest other data, then
  /// lasting messages.
  void add_data(Outgoing message, Importance importance);
  /// A message that must arrive, such as an answer. If the memory is full, the viewer is disconnected.
  void add_control(Outgoing message);
  void add_control(std::string text);

  /// The last message is a close frame with this reason; nothing is added after it. Only the first call counts.
  void close(std::uint16_t code, const std::string& reason);
  /// The same, but what waits is discarded.
  void close_now(std::uint16_t code, const std::string& reason);

  /// Waits for the next message: control before data. Nothing: the mailbox is closed and empty.
  std::optional<Outgoing> wait();
  /// A closed mailbox was not emptied within kPatience: stop sending.
  bool is_given_up() const;
  static constexpr std::chrono::milliseconds kPatience{500};

  std::uint64_t dropped() const;  ///< messages

 private:
  struct Waiting {
    Outgoing message;
    Importance importance;
  };
  void make_room(std::size_t bytes);
  bool drop_oldest(Importance importance);
  void close_locked(std::uint16_t code, const std::string& reason);

  const Limits limits_;
  mutable std::mutex mutex_;  // protects all members below
  std::condition_variable wake_;
  std::deque<Waiting> data_;
  std::deque<Outgoing> control_;
  std::size_t data_bytes_ = 0, control_bytes_ = 0;
  std::uint64_t dropped_ = 0;
  bool has_news_of_drops_ = false;
  Clock::time_point last_news_{};
  std::optional<Clock::time_point> closed_;
};

}  // namespace reorient::live
