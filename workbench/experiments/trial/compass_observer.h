// SPDX-License-Identifier: MIT
// Asks every compass of a trial the same: it has learned the room from right poses, now the light is another one, and
// the robot looks about; is the believed pose right, or its reflection?
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

/// Before the trial's clock starts the compasses learn, whenever the belief is right. From then on each of them is
/// there twice: one gets the right pose, the other the mirrored pose, both with the error that the pose filter has.
/// The right pose is the belief or, after a robot was placed on its mirrored pose, the reflection of the belief. After
/// a while in which they get used to the light, the time is cut into stretches of looking about; one in which the
/// belief is neither throughout, or the robot not upright, does not count. With `mirrored_after` both copies see the
/// right pose for a while first, as before a robot is placed on its mirrored pose.
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
  std::size_t next_time_ = 0;                          ///< of kLookTimes, at which they are asked next
  double look_began_ = 0.0;                            ///< s since the clock started
  bool is_looking_ = false;                            ///< a stretch is under way that counts so far
};

}  // namespace reorient
