// SPDX-License-Identifier: MIT
// What the robot would have done in recorded frames with other parameters or scripts.
#pragma once

#include <functional>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/parameters/parameter.h"
#include "engine/script/script_texts.h"
#include "workbench/recording/comparison.h"
#include "workbench/recording/frame_source.h"
#include "workbench/run/run_loop.h"

namespace reorient {

struct WhatIfChanges {
  std::vector<ParameterChange> parameters;
  std::vector<ScriptEdit> scripts;
};

/// Adds the changes to the first frame at or after a time. From then on it removes recorded changes of the same
/// parameters and scripts, which would undo them.
class WhatIfSource : public InputSource {
 public:
  /// `from`: s of the robot.
  explicit WhatIfSource(WhatIfChanges changes, double from = -std::numeric_limits<double>::infinity())
      : changes_(std::move(changes)), from_(from) {}

  void add_to(FrameInputs& inputs) override;
  /// Adds them again: another engine plays the next frames.
  void begin_again() { has_begun_ = false; }
  bool has_begun() const { return has_begun_; }
  const WhatIfChanges& changes() const { return changes_; }

 private:
  const WhatIfChanges changes_;
  const double from_;
  bool has_begun_ = false;
};

/// Checks the frame in which the changes are added.
class RequireTaken : public Observer {
 public:
  /// `source` must outlive it.
  explicit RequireTaken(const WhatIfSource& source) : source_(source) {}

  /// Throws std::runtime_error with one line if one of the changes was refused.
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

 private:
  const WhatIfSource& source_;
  bool is_checked_ = false;
};

struct WhatIfQuestion {
  WhatIfChanges changes;
  double from = 0.0;  ///< s of the robot
  double to = std::numeric_limits<double>::infinity();
};

/// What a frame decides with, and the states of the machines.
struct WhatIfMoment {
  double evidence = 0.0;  ///< log-odds of the mirrored pose against the believed pose
  double current = 0.0;   ///< confidences
  double opposite = 0.0;
  RoomStatus status = RoomStatus::resting;
  std::vector<std::pair<std::string, std::string>> states;  ///< of a machine: its name and its state, if it has changed
};

struct WhatIfAnswer {
  struct Frame {
    double time = 0.0;  ///< s of the robot
    WhatIfMoment recorded, tried;
  };
  std::vector<Frame> frames;
  std::vector<ReplayComparison::Event> events;            ///< decisions from the beginning on
  std::optional<ReplayComparison::Event> first_decision;  ///< that only one of the two has
  /// The first frame in which the robot would have acted differently. After it, the recorded inputs differ from what it
  /// would have seen.
  std::optional<Difference> first_action;
  bool has_gap = false;  ///< frames are missing in between
};

struct WhatIfStopped : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// Replays the frames with the changes. Throws std::runtime_error with one line if a change is refused or if no frame
/// can be replayed; WhatIfStopped once `stop` returns true, which is asked before each frame.
WhatIfAnswer what_if(FrameSource& frames, const WhatIfQuestion& question, const std::function<bool()>& stop = {});

}  // namespace reorient
