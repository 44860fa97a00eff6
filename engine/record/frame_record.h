// SPDX-License-Identifier: MIT
// Observations, belief, decisions, requests and costs of one frame: plain data that observers read but cannot
// change. Reused from frame to frame; data that is expensive to copy is filled only if an observer requests it
// (topics.h).
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/parameters/parameter.h"
#include "engine/record/image_bytes.h"
#include "engine/record/topics.h"
#include "engine/script/script_host.h"
#include "engine/script/script_output.h"
#include "engine/world/application_state.h"
#include "engine/world/body_claims.h"
#include "engine/world/commands.h"
#include "engine/world/names.h"
#include "engine/world/world.h"
#include "geometry/bytes.h"
#include "geometry/transform.h"
#include "localization/measurement/measurement_model.h"
#include "perception/field/percepts.h"
#include "perception/room/room_awareness.h"
#include "robots/robot.h"

namespace reorient {

/// A camera's frame, without the pixels.
struct CameraRecord {
  double time = 0.0;  ///< s
  CameraModel camera;
  Isometry3 robot_from_camera = Isometry3::Identity();  ///< in the robot's frame *now*, not at `time`
  int width = 0;                                        ///< of the image, pixels
  int height = 0;
};
template <typename Visit, ConstOr<CameraRecord> T>
void fields(Visit&& visit, T& camera) {
  visit(camera.time, camera.camera, camera.robot_from_camera, camera.width, camera.height);
}

/// The inputs.
struct InputRecord {
  std::optional<CameraRecord> upper;
  std::optional<CameraRecord> lower;
  BodySample body;
  Pose2 odometry;
  int body_samples = 0;  ///< number of additional, more frequent samples of the body
  ReportedPosture reported_posture = ReportedPosture::unknown;
  bool external_belief = false;
  std::optional<HeadCamera> room_camera;    ///< camera used for the room; nothing: no camera
  std::optional<InitialPose> initial_pose;  ///< as it was set
  std::vector<Message> messages;            ///< of teammates
  bool half_time = false;  ///< the teams changed sides before this frame, so all its values are in the new axes
};
template <typename Visit, ConstOr<InputRecord> T>
void fields(Visit&& visit, T& in) {
  visit(in.upper, in.lower, in.body, in.odometry, in.body_samples, in.reported_posture, in.external_belief,
        in.half_time, in.room_camera, in.initial_pose, in.messages);
}

/// A granted reorientation: the paper's Fig. 6.
struct ReorientationRecord {
  Reorientation reorientation = Reorientation::flip_pose;
  Issuer issuer;
  PoseBelief belief_before;
  PoseBelief belief_after;
};
template <typename Visit, ConstOr<ReorientationRecord> T>
void fields(Visit&& visit, T& record) {
  visit(record.reorientation, record.issuer, record.belief_before, record.belief_after);
}

/// Topic::pose_particles.
struct PoseParticlesRecord {
  std::vector<Pose2> particles;  ///< at the end of the frame
  std::vector<Pose2> before;     ///< before this frame's reorientation; empty without one
};
template <typename Visit, ConstOr<PoseParticlesRecord> T>
void fields(Visit&& visit, T& record) {
  visit(record.particles, record.before);
}

/// Topic::room. Empty if room awareness is off.
struct RoomRecord {
  ModelBasis basis;
  double half_width = 0.0;               ///< rad, of the virtual field of view
  double goal_half_width = 0.0;          ///< rad
  std::optional<double> center_of_view;  ///< rad, direction on the wall according to the belief
  Light light;
  std::vector<TileModel> model;
  std::vector<PerceivedTile> perceived;
  std::vector<ComparedPlace> compared;  ///< of `perceived`: distances to the model; empty if the view was not evaluated
  /// Contribution of each tile of the wall to World::confidence.evidence, in log-odds: positive for the mirrored pose,
  /// see RoomAwareness::tile_evidence(). Before the frame's reorientation, if any, as `perceived` and `compared` are.
  std::vector<double> evidence;
  std::vector<ViewParticle> particles;  ///< of the view filter; empty if it is a grid
  std::vector<ViewCell> cells;          ///< of the grid; empty if the filter uses particles
  std::vector<ViewCluster> clusters;
};
template <typename Visit, ConstOr<RoomRecord> T>
void fields(Visit&& visit, T& room) {
  visit(room.basis, room.half_width, room.goal_half_width, room.center_of_view, room.light, room.model, room.perceived,
        room.compared, room.evidence, room.particles, room.cells, room.clusters);
}

/// Topic::application.
struct ApplicationRecord {
  std::shared_ptr<const ApplicationInterface> declared = std::make_shared<ApplicationInterface>();
  std::vector<ValueState> values;      ///< in the order of the declarations, as behaviors read them
  std::vector<ActionStatus> actions;   ///< in the order of the declarations, after this frame's requests
  std::vector<ActionRecord> requests;  ///< of this frame

