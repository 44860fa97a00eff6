// SPDX-License-Identifier: MIT
// A robot that footage drives. Each image becomes an observation, and the belief is the recorded pose, which can be
// made wrong on purpose. The robot carries out the engine's commands on the belief, like a localization with one pose.
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

/// A change of the belief at one time of the footage. Before it, the belief is the recorded pose.
struct BeliefChange {
  enum class Kind {
    told,   ///< an initial pose is set
    lifted  ///< the robot is in the air for `lifted_for`, and placed with the belief that it had before
  };
  Kind kind = Kind::told;
  double at = 0.0;          ///< s of the robot's time
  bool mirrored = false;    ///< whether the belief is the mirrored pose from then on
  double turned_by = 0.0;   ///< rad to the left, error of the belief's rotation from then on
  double lifted_for = 1.5;  ///< s; the images of this time are dropped
};
template <typename Visit, ConstOr<BeliefChange> T>
void fields(Visit&& visit, T& change) {
  visit(change.kind, change.at, change.mirrored, change.turned_by, change.lifted_for);
}
constexpr int enum_count(BeliefChange::Kind) { return 2; }

struct FootageOptions {
  /// Images per second, at equal intervals, instead of the recorded times.
  std::optional<double> images_per_second;
  /// Pose at the start. If only the rotation was recorded, the robot stays at this position.
  std::optional<Pose2> start;
  std::optional<BeliefChange> change;
  /// Number of frames that are skipped at the start; the clock counts them.
  std::uint64_t skipped = 0;
};

/// The belief of a localization with one pose: the recorded pose after a change and the commands of the engine.
class FootageBelief {
 public:
  void apply(const BeliefChange& change);
  void apply(Reorientation reorientation);
  Pose2 of(const Pose2& recorded) const;
  /// After a reset both the pose and the mirrored pose are possible.
  bool is_ambiguous() const { return is_ambiguous_; }

 private:
  bool is_mirrored_ = false, is_ambiguous_ = false;
  double turned_by_ = 0.0;  // rad
};

class FootageRobot : public Robot, public GroundTruthSource {
 public:
  /// Reads the first frame. Throws BadFootage if the footage has no frame after the skipped ones.
  FootageRobot(std::unique_ptr<FootageSource> source, const FootageOptions& options);

  bool observe(Observation& observation) override;
  void answer(const Answer& answer) override;

  /// Empty if the footage has no pose. Then the belief comes from the engine's own localization.
  std::optional<GroundTruth> truth() const override {
    return truth_ ? std::optional(GroundTruth{*truth_, false, is_carried_}) : std::nullopt;
  }

  /// The last frame that was read from the source; the first one before the first observe().
  const FootageFrame& frame() const { return frame_; }
  /// Why the footage ended early: one line; empty if it did not.
  const std::string& failure() const { return failure_; }
  std::uint64_t frames() const { return frames_; }
  double seconds() const { return time_; }   ///< engine time of the last frame
  bool is_over() const { return is_over_; }  ///< whether all images were read
  /// Whether the footage ended before the time of the change.
  bool missed_change() const { return is_over_ && options_.change && !is_changed_; }

 private:
  bool next_frame();
  void update_posture(Observation& observation);
  void report_belief(Observation& observation);

  std::unique_ptr<FootageSource> source_;
  FootageOptions options_;
  FootageFrame frame_;
  std::uint64_t frames_ = 0;  // read from the source
  double first_time_ = 0.0;   // s, on the footage's clock
  double time_ = 0.0;         // s, engine time of frame_
  double time_before_ = 0.0;  // s, engine time of the previous frame
  FootageBelief belief_;
  bool is_next_read_ = false;  // frame_ has not been observed yet
  bool is_started_ = false, is_over_ = false, is_changed_ = false, is_carried_ = false;
  std::optional<Pose2> truth_;
  Pose2 odometry_;
  std::string failure_;

  // Memory that the observation refers to, valid until the next one.
  std::array<ExternalBelief::Particle, 2> hypotheses_;
  std::vector<BodySample> body_samples_;
};

}  // namespace reorient
