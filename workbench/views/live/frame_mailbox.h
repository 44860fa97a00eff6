// SPDX-License-Identifier: MIT
// Copies of frames on their way from the thread of the frames to the thread that makes messages. The latest frames win.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <vector>

#include "engine/record/frame_record.h"
#include "geometry/image.h"
#include "workbench/run/observer.h"
#include "workbench/views/viewer/viewer_messages.h"

namespace reorient::live {

/// What the messages of a frame need. Its memory is used again.
struct FrameCopy {
  double time = 0.0;              ///< s
  ViewerTopics topics;            ///< messages to make
  bool begins = false;            ///< lasting messages are sent again
  std::vector<std::byte> record;  ///< write_record() of the topics that are always filled, and of kViewedTopics
  SceneTruth scene;
  std::array<bool, 2> has_image{};
  std::array<Image, 2> images;
};

/// Not synchronized: its owner's mutex protects it.
class FrameMailbox {
 public:
  static constexpr std::size_t kMostWaiting = 4;
  static constexpr std::size_t kMostEvents = 300;  ///< frames of which only events and log lines wait

  /// An empty copy to be filled; never nullptr.
  std::unique_ptr<FrameCopy> get_free() {
    if (free_.empty()) return std::make_unique<FrameCopy>();
    std::unique_ptr<FrameCopy> copy = std::move(free_.back());
    free_.pop_back();
    return copy;
  }
  void give_back(std::unique_ptr<FrameCopy> copy) {
    if (free_.size() <= kMostWaiting) free_.push_back(std::move(copy));
  }
  /// If it is full, drops the oldest frame, except its events and log lines.
  void add(std::unique_ptr<FrameCopy> copy) {
    if (waiting_.size() == kMostWaiting) {
      // A frame that begins something is needed later, so the next one begins it, with the messages of a begin.
      FrameCopy& next = waiting_.size() > 1 ? *waiting_[1] : *copy;
      const FrameCopy& dropped = *waiting_.front();
      next.begins = next.begins || dropped.begins;
      for (const ViewerTopic topic :
           {ViewerTopic::field, ViewerTopic::upper_calibration, ViewerTopic::lower_calibration}) {
        const auto index = static_cast<std::size_t>(topic);
        if (dropped.begins && dropped.topics.test(index)) next.topics.set(index);
      }
      keep_events(std::move(waiting_.front()));
      waiting_.pop_front();
      ++dropped_;
    }
    waiting_.push_back(std::move(copy));
  }
  /// nullptr: no frame waits.
  std::unique_ptr<FrameCopy> take() {
    std::deque<std::unique_ptr<FrameCopy>>& from = events_.empty() ? waiting_ : events_;
    if (from.empty()) return nullptr;
    std::unique_ptr<FrameCopy> copy = std::move(from.front());
    from.pop_front();
    return copy;
  }
  bool is_empty() const { return waiting_.empty() && events_.empty(); }
  std::uint64_t dropped() const { return dropped_; }

 private:
  void keep_events(std::unique_ptr<FrameCopy> copy) {
    copy->topics &= moment_topics();
    copy->begins = false;
    copy->has_image = {};
    if (copy->topics.none() || events_.size() == kMostEvents) return give_back(std::move(copy));
    copy->images = {};  // large, and not needed
    events_.push_back(std::move(copy));
  }

  std::deque<std::unique_ptr<FrameCopy>> events_;  // older than those that wait
  std::deque<std::unique_ptr<FrameCopy>> waiting_;
  std::vector<std::unique_ptr<FrameCopy>> free_;
  std::uint64_t dropped_ = 0;
};

}  // namespace reorient::live
