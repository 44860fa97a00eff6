// SPDX-License-Identifier: MIT
// Updates the world that behaviors read from observations. The engine and the simulated world of scripted tests use the
// same rules, so that no scripted test passes for a world that the engine never produces.
#pragma once

#include <optional>

#include "engine/world/arbiter.h"
#include "engine/world/room_status.h"
#include "engine/world/world.h"
#include "localization/particles/pose_clusters.h"

namespace reorient {

/// Result of the posture estimator.
struct SensedPosture {
  Posture now = Posture::upright;
  Posture before = Posture::upright;  ///< previous posture
  double since = 0.0;                 ///< s, start of the current posture
};

/// Observations of the field, and the head's angles.
struct SensedField {
  HeadAngles head;
  int goal_posts = 0;
  int line_points = 0;
  int intersections = 0;
  std::optional<Eigen::Vector2d> ball{};  ///< m, in the frame of the robot
};

/// Whether the belief moved as the odometry measured.
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
  /// The teams change sides: the believed pose gets the coordinates of the mirrored pose.
  void change_sides();
  void take_referee(const RefereeState& referee);
  /// An operator or another program set the pose.
  void take_initial_pose() { world_.pose_known = true; }
  /// Whether a disturbance (World::disturbed) began or ended.
  bool take_posture(const SensedPosture& posture);
  /// `moved`: by the odometry, since the previous frame.
  BeliefJump take_belief(const SensedBelief& sensed, const Pose2& moved, const PoseClusterParameters& clusters);
  /// Whether the belief of an external localization counts as known.
  void take_pose_known(bool known) { world_.pose_known = known; }
  void take_camera_bias(const CameraBias& bias) { world_.camera_bias = bias; }
  /// Permitted uses of the views of this frame. The arbitration is the last frame's: what behaviors paused then
  /// is paused now. Behaviors have not yet checked a pose that is set in this frame, and at a low image rate one image
  /// can train much of the room at a wrong position: `is_judged` is false then.
  void permit_views(const Arbitration& last, bool is_judged);
  /// An image was taken, and the room was trained with it if that is permitted.
  void take_view();
  void take_room(const Confidences& confidence, const InformativeViews& views);
  void take_field(const SensedField& seen);
  void take_head(const HeadAngles& head);
  /// The last step before behaviors read the world.
  void judge_room(const RoomStatusParameters& parameters);
  /// After behaviors have read the world: the request that the robot gets.
  void take_request(const Request& request) { world_.motion = after_request(world_.motion, request.walk); }

  /// The belief after a reorientation. After a reset the orientation is not known; a flip or a purge confirms it.
  void take_reorientation(Reorientation reorientation, const PoseBelief& after);
  /// As take_reorientation() if the belief is external and the engine reorients its own copy.
  void take_flip(const PoseBelief& after) { world_.pose = after; }

  /// Sets the training time of the background model, before this run or with another wall: s.
  void set_trained_seconds(double seconds) { world_.trained_seconds = seconds; }

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.world_);
  }

 private:
  World world_;
};

/// The request to the robot in this world: reduced where the referee or the body does not permit the behaviors'
/// requests.
Request permitted(Request request, const World& world);

}  // namespace reorient
