// SPDX-License-Identifier: MIT
// One frame from inputs to answer: runs the stages in their order.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/carried.h"
#include "engine/core_parameters.h"
#include "engine/frame_inputs.h"
#include "engine/parameters/parameter_registry.h"
#include "engine/record/frame_record.h"
#include "engine/script/behaviors.h"
#include "engine/stages.h"
#include "geometry/bytes.h"
#include "localization/localizer.h"
#include "perception/room/room_awareness.h"
#include "robots/robot_body.h"

namespace reorient {

/// Initial configuration of a run.
struct FrameSetup {
  FieldDimensions field;
  RobotBody body{};
  std::uint64_t seed = 1;
  bool room_awareness = true;  ///< false: no view of the room, confidences stay at zero
  ScriptTexts scripts{"the scripts"};
  std::vector<std::string> behaviors;       ///< to be loaded: "orientation", or a file below the scripts' root
  std::vector<ParameterChange> parameters;  ///< overrides of defaults; undeclared names are stored
  std::optional<SavedModel> model{};        ///< of the room, learned in an earlier run
  ApplicationInterface application{};       ///< values and actions of the application
};

/// The engine. It is deterministic: the same setup and inputs give the same records.
class FrameLoop {
 public:
  /// Throws std::runtime_error (of a script: ScriptError, of a model: UnfitModel) with one line.
  explicit FrameLoop(FrameSetup setup);
  /// Continues from the bytes that save() wrote. Throws BadBytes.
  explicit FrameLoop(std::span<const std::byte> state);
  FrameLoop(const FrameLoop&) = delete;
  FrameLoop& operator=(const FrameLoop&) = delete;

  /// One frame. `requested`: topics besides those that are always filled. The record is valid until the
  /// next call.
  const FrameRecord& step(const FrameInputs& inputs, Topics requested = {});

  /// Of the last frame; empty before the first.
  const FrameRecord& record() const { return record_; }

  /// Appends the whole state between two frames as bytes. The following frames are the same for this loop and for a
  /// loop that is made from the bytes, in any process of the same program.
  void save(std::vector<std::byte>& state) const;

  // For use between frames, for lists and checks.
  std::vector<Parameter> parameters() const { return registry_.list(); }
  std::vector<const MachineDefinition*> machines() const { return behaviors_.host().definitions(); }
  const ScriptTexts& scripts() const { return behaviors_.host().texts(); }
  const ApplicationInterface& application() const { return carried_.application.declared(); }

 private:
  explicit FrameLoop(ByteReader&& state);
  template <typename Archive>
  static void archive(Archive& archive, auto& self);

  std::uint64_t declare_parameters(const std::vector<ParameterChange>& overrides);
  void take_inputs(const FrameInputs& inputs);
  void take_parameters(const std::vector<ParameterChange>& changes);
  void take_external_inputs(const ExternalInputs& external, bool has_external_belief);
  void take_application(const ExternalInputs& external);
  void set_pose(const InitialPose& initial, bool has_external_belief);
  void change_sides();
  void follow_posture(const SensedPosture& posture, const BodySample& body);
  CameraPercepts see_field(const Observation& observation);
  void localize(const Observation& observation, const CameraPercepts& seen);
  SensedBelief locate_ourselves(const Observation& observation, const CameraPercepts& seen, const Pose2& odometry_step);
  void see_room(const Observation& observation, const CameraPercepts& seen);
  Decision act();
  void describe_room();
  void append_poses(std::vector<Pose2>& poses) const;
  void complete_record(const Observation& observation, const Decision& decision);
  void fill_feature_fits();
  void fill_room();

  const World& world() const { return carried_.world.world(); }

  ParameterRegistry registry_;
  CoreParameters parameters_;
  ScriptLimits limits_;
  std::uint64_t revision_;             ///< revision of the registry that the modules use
  std::uint64_t listed_revision_ = 0;  ///< revision that the record lists

  RobotBody body_;
  PostureEstimator posture_;
  FieldVision field_vision_;
  Localizer localizer_;
  ExternalBeliefReader external_reader_;
  std::optional<RoomAwareness> room_;
  RepeatedPose repeated_pose_;
  Carried carried_;
  Behaviors behaviors_;
  Arbiter arbiter_;

  std::vector<CoveredArea> covered_;  ///< memory of see_room()
  FrameRecord record_;
};

}  // namespace reorient
