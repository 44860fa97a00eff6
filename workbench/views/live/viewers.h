// SPDX-License-Identifier: MIT
// The connected viewers: their subscriptions, and the messages that they receive. Any thread may call it.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/parameters/parameter.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"
#include "workbench/views/live/requests.h"
#include "workbench/views/live/server/viewer_mailbox.h"
#include "workbench/views/viewer/viewer_messages.h"

namespace reorient::live {

class Viewers {
 public:
  using Mailbox = std::shared_ptr<ViewerMailbox>;

  ViewerId add(Mailbox mailbox);
  /// Of the run. Viewers that connect from now on learn the types of its values.
  void set_application(const ApplicationInterface& application);
  ApplicationInterface application() const;
  void remove(ViewerId id);

  /// Both return one line if the viewer made a mistake; else an empty text. A new subscriber of a lasting topic
  /// receives its last message at once.
  std::string subscribe(ViewerId id, const Subscribe::One& one);
  std::string unsubscribe(ViewerId id, std::uint32_t subscription);
  void watch(ViewerId id, const WatchParameters& watched);

  // For the thread of the frames, without waiting.
  ViewerTopics subscribed() const { return ViewerTopics(subscribed_.load(std::memory_order_relaxed)); }
  /// No frames come after the one at `time` (ns): a new subscriber receives its messages. kMoving: frames come.
  void set_still(std::uint64_t time) { still_at_.store(time, std::memory_order_relaxed); }
  static constexpr std::uint64_t kMoving = std::numeric_limits<std::uint64_t>::max();
  bool any() const { return any_.load(std::memory_order_relaxed); }
  bool any_watches() const { return any_watches_.load(std::memory_order_relaxed); }
  /// Whether a lasting topic has a new subscriber since the last call.
  bool take_new_subscriber() { return has_new_subscriber_.exchange(false, std::memory_order_relaxed); }
  /// Whether a topic has a new subscriber since the last call, while no frames come.
  bool take_late_subscriber() { return has_late_subscriber_.exchange(false, std::memory_order_relaxed); }

  /// Sends a message of a topic to its subscribers: at once, or with the frame to which it belongs. `time`: ns.
  void publish(ViewerTopic topic, std::uint64_t time, std::string message);
  /// The messages since the last call are one frame.
  void end_frame(std::uint64_t time);
  void send(ViewerId id, std::string text);
  void send(ViewerId id, std::vector<std::byte> binary);
  void send_all(const std::vector<std::byte>& binary);
  /// Sends the parameters that have changed since the last call to the viewers that watch them.
  void send_changes(const std::vector<Parameter>& now);

  struct Counts {
    std::uint64_t viewers = 0;  ///< so far
    std::uint64_t dropped = 0;  ///< messages, because too many waited
    FrameCounts left_out;       ///< because connections were slow
  };
  Counts counts() const;

 private:
  struct Viewer {
    Mailbox mailbox;
    std::array<std::optional<std::uint32_t>, kViewerTopicCount> subscriptions{};  // by topic
    bool watches_all = false;
    std::set<std::string> watched;
    std::vector<FrameMessage> frame{};
  };
  struct Last {
    std::uint64_t time = 0;
    std::shared_ptr<const std::string> message;
  };
  void update_flags();
  static void count(const ViewerMailbox& mailbox, Counts& counts);
  static void send_data(const Viewer& viewer, std::size_t topic, std::uint64_t time,
                        const std::shared_ptr<const std::string>& message);

  mutable std::mutex mutex_;  // protects all members below except the atomic ones
  std::map<ViewerId, Viewer> viewers_;
  std::array<Last, kViewerTopicCount> last_;
  std::map<std::string, ParameterValue> values_;  // as last sent
  ApplicationInterface application_;
  ViewerId next_ = 1;
  Counts gone_;
  std::atomic<unsigned long> subscribed_ = 0;
  std::atomic<std::uint64_t> still_at_ = kMoving;
  std::atomic<bool> any_ = false, any_watches_ = false, has_new_subscriber_ = false, has_late_subscriber_ = false;
};

}  // namespace reorient::live
