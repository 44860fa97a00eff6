// SPDX-License-Identifier: MIT
// The differences between a replayed frame and the recording, as text.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/playback.h"
#include "workbench/run/observer.h"

namespace reorient {

/// The first value of a frame that differs.
struct Difference {
  std::uint64_t frame = 0;
  double time = 0.0;     ///< s of the robot
  std::string what;      ///< "confidence.current", "machine orientation"
  std::string recorded;  ///< value in the recording
  std::string replayed;  ///< value in the replay
};

/// Compares two records of the same frame. Empty: the topics with a fingerprint are the same.
std::optional<Difference> first_difference(const FrameRecord& recorded, const FrameRecord& replayed);

/// The same for the outputs to the robot: head, walking, getting up, messages, reorientations.
std::optional<Difference> first_difference_in_action(const FrameRecord& recorded, const FrameRecord& replayed);

/// Compares a replay with its recording frame by frame.
class ReplayComparison : public Observer {
 public:
  /// `playback` must outlive it.
  explicit ReplayComparison(const Playback& playback) : playback_(playback) {}

  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  std::uint64_t frames() const { return frames_; }        ///< number of compared frames
  std::uint64_t different() const { return different_; }  ///< number of different frames
  const std::optional<Difference>& first() const { return first_; }
  const std::optional<Difference>& first_action() const { return first_action_; }

  /// A change of state or a command, in the recording, the replay or both.
  struct Event {
    double time = 0.0;
    std::string text;
    bool recorded = false, replayed = false;
  };
  /// The first kMostEvents, in the order of time.
  const std::vector<Event>& events() const { return events_; }
  static constexpr std::size_t kMostEvents = 10000;
  /// The first event that only one of the two has.
  std::optional<Event> first_decision() const;

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
