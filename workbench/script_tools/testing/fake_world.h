// SPDX-License-Identifier: MIT
// The world of a scripted test, with its own clock. The test sets what the robot senses; all other values are computed
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
  Pose2 moved{};             ///< odometry since the previous frame
  bool is_pose_set = false;  ///< the pose was set in this frame
  bool sees = true;          ///< there is an image
  bool knows_tiles = true;   ///< the image shows known tiles of the wall
};

class FakeWorld {
 public:
  /// A robot that has stood on the field for some time, in s. Binds the parameters of the rules to `parameters`, which
  /// must not outlive this.
  explicit FakeWorld(ParameterRegistry& parameters, double stood_for = 60.0);
  FakeWorld(const FakeWorld&) = delete;
  FakeWorld& operator=(const FakeWorld&) = delete;

  /// Sets a value from the next frame on, for `set_world` of a test. A derived value stays as set until a granted
  /// command changes it. Throws like write_world(), and for the clock, which only the test bench advances.
  void set(std::string_view table, std::string_view name, const WorldValue& value);
  /// Starts the next frame at this time (s), up to the world that behaviors see. `last`: the arbitration of the
  /// previous frame.
  const World& begin_frame(double time, const Arbitration& last, const FakeSenses& senses = {});
  /// Applies the granted command. `request`: what the robot gets.
  void end_frame(const Arbitration& arbitration, const Request& request = {});

  const World& world() const { return world_; }

 private:
  bool is_set(const char* field) const { return set_.contains(field); }
  void sense_sides(WorldTracker& tracker);
  void judge_room();
  World derived(const WorldTracker& tracker) const;

  ConfidenceParameters confidence_parameters_;
  RoomStatusParameters room_status_parameters_;
  World world_;                 // of the last frame, with the values set since then
  std::set<std::string> set_;   // fields that the test has set
  Pose2 believed_;              // at the end of the last frame
  HeadAngles head_;             // in the last frame
  WalkVelocity requested_;      // in the last frame, as the robot got it
  bool is_pose_set_ = false;    // since then
  bool sides_changed_ = false;  // in the last frame
  SensedPosture posture_;
};

}  // namespace reorient
