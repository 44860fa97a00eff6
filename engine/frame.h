// One frame, from the camera to the robot's next request: the order in which everything happens.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/core_parameters.h"
#include "engine/digest.h"
#include "engine/script/script_host.h"
#include "engine/world/arbiter.h"
#include "engine/world/command.h"
#include "engine/world/robot_state.h"
#include "engine/world/world.h"
#include "localization/pose_filter.h"
#include "perception/field/field_features.h"
#include "perception/room/room_awareness.h"
#include "robots/robot.h"

namespace reorient {

/// The pose particles around one granted reorientation: the paper's Fig. 6.
struct Rearrangement {
  double time = 0.0;  ///< s
  Command command = Command::flip_pose;
  std::vector<Pose2> particles_before;
  std::vector<Pose2> particles_after;
  std::optional<GroundTruth> truth;
  PoseBelief belief_before;
  PoseBelief belief_after;
};

struct FrameOptions {
  std::uint64_t seed = 1;
  bool room_awareness = true;  ///< false: no view of the room, confidences stay at zero
};

class FrameLoop {
 public:
  /// All references must outlive the loop; `parameters` may change between two frames.
  FrameLoop(Robot& robot, ScriptHost& scripts, const CoreParameters& parameters, const FieldDimensions& field,
            const FrameOptions& options);

  /// Runs one frame. False: the robot has no further frame.
  bool step();

  // What the last frame saw, believed and did.
  const Observation& observation() const { return observation_; }
  const Eigen::Isometry3d& robot_from_camera() const { return robot_from_camera_; }
  const FieldPercept& percept() const { return *percept_; }
  const PoseFilter& pose_filter() const { return pose_filter_; }
  const RoomAwareness* room() const { return room_ ? &*room_ : nullptr; }
  const World& world() const { return world_; }
  const ScriptOutput& script_output() const { return *script_output_; }
  const std::vector<CommandRecord>& commands() const { return arbitration_->records; }
  const std::optional<Rearrangement>& rearrangement() const { return rearrangement_; }
  /// Over all observations, beliefs and commands so far.
  const Digest& digest() const { return digest_; }

 private:
  void take_parameters();
  void measure_state();
  void see_field();
  void localize();
  void look_at_room();
  void describe_world();
  void decide();
  void set_initial_pose(const Pose2& told);
  void rearrange(Command command);
  void fingerprint();

  Robot& robot_;
  ScriptHost& scripts_;
  const CoreParameters& parameters_;

  FieldFeatures field_features_;
  PoseFilter pose_filter_;
  std::optional<RoomAwareness> room_;
  Arbiter arbiter_;
  RobotState state_;

  Observation observation_;
  Eigen::Isometry3d robot_from_camera_ = Eigen::Isometry3d::Identity();
  std::optional<Pose2> last_odometry_;
  Pose2 odometry_step_;
  const FieldPercept* percept_;
  FieldPercept nothing_seen_;
  std::vector<CoveredArea> covered_;
  World world_;
  ScriptOutput nothing_said_;
  const ScriptOutput* script_output_;
  Arbitration nothing_asked_;
  const Arbitration* arbitration_;
  std::optional<Rearrangement> rearrangement_;
  Digest digest_;
};

}  // namespace reorient
