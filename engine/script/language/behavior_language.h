// SPDX-License-Identifier: MIT
// Functions of behaviors: command, head, walk, motion and team. What behaviors can read: world_fields.h. The values and
// actions of an application: application_tables.h.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/script/language/script_language.h"
#include "engine/world/application_state.h"
#include "engine/world/arbiter.h"
#include "engine/world/body_claims.h"
#include "engine/world/commands.h"
#include "robots/robot.h"

namespace reorient {

/// Requests of the behaviors in one frame.
struct BehaviorOutput {
  std::vector<ReorientationRequest> commands;
  Request request;                     ///< to the robot: of the behaviors that have the head and the legs
  std::vector<std::string> messages;   ///< to the teammates
  std::vector<ActionRequest> actions;  ///< of the application
};

class BehaviorActions : public ScriptActions {
 public:
  /// `application` must outlive the object.
  explicit BehaviorActions(const ApplicationState& application);

  void begin_frame(ScriptOutput& output, double time) override;
  const BehaviorOutput& output() const { return output_; }
  /// Sets the messages of the next frame, which must outlive it.
  void set_messages(std::span<const Message> messages) { heard_ = messages; }

  /// Sets what the next frame reads about earlier commands and claims. All must outlive it.
  void set_verdicts(const Arbiter* arbiter, const BodyClaims& claims, const Names& names) {
    arbiter_ = arbiter;
    claims_ = &claims;
    names_ = &names;
  }
  /// After all behaviors of a frame: decides who moves which part of the body.
  void share_body(BodyClaims& claims);

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

  // body
  void claim(std::string_view part);
  std::string_view holder(std::string_view part);
  std::string_view rival(std::string_view part);

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
  /// `table`: of the function that reads what became of a behavior's requests.
  void require_running(const char* table) const;
  /// The verdict on the latest such command of the running machine; nullptr: none.
  const LastVerdict* last_verdict(Reorientation reorientation) const;
  bool is_pending(Reorientation reorientation) const;
  const Message& message(std::int64_t which) const;

  /// What a behavior does with the parts: nothing, if it only claims them. The last one is an index in
  /// BehaviorOutput::actions.
  using Use = std::variant<std::monostate, HeadRequest, WalkVelocity, std::size_t>;
  void request_parts(BodyParts parts, Use use = {});
  BodyPart part_named(std::string_view name) const;

  const ApplicationState& application_;
  std::vector<std::string> parts_;       ///< names
  std::vector<BodyParts> action_parts_;  ///< of each declared action
  BehaviorOutput output_;
  std::vector<PartsRequest> requests_;  ///< of actions that still run and so keep their parts, then those of the frame
  std::size_t held_ = 0;                ///< number of the former
  std::vector<Use> uses_;               ///< of the latter
  std::span<const Message> heard_;
  const Arbiter* arbiter_ = nullptr;
  const BodyClaims* claims_ = nullptr;
  const Names* names_ = nullptr;
  const Machine* sender_ = nullptr;  ///< of the latest message of the frame
  std::size_t sent_ = 0;             ///< messages of this sender in the frame
};

class BehaviorLanguage : public ScriptLanguage {
 public:
  /// Of an application that declares nothing.
  BehaviorLanguage();
  /// `application`: read by the scripts; must outlive the language.
  explicit BehaviorLanguage(const ApplicationState& application) : application_(application), actions_(application) {}

  ScriptKind kind() const override { return ScriptKind::behavior; }
  std::string_view folder() const override { return "behaviors"; }
  std::span<const WorldTable> tables() const override;
  std::span<const WorldField> world() const override;
  std::span<const ScriptFunction> functions() const override;
  std::vector<std::string> body_parts() const override { return reorient::body_parts(application_.declared()); }
  void add_globals(lua_State* L) override;
  BehaviorActions& actions() override { return actions_; }
  const ApplicationState& application() const { return application_; }
  const BehaviorOutput& output() const { return actions_.output(); }

 private:
  const ApplicationState& application_;
  BehaviorActions actions_;
};

}  // namespace reorient
