// SPDX-License-Identifier: MIT
// The differences between a replayed frame and the recording, in words.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/playback.h"
#include "workbench/run/observer.h"

namespace reorient {

/// The first value of a frame that is another one.
struct Difference {
  std::uint64_t frame = 0;
  double time = 0.0;     ///< s of the robot
  std::string what;      ///< "confidence.current", "machine orientation"
  std::string recorded;  ///< its value then
  std::string replayed;  ///< and now
};

/// Of two records of the same frame; nothing: they are the same as far as topics with a fingerprint go.
std::optional<Difference> first_difference(const FrameRecord& recorded, const FrameRecord& replayed);

/// The same for what reaches the robot: the head, the walk, getting up, words, reorientations.
std::optional<Difference> first_difference_in_action(const FrameRecord& recorded, const FrameRecord& replayed);

/// Compares frame by frame what is replayed with what is recorded.
class ReplayComparison : public Observer {
 public:
  /// `playback` must outlive it.
  explicit ReplayComparison(const Playback& playback) : playback_(playback) {}

  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  std::uint64_t frames() const { return frames_; }        ///< compared
  std::uint64_t different() const { return different_; }  ///< how many of them
  const std::optional<Difference>& first() const { return first_; }
  const std::optional<Difference>& first_action() const { return first_action_; }

  /// A change of state or a command, in one of the two alone or in both.
  struct Event {
    double time = 0.0;
    std::string text;
    bool recorded = false, replayed = false;
  };
  /// In the order of time; the first kMostEvents.
  const std::vector<Event>& events() const { return events_; }
  static constexpr std::size_t kMostEvents = 10000;

 private:
  void add_events(const FrameRecord& recorded, const FrameRecord& replayed);

  const Playback& playback_;
  std::uint64_t frames_ = 0, different_ = 0;
  std::optional<Difference> first_, first_action_;
  std::vector<Event> events_;
  TopicDigests digests_;
  std::vector<std::byte> bytes_;
  std::vector<std::size_t> places_;
};

}  // namespace reorient
