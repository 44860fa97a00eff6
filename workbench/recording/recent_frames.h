// SPDX-License-Identifier: MIT
// The latest frames of a run in bounded memory, with all that a replay needs. A frame never waits: it adds its data to
// a short queue, and a thread packs them.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "workbench/recording/frame_source.h"
#include "workbench/run/observer.h"

namespace reorient {

struct RecentFramesOptions {
  std::size_t most_bytes = std::size_t{256} << 20;  ///< of all frames; above it the oldest ones are forgotten
  double state_every = 2.0;                         ///< s between two states of the engine
  std::size_t most_waiting = 8;                     ///< frames; more are left out
};

class RecentFrames : public Observer {
 public:
  explicit RecentFrames(RecentFramesOptions options = {});
  ~RecentFrames() override;

  void before(const FrameInputs& inputs, const FrameLoop& engine) override;
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  /// The frames so far, from the oldest one with a state on. The frames of the following calls are not part of it. Any
  /// thread may call it; never nullptr.
  std::unique_ptr<FrameSource> frames() const;

  struct Counts {
    std::uint64_t frames = 0;
    double begin = 0.0, end = 0.0;  ///< s of the robot, times of the first and of the last frame
    std::size_t bytes = 0;
    std::uint64_t left_out = 0;  ///< frames since the start, because the processor was too slow
  };
  Counts counts() const;

 private:
  struct Item;
  struct PackedFrame;
  class Packer;
  class Player;

  void pack_items();
  void keep(std::shared_ptr<const PackedFrame> frame);

  const RecentFramesOptions options_;

  // Of the thread of the frames.
  std::unique_ptr<Item> item_;  // item that is being filled; nullptr: the frame is left out
  double next_state_ = 0.0;     // s of the robot
  std::optional<std::uint64_t> last_frame_;
  bool needs_state_ = true;

  mutable std::mutex mutex_;  // protects all members below
  std::condition_variable wake_;
  std::deque<std::unique_ptr<Item>> waiting_;
  std::vector<std::unique_ptr<Item>> free_;
  std::deque<std::shared_ptr<const PackedFrame>> kept_;
  Counts counts_;
  bool ends_ = false;

  std::thread thread_;
};

}  // namespace reorient
