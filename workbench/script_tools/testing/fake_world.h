// SPDX-License-Identifier: MIT
// The world of a scripted test, with its own clock. The test sets what the robot senses; all else follows
// by the engine's own rules (engine/world/world_tracker.h).
#pragma once

#include <set>
#include <string>
#include <string_view>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/language/world_fields.h"
#include "engine/world/arbiter.h"
#include "engine/world/room_status.h"
#include "engine/world/world_tracker.h"

namespace reorient {

/// Inputs that a scripted test cannot set: the robot stands still and receives images.
struct FakeSenses {
  Pose2 moved{};              ///< by the odometry, since the previous frame
  bool is_pose_told = false;  ///< the pose was set in this frame
  bool sees = true;           ///< there is an image
  bool knows_tiles = true;    ///< known tiles of the wall are in it
};

class FakeWorld {
 public:
  /// A robot that has stood on the field for so long, s. The parameters that the rules use become those of
  /// `parameters`, which must not outlive this.
  explicit FakeWorld(ParameterRegistry& parameters, double stood_for = 60.0);
  FakeWorld(const FakeWorld&) = delete;
  FakeWorld& operator=(const FakeWorld&) = delete;

  /// As `set_world` of a test, from the next frame on. A value that would follow from others stays as it is set until a
  /// granted command changes it. Throws as write_world(), and for the clock, which is the test bench's.
  void set(std::string_view table, std::string_view name, const WorldValue& value);
  /// The next frame, up to where behaviors see it, at this time (s). `last`: the arbitration of the frame before.
  const World& begin_frame(double time, const Arbitration& last, const FakeSenses& senses = {});
  /// What the granted command does.
  void end_frame(const Arbitration& arbitration);

  const World& world() const { return world_; }

 private:
  bool is_set(const char* field) const { return set_.contains(field); }
  void sense_sides(WorldTracker& tracker);
  void judge_room();
  World derived(const WorldTracker& tracker) const;

  ConfidenceParameters confidence_parameters_;
  RoomStatusParameters room_status_parameters_;
  World world_;                 // of the last frame, and what was set since then
  std::set<std::string> set_;   // fields that the test has set
  Pose2 believed_;              // at the end of the last frame
  bool is_pose_set_ = false;    // since then
  bool sides_changed_ = false;  // in the last frame
  SensedPosture posture_;
};

}  // namespace reorient
