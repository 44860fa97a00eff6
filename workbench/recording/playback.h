// SPDX-License-Identifier: MIT
// Recorded frames as a robot: its observations, the inputs that were set, and its true pose. The run ends with a
// section of frames that can be replayed exactly; another section may follow.
#pragma once

#include <optional>

#include "engine/record/input_bytes.h"
#include "geometry/bytes.h"
#include "robots/operator.h"
#include "robots/robot.h"
#include "workbench/recording/frame_source.h"
#include "workbench/run/run_loop.h"

namespace reorient {

class Playback : public Robot, public InputSource, public GroundTruthSource {
 public:
  /// Plays from the last state before `from` (s of the robot), without sections that begin after `to`. The source must
  /// outlive it.
  Playback(FrameSource& source, double from, double to);

  /// Goes to the next section and skips frames that cannot be replayed. False: no section is left.
  bool next_stretch();
  /// State of the engine at the beginning of the section.
  const std::vector<std::byte>& state() const { return frame_.state; }

  /// The last observed frame.
  const RecordedFrame& frame() const { return frame_; }
  std::uint64_t skipped() const { return skipped_; }  ///< frames, up to `to`
  /// Skips the first frame of the section, because its state cannot be used.
  void skip(const BadBytes& reason);

  // Robot
  bool observe(Observation& observation) override;
  void answer(const Answer& /*answer*/) override {}
  // InputSource
  void add_to(FrameInputs& inputs) override;
  // GroundTruthSource
  std::optional<GroundTruth> truth() const override;

 private:
  void take_inputs();

  FrameSource& source_;
  double to_;
  RecordedFrame frame_;
  std::optional<StoredInputs> inputs_;
  bool begins_ = false;  // the section begins with the frame that was already read
  bool is_over_ = false;
  bool is_waiting_ = false;  // a frame was read that does not belong to a section yet
  std::uint64_t skipped_ = 0;
};

}  // namespace reorient
