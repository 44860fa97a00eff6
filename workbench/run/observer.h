// SPDX-License-Identifier: MIT
// Observers of a run. They read records and cannot change a frame.
#pragma once

#include <optional>

#include "engine/frame.h"
#include "engine/record/frame_record.h"
#include "geometry/const_or.h"
#include "robots/operator.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

/// The part of a frame that the robot cannot know: plain data.
struct SceneTruth {
  std::optional<GroundTruth> truth;  ///< if it is known, in the axes of the frame
  ScenarioRecord scenario;           ///< empty without a scenario
  double observing = 0.0;  ///< s in wall-clock time that the robot took to observe (a simulated robot: to render)
  double stepping = 0.0;   ///< s in wall-clock time that the engine took
  double showing = 0.0;    ///< s in wall-clock time that the observers of the frame before took; not recorded
};

template <typename Visit, ConstOr<SceneTruth> T>
void fields(Visit&& visit, T& scene) {
  visit(scene.truth, scene.scenario, scene.observing, scene.stepping);
}

class Observer {
 public:
  virtual ~Observer() = default;

  /// Before a frame: its inputs and the engine. Valid during the call only.
  virtual void before(const FrameInputs& /*inputs*/, const FrameLoop& /*engine*/) {}

  /// The topics of this frame that it reads in addition to those that are always filled; called after before().
  virtual Topics wanted() const { return {}; }

  /// Called once a frame. Both are valid during the call only.
  virtual void observe(const FrameRecord& frame, const SceneTruth& scene) = 0;

  /// Called once at the end of the run with its last frame; not called without frames.
  virtual void finish(const FrameRecord& /*last*/, const SceneTruth& /*scene*/) {}
};

}  // namespace reorient
