// SPDX-License-Identifier: MIT
// Who watches a run. Observers read records; none can change a frame.
#pragma once

#include <optional>

#include "engine/frame.h"
#include "engine/record/frame_record.h"
#include "geometry/const_or.h"
#include "robots/operator.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

/// What only those around the robot know of a frame: plain data, too.
struct SceneTruth {
  std::optional<GroundTruth> truth;  ///< where it is known, in the axes of the frame
  ScenarioRecord scenario;           ///< empty without a scenario
  double observing = 0.0;  ///< s in wall-clock time that the robot took to observe: a simulated one, to render
  double stepping = 0.0;   ///< s in wall-clock time that the engine took
};

template <typename Visit, ConstOr<SceneTruth> T>
void fields(Visit&& visit, T& scene) {
  visit(scene.truth, scene.scenario, scene.observing, scene.stepping);
}

class Observer {
 public:
  virtual ~Observer() = default;

  /// Before a frame: what goes into it, and the engine that it goes to. Valid during the call only.
  virtual void before(const FrameInputs& /*inputs*/, const FrameLoop& /*engine*/) {}

  /// The topics that it reads of this frame beyond those that are always filled; called after before().
  virtual Topics wanted() const { return {}; }

  /// Once a frame. Both are valid during the call only.
  virtual void observe(const FrameRecord& frame, const SceneTruth& scene) = 0;

  /// Once, when the run is over, with its last frame; not called where there was none.
  virtual void finish(const FrameRecord& /*last*/, const SceneTruth& /*scene*/) {}
};

}  // namespace reorient
