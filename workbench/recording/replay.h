// SPDX-License-Identifier: MIT
// Runs the frames of a recording again, each section of them with its own engine.
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

/// Inputs that are added to the next recorded frame only.
class AddedInputs : public InputSource {
 public:
  /// Adds messages, edits of scripts and changes of parameters to those that were added before.
  void add(const FrameInputs& more);
  void add_to(FrameInputs& inputs) override;

 private:
  FrameInputs next_;
};

class Replay {
 public:
  /// `from`, `to`: s of the robot. Replays from the last state before `from` up to the first frame that is not before
  /// `to`. The source must outlive it.
  explicit Replay(FrameSource& source, double from = 0.0, double to = std::numeric_limits<double>::infinity());

  Playback& playback() { return *playback_; }
  const Playback& playback() const { return *playback_; }

  /// The engine at the beginning of the next section; nullptr: no section is left.
  FrameLoop* next_stretch();
  /// Plays the section frame by frame. `sources` add to the recorded inputs.
  RunParts parts(const std::vector<InputSource*>& sources, std::vector<Observer*> observers);
  /// Plays the section to its end, or until `stop` returns true.
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