  /// Copies the state at the end of a frame.
  void take(const ApplicationState& state);

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    if constexpr (Archive::kReads) {
      ApplicationInterface declared;
      archive(declared);
      self.declared = std::make_shared<const ApplicationInterface>(std::move(declared));
    } else {
      archive(*self.declared);
    }
    archive(self.values, self.actions, self.requests);
    if constexpr (Archive::kReads) self.check();
  }

 private:
  void check() const;
};

/// Topic::images: views of the robot's pixels, valid as long as its frame; or of this record's own copy.
struct ImagesRecord {
  ImageView upper;
  ImageView lower;
  std::array<std::vector<std::uint8_t>, 2> own;

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive_image(archive, self.upper, self.own[0]);
    archive_image(archive, self.lower, self.own[1]);
  }
};

/// The stages of a frame, in their order.
enum class Stage { inputs, field, localization, room, behaviors, record };
inline constexpr int kStageCount = 6;
std::string_view to_string(Stage stage);

/// Topic::costs: depends on the computer, so it is part of neither decisions nor digests.
struct CostsRecord {
  std::array<double, kStageCount> seconds{};  ///< by stage, in wall-clock time
  std::vector<MachineCost> machines;
};
template <typename Visit, ConstOr<CostsRecord> T>
void fields(Visit&& visit, T& costs) {
  visit(costs.seconds, costs.machines);
}

/// Topic::feature_fits, of the percepts of the upper and of the lower camera at the believed pose, before the frame's
/// reorientation. Empty with an external localization.
using FeatureFitsRecord = std::array<FeatureFits, 2>;

struct PostureChange {
  Posture from = Posture::upright;
  Posture to = Posture::upright;
};
template <typename Visit, ConstOr<PostureChange> T>
void fields(Visit&& visit, T& change) {
  visit(change.from, change.to);
}

struct FrameRecord {
  Topics filled = Topics::always();
  std::shared_ptr<const NameTable> names = std::make_shared<NameTable>();  ///< names of all NameIds

  InputRecord inputs;
  World world;
  std::array<FieldPercept, 2> percepts;  ///< of the upper and of the lower camera

  std::vector<MachineStatus> machines;  ///< in the order of loading
  std::vector<TransitionRecord> transitions;
  std::vector<NameId> published;  ///< by the active states

  std::vector<CommandRecord> commands;
  std::vector<Lease> leases;  ///< all active leases
  std::vector<Lease> begun;   ///< leases that were not held in the previous frame
  std::optional<ReorientationRecord> reorientation;

  Answer answer;
  std::vector<PartClaim> claims;  ///< which behavior moves which part of the body, and which one did not get it

  std::optional<PostureChange> posture_change;
  std::vector<LogRecord> logs;
  std::vector<FaultRecord> faults;
  std::vector<ReloadRecord> reloads;
  std::vector<ParameterOutcome> parameter_changes;
  ApplicationRecord application;

  ImagesRecord images;
  PoseParticlesRecord pose_particles;
  RoomRecord room;
  std::vector<OpenCondition> conditions;
  std::vector<Parameter> parameters;
  CostsRecord costs;
  FeatureFitsRecord feature_fits;

  const std::string& name(NameId id) const { return (*names)[id]; }

  /// Copies the images' pixels into the record, so that it outlives the robot's frame. For a copy of a record, call it
  /// while the original exists.
  void own_images();
};

}  // namespace reorient
