// SPDX-License-Identifier: MIT
// A robot that is driven by footage: each image becomes an observation, and its belief is the recorded pose, put right
// or wrong on purpose. It carries out what the engine decides about the belief, as a localization with its own pose
// would.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "geometry/const_or.h"
#include "robots/footage/footage.h"
#include "robots/robot.h"
#include "robots/robot_instance.h"

namespace reorient {

/// What is done to the belief at one moment of a footage. Before it, the belief is the recorded pose.
struct BeliefChange {
  enum class Kind {
    told,   ///< somebody tells the robot where it is
    lifted  ///< the robot is held in the air for `lifted_for`, and put down with the belief that it had
  };
  Kind kind = Kind::told;
  double at = 0.0;          ///< s of the robot's time
  bool mirrored = false;    ///< the belief is the mirrored pose from then on
  double turned_by = 0.0;   ///< rad to the left, by which the belief's rotation is wrong from then on
  double lifted_for = 1.5;  ///< s; the images of that time are not seen
};
template <typename Visit, ConstOr<BeliefChange> T>
void fields(Visit&& visit, T& change) {
  visit(change.kind, change.at, change.mirrored, change.turned_by, change.lifted_for);
}
constexpr int enum_count(BeliefChange::Kind) { return 2; }

struct FootageOptions {
  /// Instead of the recorded times: so many images a second, evenly.
  std::optional<double> images_per_second;
  /// Where the robot starts. Where the rotation alone was recorded: where it stands all the time.
  std::optional<Pose2> start;
  std::optional<BeliefChange> change;
  /// So many frames are passed over first; the clock counts them.
  std::uint64_t skipped = 0;
};

/// What a localization with one pose makes of the recorded pose and of what the engine granted.
class FootageBelief {
 public:
  void apply(const BeliefChange& change);
  void apply(Reorientation reorientation);
  Pose2 of(const Pose2& recorded) const;
  /// After a reset: both the pose and its reflection are possible.
  bool is_ambiguous() const { return is_ambiguous_; }

 private:
  bool is_mirrored_ = false, is_ambiguous_ = false;
  double turned_by_ = 0.0;  // rad
};

class FootageRobot : public Robot, public GroundTruthSource {
 public:
  /// Reads the first frame. Throws BadFootage where there is none.
  FootageRobot(std::unique_ptr<FootageSource> source, const FootageOptions& options);

  bool observe(Observation& observation) override;
  void answer(const Answer& answer) override;

  /// Nothing where the footage does not say where the robot is: there the engine's own localization counts.
  std::optional<GroundTruth> truth() const override {
    return truth_ ? std::optional(GroundTruth{*truth_, false, is_carried_}) : std::nullopt;
  }

  /// The last image that was taken from the source: before the first observe(), the first one.
  const FootageFrame& frame() const { return frame_; }
  /// Why the footage ended before its end: one line; empty: it did not.
  const std::string& failure() const { return failure_; }
  std::uint64_t frames() const { return frames_; }
  double seconds() const { return time_; }   ///< of the last frame, the engine's
  bool is_over() const { return is_over_; }  ///< each image was seen
  /// The footage is over, and the belief was to change after its end.
  bool missed_change() const { return is_over_ && options_.change && !is_changed_; }

 private:
  bool next_frame();
  void update_posture(Observation& observation);
  void tell_belief(Observation& observation);

  std::unique_ptr<FootageSource> source_;
  FootageOptions options_;
  FootageFrame frame_;
  std::uint64_t frames_ = 0;  // taken from the source
  double first_time_ = 0.0;   // s, on the footage's clock
  double time_ = 0.0;         // s, the engine's, of frame_
  double time_before_ = 0.0;  // s, of the frame before
  FootageBelief belief_;
  bool is_next_read_ = false;  // frame_ was not observed yet
  bool is_started_ = false, is_over_ = false, is_changed_ = false, is_carried_ = false;
  std::optional<Pose2> truth_;
  Pose2 odometry_;
  std::string failure_;

  // What the observation looks at, until the next one.
  std::array<ExternalBelief::Particle, 2> hypotheses_;
  std::vector<BodySample> body_samples_;
};

}  // namespace reorient
