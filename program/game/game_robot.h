// SPDX-License-Identifier: MIT
// One robot of a simulated game: its body, its engine, and what it has done.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/frame.h"
#include "engine/record/record_bytes.h"
#include "robots/simulator/game/collisions.h"
#include "robots/simulator/simulator.h"
#include "workbench/run/observer.h"

namespace reorient {

/// Converts between the axes of the hall and those of a team: the teams play toward opposite goals. Team 0 plays in the
/// axes of the hall.
inline Pose2 in_axes_of(int team, const Pose2& pose) { return team == 0 ? pose : reflect(pose); }

class GameRobot {
 public:
  /// `number`: of the player, from 1.
  GameRobot(int team, int number, std::unique_ptr<Simulator> simulator, FrameSetup setup);

  int team() const { return team_; }
  int number() const { return number_; }
  Simulator& simulator() { return *simulator_; }
  const Simulator& simulator() const { return *simulator_; }

  /// The inputs of the next frame from outside of the robot.
  ExternalInputs& inputs() { return inputs_.external; }
  /// Places the robot at this pose (axes of the hall), as the operator who then sets the pose.
  void place(const Pose2& pose);
  /// Shows all later frames to the observer, which must outlive this robot.
  void show_to(Observer& observer) { observer_ = &observer; }
  /// Observes the world and runs the engine for one frame.
  void play(const SharedWorld& world);

  /// As others meet it.
  Player player() const;
  MovingRobot moving() const;

  const ApplicationInterface& application() const { return engine_->application(); }
  const FrameRecord& record() const { return engine_->record(); }
  std::string digest() const { return digest_.digest().hex(); }
  /// Whether the believed pose is near the true one, and not the mirrored one.
  bool has_correct_belief() const;
  std::uint64_t flips() const { return flips_; }

 private:
  int team_, number_;
  std::unique_ptr<Simulator> simulator_;
  std::unique_ptr<FrameLoop> engine_;
  FrameInputs inputs_;
  Observer* observer_ = nullptr;
  SceneTruth scene_;
  RecordDigest digest_;
  std::uint64_t flips_ = 0;
};

}  // namespace reorient
