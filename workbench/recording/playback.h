// SPDX-License-Identifier: MIT
// A recording as a robot: its observations, the inputs that were set, and its true pose. Where a stretch of frames that
// can be made again ends, the robot is gone; there may be another stretch.
#pragma once

#include <optional>

#include "engine/record/input_bytes.h"
#include "robots/operator.h"
#include "robots/robot.h"
#include "workbench/recording/recording.h"
#include "workbench/run/run_loop.h"

namespace reorient {

class Playback : public Robot, public InputSource, public GroundTruthSource {
 public:
  /// Plays from `from` (s of the robot) on, or rather from the state before it; no stretch that begins after `to`. The
  /// recording must outlive it.
  Playback(Recording& recording, double from, double to);

  /// Goes to the next stretch, skipping frames that cannot be replayed. False: no stretch is left.
  bool next_stretch();
  /// Of the engine, where the stretch begins.
  const std::vector<std::byte>& state() const { return frame_.state; }

  /// The frame that was observed last.
  const RecordedFrame& frame() const { return frame_; }
  std::uint64_t skipped() const { return skipped_; }  ///< frames, up to `to`

  // Robot
  bool observe(Observation& observation) override;
  void answer(const Answer& /*answer*/) override {}
  // InputSource
  void add_to(FrameInputs& inputs) override;
  // GroundTruthSource
  std::optional<GroundTruth> truth() const override;

 private:
  Recording& recording_;
  double to_;
  RecordedFrame frame_;
  std::optional<StoredInputs> inputs_;
  bool begins_ = false;  // the stretch, with the frame that is there already
  bool is_over_ = false;
  bool is_waiting_ = false;  // a frame was read that belongs to no stretch yet
  std::uint64_t skipped_ = 0;
};

}  // namespace reorient
