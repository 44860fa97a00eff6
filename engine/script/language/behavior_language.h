// SPDX-License-Identifier: MIT
// Functions of behaviors: command, head, walk, motion and team. What behaviors can read: world_fields.h. The values and
// actions of an application: application_tables.h.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/script/language/script_language.h"
#include "engine/world/application_state.h"
#include "engine/world/arbiter.h"
#include "engine/world/commands.h"
#include "robots/robot.h"

namespace reorient {

/// Requests of the behaviors in one frame. Per channel the greatest priority wins; at a tie the first.
struct BehaviorOutput {
  std::vector<ReorientationRequest> commands;
  Request request;                     ///< to the robot
  std::vector<std::string> messages;   ///< to the teammates
  std::vector<ActionRequest> actions;  ///< of the application
};

class BehaviorActions : public ScriptActions {
 public:
  void begin_frame(ScriptOutput& output, double time) override;
  const BehaviorOutput& output() const { return output_; }
  /// Sets the messages of the next frame, which must outlive it.
  void set_messages(std::span<const Message> messages) { heard_ = messages; }

  /// Sets what the next frame reads about earlier commands. All must outlive it.
  void set_verdicts(const Arbiter* arbiter, const Names& names) {
    arbiter_ = arbiter;
    names_ = &names;
  }

  /// Of a machine, in messages.
  const std::string& name_of(NameId machine) const { return (*names_)[machine]; }

  // command
  void flip_pose() { reorient_by(Reorientation::flip_pose); }
  void purge_reflection() { reorient_by(Reorientation::purge_reflection); }
  void reset_orientation() { reorient_by(Reorientation::reset_orientation); }
  void pause_training() { pause(Pause::training); }
  void pause_evaluation() { pause(Pause::evaluation); }
  std::string_view command_state(std::string_view command);
  std::string command_reason(std::string_view command);
  double command_wait(std::string_view command);
  std::int64_t command_refusals(std::string_view command);

  // head, walk, motion
  void look(double yaw, double pitch, std::optional<double> speed);
  void walk_with(double forward, double left, double turn);
  void stand() { walk_with(0.0, 0.0, 0.0); }
  void get_up();

  // team
  std::int64_t heard() { return static_cast<std::int64_t>(heard_.size()); }
  std::int64_t sender_of(std::int64_t which) { return message(which).sender; }
  std::string_view text_of(std::int64_t which) { return message(which).text; }
  void send(std::string_view text);

  /// Requests an action of the application. The arguments fit its declaration.
  void request(std::uint16_t action, FieldData arguments);

 private:
  void reorient_by(Reorientation reorientation);
  void pause(Pause pause);
  /// The verdict on the latest such command of the running machine; nullptr: none.
  const LastVerdict* last_verdict(Reorientation reorientation) const;
  bool is_pending(Reorientation reorientation) const;
  const Message& message(std::int64_t which) const;

  BehaviorOutput output_;
  std::span<const Message> heard_;
  const Arbiter* arbiter_ = nullptr;
  const Names* names_ = nullptr;
  const Machine* sender_ = nullptr;  ///< of the latest message of the frame
  std::size_t sent_ = 0;             ///< messages of this sender in the frame
  double head_priority_ = -std::numeric_limits<double>::infinity();
  double walk_priority_ = -std::numeric_limits<double>::infinity();
};

class BehaviorLanguage : public ScriptLanguage {
 public:
  /// Of an application that declares nothing.
  BehaviorLanguage();
  /// `application`: read by the scripts; must outlive the language.
  explicit BehaviorLanguage(const ApplicationState& application) : application_(application) {}

  ScriptKind kind() const override { return ScriptKind::behavior; }
  std::string_view folder() const override { return "behaviors"; }
  std::span<const WorldTable> tables() const override;
  std::span<const WorldField> world() const override;
  std::span<const ScriptFunction> functions() const override;
  void add_globals(lua_State* L) override;
  BehaviorActions& actions() override { return actions_; }
  const ApplicationState& application() const { return application_; }
  const BehaviorOutput& output() const { return actions_.output(); }

 private:
  const ApplicationState& application_;
  BehaviorActions actions_;
};

}  // namespace reorient
