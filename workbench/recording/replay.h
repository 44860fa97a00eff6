// SPDX-License-Identifier: MIT
// The frames of a recording, made again: each stretch of them by an engine of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

#include "engine/frame.h"
#include "robots/robot_instance.h"
#include "workbench/recording/playback.h"
#include "workbench/run/run_loop.h"

namespace reorient {

/// What is added to the next frame that was recorded, and to no other.
class AddedInputs : public InputSource {
 public:
  /// Of its messages, scripts and parameters; beside what was to be added already.
  void add(const FrameInputs& more);
  void add_to(FrameInputs& inputs) override;

 private:
  FrameInputs next_;
};

class Replay {
 public:
  /// `from`, `to`: s of the robot; from the last state before the one, up to the first frame that is not before the
  /// other. The recording must outlive it.
  explicit Replay(Recording& recording, double from = 0.0, double to = std::numeric_limits<double>::infinity());

  Playback& playback() { return *playback_; }
  const Playback& playback() const { return *playback_; }

  /// The engine at the beginning of the next stretch; nullptr: no stretch is left.
  FrameLoop* next_stretch();
  /// To play it frame by frame. `sources`: add to what was recorded.
  RunParts parts(const std::vector<InputSource*>& sources, std::vector<Observer*> observers);
  /// Plays it to its end, or until `stop`.
  void run(const std::vector<InputSource*>& sources, std::vector<Observer*> observers,
           const std::function<bool()>& stop = {});

  std::uint64_t stretches() const { return stretches_; }

 private:
  Playback* playback_;  // the robot
  RobotInstance robot_;
  std::unique_ptr<FrameLoop> engine_;
  double to_;
  bool is_over_ = false;
  std::uint64_t stretches_ = 0;
};

}  // namespace reorient
