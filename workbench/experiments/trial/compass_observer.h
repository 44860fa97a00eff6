// SPDX-License-Identifier: MIT
// Compares all compasses in a trial: each has learned the room from right poses; now the light has changed and the
// robot looks around. Is the believed pose right, or its reflection?
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "perception/room/room_observation.h"
#include "workbench/experiments/peers/compass_look.h"
#include "workbench/experiments/peers/compass_methods.h"
#include "workbench/experiments/trial/trial_observer.h"
#include "workbench/run/observer.h"

namespace reorient {

/// Before the trial's clock starts, the compasses learn whenever the belief is right. Then there are two copies of
/// each: one gets the right pose, the other the mirrored pose, both with the error of the pose filter. The right pose
/// is the belief or, after a robot was placed on its mirrored pose, the reflection of the belief. After some seconds
/// for the adaptation to the light, the time is divided into periods of looking around. A period does not count if the
/// robot is not upright, or if the belief is not right or mirrored all the time. With `mirrored_after` both copies
/// first see the right pose for a while, as before a robot is placed on its mirrored pose.
class CompassObserver : public Observer {
 public:
  /// `trial` judges the same run and observes each frame before this one does.
  CompassObserver(const CompassParameters& parameters, const TrialObserver& trial, std::uint64_t seed);

  Topics wanted() const override { return {Topic::images}; }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  const std::vector<CompassLook>& looks() const { return looks_; }

 private:
  void compare(double time);
  void begin_look(double time);
  void learn();
  std::optional<Pose2> right_pose(const Pose2& belief, const Pose2& truth) const;

  using Compasses = std::vector<std::unique_ptr<OrientationCompass>>;

  struct Flips {
    bool if_right = false, if_reflected = false;
  };

  const TrialObserver& trial_;
  ComparisonParameters comparison_;
  Compasses right_;      ///< they learned the room, and see the belief
  Compasses reflected_;  ///< the same, and see its reflection; empty: the clock has not started
  std::vector<CoveredArea> covered_;
  RoomObservation view_;
  std::vector<CompassLook> looks_;
  CompassLook look_{};
  std::array<Flips, kCompassMethods.size()> flips_{};  ///< by each method's own rule, in the present look
  std::optional<double> learning_began_;               ///< s, time of the first frame that was learned
  std::size_t next_time_ = 0;                          ///< of kLookTimes, the time of the next evaluation
  double look_began_ = 0.0;                            ///< s since the clock started
  bool is_looking_ = false;                            ///< the current period counts so far
};

}  // namespace reorient
