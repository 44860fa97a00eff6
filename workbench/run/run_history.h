// SPDX-License-Identifier: MIT
// The history of a run for the pictures: curves, intervals of conditions, the first reorientations. Its memory is
// bounded: old curves are thinned, and adjacent intervals are joined.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "workbench/run/decision_threshold.h"
#include "workbench/run/observer.h"

namespace reorient {

/// One point of the curves.
struct ConfidencePoint {
  double time = 0.0;  ///< s
  double current = 0.0;
  double opposite = 0.0;
  double raw_current = 0.0;
  double raw_opposite = 0.0;
  double evidence = 0.0;  ///< log-odds of the mirrored pose against the believed pose
  RoomStatus status = RoomStatus::resting;
  double threshold = 0.0;  ///< log-odds at which an unconfirmed pose is decided; 0: unknown
};

/// The conditions whose intervals are stored.
enum class RunCondition { training, evaluation_paused, belief_reflected, lifted, down };
inline constexpr int kRunConditions = 5;

struct ConditionInterval {
  RunCondition condition = RunCondition::training;
  double from = 0.0;  ///< s
  double to = 0.0;
};

struct CommandMark {
  double time = 0.0;  ///< s
  Reorientation reorientation = Reorientation::flip_pose;
  bool granted = true;
};

/// The pose particles around one granted reorientation: the paper's Fig. 6.
struct ReorientationSnapshot {
  double time = 0.0;  ///< s
  Reorientation reorientation = Reorientation::flip_pose;
  std::optional<Pose2> truth;
  Pose2 belief_before;
  Pose2 belief_after;
  std::vector<Pose2> particles_before;
  std::vector<Pose2> particles_after;
};

class RunHistory : public Observer {
 public:
  Topics wanted() const override { return {Topic::pose_particles, DecisionThreshold::kTopic}; }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  const std::vector<ConfidencePoint>& points() const { return points_; }
  const std::vector<ConditionInterval>& intervals() const { return intervals_; }
  const std::vector<CommandMark>& commands() const { return commands_; }
  const std::vector<ReorientationSnapshot>& reorientations() const { return reorientations_; }

  /// Current number of frames for each point of the curves.
  std::uint64_t stride() const { return stride_; }
  std::uint64_t commands_left_out() const { return commands_left_out_; }              ///< the oldest
  std::uint64_t reorientations_left_out() const { return reorientations_left_out_; }  ///< the latest

  static constexpr std::size_t kMostPoints = 6000;
  static constexpr std::size_t kMostIntervals = 2000;
  static constexpr std::size_t kMostCommands = 2000;
  static constexpr std::size_t kMostReorientations = 10;

 private:
  void note_condition(RunCondition condition, bool holds, double time);
  void join_intervals();
  void keep_snapshot(const FrameRecord& frame, const SceneTruth& scene);

  DecisionThreshold threshold_;
  std::vector<ConfidencePoint> points_;
  std::uint64_t frames_ = 0;
  std::uint64_t stride_ = 1;
  std::vector<ConditionInterval> intervals_;
  std::vector<std::size_t> open_ = std::vector<std::size_t>(kRunConditions, kClosed);  ///< index of the interval
  double gap_ = 0.0;  ///< s; intervals with a smaller gap are joined
  std::vector<CommandMark> commands_;
  std::uint64_t commands_left_out_ = 0;
  std::vector<ReorientationSnapshot> reorientations_;
  std::uint64_t reorientations_left_out_ = 0;

  static constexpr std::size_t kClosed = static_cast<std::size_t>(-1);
};

}  // namespace reorient
