// What behaviours can do: the functions behind command, head, walk and motion. What they can see: world_fields.h.
#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "engine/script/language/script_language.h"
#include "engine/world/commands.h"

namespace reorient {

/// What the behaviours want in one frame. The greatest priority has each channel; the first one at a tie.
struct BehaviorOutput {
  std::vector<ReorientationRequest> commands;
  Request request;  ///< to the robot
};

class BehaviorActions : public ScriptActions {
 public:
  void begin_frame(ScriptOutput& output, double time) override;
  const BehaviorOutput& output() const { return output_; }

  // command
  void flip_pose() { reorient_by(Reorientation::flip_pose); }
  void purge_reflection() { reorient_by(Reorientation::purge_reflection); }
  void reset_orientation() { reorient_by(Reorientation::reset_orientation); }
  void pause_training() { pause(Pause::training); }
  void pause_evaluation() { pause(Pause::evaluation); }

  // head, walk, motion
  void look(double yaw, double pitch, std::optional<double> speed);
  void walk_with(double forward, double left, double turn);
  void stand() { walk_with(0.0, 0.0, 0.0); }
  void get_up();

 private:
  void reorient_by(Reorientation reorientation);
  void pause(Pause pause);

  BehaviorOutput output_;
  double head_priority_ = -std::numeric_limits<double>::infinity();
  double walk_priority_ = -std::numeric_limits<double>::infinity();
};

class BehaviorLanguage : public ScriptLanguage {
 public:
  ScriptKind kind() const override { return ScriptKind::behavior; }
  std::string_view folder() const override { return "behaviors"; }
  std::span<const WorldTable> tables() const override;
  std::span<const WorldField> world() const override;
  std::span<const ScriptFunction> functions() const override;
  BehaviorActions& actions() override { return actions_; }
  const BehaviorOutput& output() const { return actions_.output(); }

 private:
  BehaviorActions actions_;
};

}  // namespace reorient
