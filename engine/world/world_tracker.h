// SPDX-License-Identifier: MIT
// From what was sensed to the world that behaviors see. The engine and the fake world of scripted tests share these
// rules, so that no scripted test passes for a world that the engine never produces.
#pragma once

#include <optional>

#include "engine/world/arbiter.h"
#include "engine/world/room_status.h"
#include "engine/world/world.h"
#include "localization/particles/pose_clusters.h"

namespace reorient {

/// What a posture estimator says.
struct SensedPosture {
  Posture now = Posture::upright;
  Posture before = Posture::upright;  ///< the one before the present one
  double since = 0.0;                 ///< s, when the present one began
};

/// What the cameras show of the field, and where the head is.
struct SensedField {
  HeadAngles head;
  int goal_posts = 0;
  int line_points = 0;
  int intersections = 0;
  std::optional<Eigen::Vector2d> ball{};  ///< m, in the frame of the robot
};

/// Whether the belief went on as the odometry says.
enum class BeliefJump { none, to_reflection, elsewhere };

class WorldTracker {
 public:
  WorldTracker(const FieldDimensions& field, const RobotBody& body, bool room_awareness)
      : world_(world_of(field, body)) {
    world_.room_awareness = room_awareness;
  }
  /// Continues from this world.
  explicit WorldTracker(const World& world) : world_(world) {}

  const World& world() const { return world_; }

  // One frame, in this order. Times in s.

  void begin_frame(double time);
  /// The teams change sides: the believed pose gets the coordinates of the reflected place.
  void change_sides();
  void take_referee(const RefereeState& referee);
  /// An operator or another program set the pose.
  void take_initial_pose() { world_.pose_known = true; }
  /// Whether a disturbance (World::disturbed) began or ended.
  bool take_posture(const SensedPosture& posture);
  /// `moved`: by the odometry, since the frame before.
  BeliefJump take_belief(const SensedBelief& sensed, const Pose2& moved, const PoseClusterParameters& clusters);
  /// Whether the belief of an external localization counts as known.
  void take_pose_known(bool known) { world_.pose_known = known; }
  void take_camera_bias(const CameraBias& bias) { world_.camera_bias = bias; }
  /// What may be done with the views of this frame. The arbitration is the last frame's: what behaviors paused then
  /// rests now. They have not yet judged a pose that is told in this frame, and where images come seldom one of them
  /// can paint much of the room at the wrong place: `is_judged` is false then.
  void permit_views(const Arbitration& last, bool is_judged);
  /// An image was taken, and the room was trained with it if that is permitted.
  void take_view();
  void take_room(const Confidences& confidence, const InformativeViews& views);
  void take_field(const SensedField& seen);
  /// The last step before behaviors see the world.
  void judge_room(const RoomStatusParameters& parameters);

  /// The belief after a reorientation. After a reset the orientation is not known; a flip or a purge confirms it.
  void take_reorientation(Reorientation reorientation, const PoseBelief& after);
  /// The same where another localization holds the belief, and the engine turns its own copy of it.
  void take_flip(const PoseBelief& after) { world_.pose = after; }

  /// The background model has been trained for so long, before this run or with another wall: s.
  void set_trained_seconds(double seconds) { world_.trained_seconds = seconds; }

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.world_);
  }

 private:
  World world_;
};

/// What the robot is asked for in this world: less than the behaviors want where the referee or the body does not let
/// it.
Request permitted(Request request, const World& world);

}  // namespace reorient
