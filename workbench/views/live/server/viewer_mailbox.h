// SPDX-License-Identifier: MIT
// The messages that wait for one viewer, in a bounded memory. The newest frame waits until the connection has time for
// it, so a slow viewer receives fewer frames; the threads that add messages never wait for it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "workbench/views/live/protocol/websocket_frames.h"
#include "workbench/views/live/server/link_rate.h"
#include "workbench/views/live/server/rate_status.h"

namespace reorient::live {

/// Order in which data is dropped when the memory is full: images first.
enum class Importance { image, data, lasting };

/// A message of a frame.
struct FrameMessage {
  std::uint32_t subscription = 0;
  std::shared_ptr<const std::string> text;
  Importance importance = Importance::data;
  std::optional<Bulk> bulk;
  bool waits = false;  ///< if it is not sent with its frame, it is sent with a later one, unless there is a newer one
};

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

  /// Messages of one frame, which belong together. The frame replaces one that still waits for the connection. `time`:
  /// ns.
  void add_frame(std::uint64_t time, std::vector<FrameMessage> messages);
  /// Nothing of this subscription waits any more in a frame.
  void forget(std::uint32_t subscription);

  /// The last message is a close frame with this reason; nothing is added after it. Only the first call counts.
  void close(std::uint16_t code, const std::string& reason);
  /// The same, but what waits is discarded.
  void close_now(std::uint16_t code, const std::string& reason);

  /// Waits for the next message: control before data. Nothing: the mailbox is closed and empty.
  std::optional<Outgoing> wait();
  /// Measures the connection from now on, with pings; viewers that do not answer them receive everything.
  /// `shows_rates`: the status of a slow connection has numbers.
  void measure(bool shows_rates);
  void receive_pong(std::span<const std::byte> bytes);
  /// A closed mailbox was not emptied within kPatience: stop sending.
  bool is_given_up() const;
  static constexpr std::chrono::milliseconds kPatience{500};

  std::uint64_t dropped() const;  ///< messages
  FrameCounts left_out() const;   ///< because the connection is slow

 private:
  struct Waiting {
    Outgoing message;
    Importance importance;
  };
  struct Frame {
    std::uint64_t time = 0;  // ns
    std::vector<FrameMessage> messages;
    bool replaces = false;  // a frame that was not sent
    bool is_sent = false;   // only bulk is left
  };
  struct Ping {
    std::uint64_t bytes = 0;  // of messages that were taken before it
    Clock::time_point sent;
  };
  LinkMeasurement measure_link(Clock::time_point now) const;
  void push_data(Outgoing message, Importance importance);
  Clock::duration send_frame(Clock::time_point now);
  std::optional<Outgoing> take(Clock::time_point now);
  std::optional<Outgoing> take_ping(Clock::time_point now);
  void clear_data();
  void make_room(std::size_t bytes);
  bool drop_oldest(Importance importance);
  void close_locked(std::uint16_t code, const std::string& reason);

  const Limits limits_;
  mutable std::mutex mutex_;  // protects all members below
  std::condition_variable wake_;
  std::deque<Waiting> data_;
  std::deque<Outgoing> control_;
  std::size_t data_bytes_ = 0, control_bytes_ = 0;
  Frame frame_;                                              // the newest one; empty: none waits
  std::uint64_t taken_ = 0, pinged_ = 0, acknowledged_ = 0;  // bytes of messages
  std::deque<Ping> pings_;                                   // not answered
  Clock::time_point waiting_since_;                          // for the answer to the first byte without one
  double round_trip_ = 0.0;                                  // s, the shortest
  bool begins_to_measure_ = false, is_measured_ = false, shows_rates_ = false;
  LinkState link_;
  RateStatus rate_;
  std::uint64_t dropped_ = 0;
  bool has_news_of_drops_ = false;
  Clock::time_point last_news_{};
  std::optional<Clock::time_point> closed_;
};

}  // namespace reorient::live
