// One frame, from the inputs to the answer: the order in which everything happens.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/core_parameters.h"
#include "engine/frame_inputs.h"
#include "engine/parameters/parameter_registry.h"
#include "engine/record/frame_record.h"
#include "engine/script/behaviors.h"
#include "engine/world/arbiter.h"
#include "engine/world/external_belief.h"
#include "engine/world/posture.h"
#include "engine/world/repeated_pose.h"
#include "engine/world/world_tracker.h"
#include "geometry/bytes.h"
#include "localization/pose_filter.h"
#include "localization/search/pose_search.h"
#include "localization/tracking/gravity_bias.h"
#include "localization/tracking/pose_tracker.h"
#include "perception/field/field_features.h"
#include "perception/room/room_awareness.h"
#include "robots/robot_body.h"

namespace reorient {

/// What a run begins with.
struct FrameSetup {
  FieldDimensions field;
  RobotBody body{};
  std::uint64_t seed = 1;
  bool room_awareness = true;  ///< false: no view of the room, confidences stay at zero
  ScriptTexts scripts{"the scripts"};
  std::vector<std::string> behaviors;       ///< to be loaded: "orientation", or a file below the scripts' root
  std::vector<ParameterChange> parameters;  ///< overrides of defaults; names that nobody declares are kept
  std::optional<SavedModel> model{};        ///< of the room, learned before
};

/// The engine. Everything that it does follows from its setup and the inputs: the same ones give the same records.
class FrameLoop {
 public:
  /// Throws std::runtime_error (of a script: ScriptError, of a model: UnfitModel) with one line.
  explicit FrameLoop(FrameSetup setup);
  /// Goes on from what save() wrote. Throws BadBytes.
  explicit FrameLoop(std::span<const std::byte> state);
  FrameLoop(const FrameLoop&) = delete;
  FrameLoop& operator=(const FrameLoop&) = delete;

  /// One frame. `wanted`: topics that somebody reads beyond those that are always filled. The record is valid until the
  /// next call.
  const FrameRecord& step(const FrameInputs& inputs, Topics wanted = {});

  /// Of the last frame, or of none.
  const FrameRecord& record() const { return record_; }

  /// Between two frames: all that decides what comes next, appended as bytes. The frames that follow are the same for
  /// this loop and for one that is made of the bytes, in whatever process of the same program.
  void save(std::vector<std::byte>& state) const;

  // Between frames, for those who list and check.
  std::vector<Parameter> parameters() const { return registry_.list(); }
  std::vector<const MachineDefinition*> machines() const { return behaviors_.host().definitions(); }
  const ScriptTexts& scripts() const { return behaviors_.host().texts(); }

 private:
  explicit FrameLoop(ByteReader&& state);
  template <typename Archive>
  void archive(Archive& archive);

  void take_inputs(const FrameInputs& inputs);
  void feel_body();
  void feel_gravity(const BodySample& body);
  void see_field();
  void localize();
  std::array<CameraPercept, 2> percepts_of_cameras() const;
  double bias_deviation(const std::array<CameraPercept, 2>& seen) const;
  bool is_pose_known() const;
  void search_pose(const std::array<CameraPercept, 2>& seen, const std::optional<SeenView>& view);
  std::optional<SensedBelief> take_external_belief();
  void go_on_by_ourselves();
  SensedBelief locate_ourselves();
  void follow_jump(BeliefJump jump);
  void look_at_room();
  void describe_world();
  void describe_room();
  void decide();
  void rearrange(const CommandRecord& granted);
  void flip_between_equals();
  void answer();
  void complete_record();

  std::uint64_t declare_parameters(const std::vector<ParameterChange>& overrides);
  void take_parameters(const std::vector<ParameterChange>& changes);
  void change_sides();
  void take_told(const Told& told);
  void fill_room();
  void append_poses(std::vector<Pose2>& poses) const;
  Pose2 moved_since(const CameraFrame& frame) const;

  const World& world() const { return world_tracker_.world(); }

  static constexpr std::size_t kUpper = 0, kLower = 1;  ///< in arrays with one element for each camera

  ParameterRegistry registry_;
  CoreParameters parameters_;
  ScriptLimits limits_;
  std::uint64_t revision_;             ///< of the registry, that the modules have
  std::uint64_t listed_revision_ = 0;  ///< that the record lists

  std::array<FieldFeatures, 2> field_features_;  ///< of the upper and the lower camera
  PoseFilter pose_filter_;
  PoseTracker pose_tracker_;
  GravityBias gravity_bias_;
  PoseSearch pose_search_;
  bool was_known_ = false;  ///< the pose, in the frame before
  std::optional<RoomAwareness> room_;
  Arbiter arbiter_;
  PostureEstimator posture_;
  RepeatedPose repeated_pose_;
  RobotBody body_;
  bool asked_to_get_up_ = false;  ///< in the frame before
  ExternalBeliefReader external_reader_;
  bool external_belief_ = false;          ///< this frame, or the one before, goes by somebody else's localization
  double without_external_belief_ = 0.0;  ///< s for which none could be read since then
  bool has_read_belief_ = false;          ///< an external one, in this frame
  Behaviors behaviors_;

  const Observation* observation_ = nullptr;  ///< while a frame runs
  std::optional<Pose2> last_odometry_;
  Pose2 odometry_step_;
  std::vector<CoveredArea> covered_;
  WorldTracker world_tracker_;
  FrameRecord record_;
};

}  // namespace reorient
