// SPDX-License-Identifier: MIT
#include "engine/script/language/behavior_language.h"

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>

#include "engine/parameters/counted.h"
#include "engine/parameters/nearest_name.h"
#include "engine/script/language/application_tables.h"
#include "engine/script/language/world_fields.h"

namespace reorient {

BehaviorLanguage::BehaviorLanguage()
    : BehaviorLanguage([]() -> const ApplicationState& {
        static const ApplicationState nothing;
        return nothing;
      }()) {}

void BehaviorLanguage::add_globals(lua_State* L) { add_application_tables(L, *this); }

std::span<const WorldTable> BehaviorLanguage::tables() const { return world_tables(); }
std::span<const WorldField> BehaviorLanguage::world() const { return world_fields(); }

std::span<const ScriptFunction> BehaviorLanguage::functions() const {
  using A = BehaviorActions;
  static const std::vector<ScriptFunction> functions{
      script_function<&A::flip_pose>("command.flip_pose", {},
                                     "Requests that the mirrored pose replace the believed pose in this frame."),
      script_function<&A::purge_reflection>(
          "command.purge_reflection", {},
          "Requests that the particles near the mirrored pose be removed in this frame."),
      script_function<&A::reset_orientation>(
          "command.reset_orientation", {},
          "Requests in this frame that the orientation become unknown; the position does not change."),
      script_function<&A::pause_training>(
          "command.pause_training", {}, "Pauses the training of the background model until the calling state is left."),
      script_function<&A::pause_evaluation>("command.pause_evaluation", {},
                                            "Pauses the evaluation of the room until the calling state is left."),
      script_function<&A::command_state>(
          "command.state", {"command"},
          "What became of this behavior's latest command of a kind, such as \"flip_pose\": idle (never requested), "
          "pending (requested in this frame), granted or refused."),
      script_function<&A::command_reason>("command.reason", {"command"}, "Why it was refused; empty if it was not."),
      script_function<&A::command_wait>("command.wait", {"command"},
                                        "Time until such a command is not too soon any more (s): after one was "
                                        "granted to any behavior, the same "
                                        "one is refused for some time."),
      script_function<&A::command_refusals>(
          "command.refusals", {"command"},
          "How often this behavior's commands of a kind were refused since the latest one that was granted."),
      script_function<&A::look>(
          "head.look", {"yaw", "pitch", "speed"},
          "Turns the head to these angles (rad, positive left and downward) at a speed (rad/s). Valid for one frame."),
      script_function<&A::walk_with>("walk.velocity", {"forward", "left", "turn"},
                                     "Walks with this velocity (m/s, m/s, rad/s to the left). Valid for one frame."),
      script_function<&A::stand>("walk.stand", {}, "Stands still; counts as a walk request. Valid for one frame."),
      script_function<&A::get_up>("motion.get_up", {}, "Gets up after a fall. Valid for one frame."),
      script_function<&A::claim>("body.claim", {"part"},
                                 "Claims a part of the body, such as \"legs\", without moving it: behaviors with a "
                                 "smaller priority do not get it. Valid for one frame."),
      script_function<&A::holder>("body.holder", {"part"},
                                  "Name of the behavior that had the part in the last frame; empty if none had it."),
      script_function<&A::rival>("body.rival", {"part"},
                                 "Name of the behavior that had the part in the last frame although this one requested "
                                 "it, too; empty if this one was not refused."),
      script_function<&A::heard>("team.heard", {}, "Number of messages received from teammates in this frame."),
      script_function<&A::sender_of>("team.sender", {"which"},
                                     "Player number of the sender of this message (1 is the first message)."),
      script_function<&A::text_of>("team.text", {"which"},
                                   "Text of this message (1 is the first message): unchanged bytes, at most 240."),
      script_function<&A::send>(
          "team.send", {"text"},
          "Sends a message of at most 240 bytes to the teammates. The team's own program transmits it."),
      script_function<&A::inform>("log.info", {"text"}, "Writes a line to the run's log, with time and state."),
      script_function<&A::note>(
          "log.note", {"text"},
          "Writes a line to the run's log and marks it as a note, which can be searched for in a recording."),
      script_function<&A::time_in_state>("time_in_state", {}, "Seconds since the calling state was entered."),
  };
  return functions;
}

BehaviorActions::BehaviorActions(const ApplicationState& application)
    : application_(application), parts_(body_parts(application.declared())) {
  for (const DeclaredAction& action : application.declared().actions) {
    BodyParts parts = 0;
    for (const std::string& part : action.parts) parts |= only(part_named(part));
    action_parts_.push_back(parts);
  }
}

void BehaviorActions::begin_frame(ScriptOutput& output, double time) {
  ScriptActions::begin_frame(output, time);
  output_.commands.clear();
  output_.request = {};
  output_.messages.clear();
  output_.actions.clear();
  sender_ = nullptr;
  requests_.clear();
  uses_.clear();
  for (std::size_t i = 0; i < action_parts_.size(); ++i) {
    const ActionStatus& status = application_.actions()[i];
    const bool holds = action_parts_[i] != 0 && is_under_way(status.state) && status.issuer.machine != kNoName;
    if (holds) requests_.push_back({action_parts_[i], status.issuer, status.priority});
  }
  held_ = requests_.size();
}

void BehaviorActions::reorient_by(Reorientation reorientation) {
  require_acting();
  count_action();
  output_.commands.push_back({reorientation, issuer(), machine().definition().priorities.all});
}

void BehaviorActions::pause(Pause pause) {
  require_acting();
  machine().lease(pause, state());
}

namespace {

Reorientation reorientation_named(std::string_view name) {
  constexpr std::array kAll{Reorientation::flip_pose, Reorientation::purge_reflection,
                            Reorientation::reset_orientation};
  for (const Reorientation one : kAll) {
    if (to_string(one) == name) return one;
  }
  std::vector<std::string> known;
  known.reserve(kAll.size());
  for (const Reorientation one : kAll) known.emplace_back(to_string(one));
  throw std::runtime_error("unknown command '" + std::string(name) + "'" + did_you_mean(std::string(name), known));
}

}  // namespace

void BehaviorActions::require_running(const char* table) const {
  if (is_loading()) throw std::runtime_error(std::string(table) + ": no behavior runs while a script is loaded");
}

const LastVerdict* BehaviorActions::last_verdict(Reorientation reorientation) const {
  require_running("command");
  return arbiter_ == nullptr ? nullptr : arbiter_->last_verdict(machine().definition().name_id, reorientation);
}

bool BehaviorActions::is_pending(Reorientation reorientation) const {
  const NameId self = machine().definition().name_id;
  return std::any_of(output_.commands.begin(), output_.commands.end(), [&](const ReorientationRequest& request) {
    return request.issuer.machine == self && request.reorientation == reorientation;
  });
}

std::string_view BehaviorActions::command_state(std::string_view command) {
  const Reorientation reorientation = reorientation_named(command);
  const LastVerdict* const last = last_verdict(reorientation);
  if (is_pending(reorientation)) return "pending";
  if (last == nullptr) return "idle";
  return last->verdict == Verdict::granted ? "granted" : "refused";
}

std::string BehaviorActions::command_reason(std::string_view command) {
  const LastVerdict* const last = last_verdict(reorientation_named(command));
  if (last == nullptr) return {};
  switch (last->verdict) {
    case Verdict::granted:
      return {};
    case Verdict::outranked:
      return "outranked by " + name_of(last->outranked_by);
    case Verdict::too_soon:
      return "too soon after another one";
    case Verdict::not_allowed:
      return "not allowed: the robot was not on its feet";
  }
  return {};
}

double BehaviorActions::command_wait(std::string_view command) {
  const Reorientation reorientation = reorientation_named(command);
  return arbiter_ == nullptr ? 0.0 : arbiter_->wait(reorientation, time());
}

std::int64_t BehaviorActions::command_refusals(std::string_view command) {
  const LastVerdict* const last = last_verdict(reorientation_named(command));
  return last == nullptr ? 0 : last->refusals;
}

void BehaviorActions::request(std::uint16_t action, FieldData arguments) {
  require_acting();
  count_action();
  if (!application_.continues(action, arguments)) request_parts(action_parts_[action], output_.actions.size());
  output_.actions.push_back(
      {action, std::move(arguments), issuer(), machine().definition().priorities.of(action_parts_[action])});
}

void BehaviorActions::look(double yaw, double pitch, std::optional<double> speed) {
  require_acting();
  if (speed && *speed <= 0.0) throw std::runtime_error("head.look: expected a speed above 0 rad/s");
  HeadRequest request;
  request.angles = {yaw, pitch};
  if (speed) request.speed = *speed;
  request_parts(only(kHead), request);
}

void BehaviorActions::walk_with(double forward, double left, double turn) {
  require_acting();
  request_parts(only(kLegs), WalkVelocity{forward, left, turn});
}

/// Without parts the request needs no decision. Of the motions of a part that a behavior requests, the first counts.
void BehaviorActions::request_parts(BodyParts parts, Use use) {
  if (parts == 0) return;
  const Issuer self = issuer();
  const bool is_action = std::holds_alternative<std::size_t>(use);
  for (std::size_t i = requests_.size(); !is_action && i-- > held_ && requests_[i].issuer.machine == self.machine;) {
    if (requests_[i].parts == parts && uses_[i - held_].index() == use.index()) return;
  }
  requests_.push_back({parts, self, machine().definition().priorities.of(parts)});
  uses_.push_back(use);
}

BodyPart BehaviorActions::part_named(std::string_view name) const {
  const auto found = std::find(parts_.begin(), parts_.end(), name);
  if (found == parts_.end())
    throw std::runtime_error("unknown part of the body '" + std::string(name) + "'" + did_you_mean(name, parts_));
  return static_cast<BodyPart>(found - parts_.begin());
}

void BehaviorActions::share_body(BodyClaims& claims) {
  claims.decide(requests_);
  for (std::size_t i = 0; i < uses_.size(); ++i) {
    const NameId rival = requests_[held_ + i].outranked_by;
    const Use& use = uses_[i];
    if (const auto* const action = std::get_if<std::size_t>(&use)) {
      output_.actions[*action].outranked_by = rival;
    } else if (rival != kNoName) {
      continue;
    } else if (const auto* const head = std::get_if<HeadRequest>(&use)) {
      output_.request.head = *head;
    } else if (const auto* const walk = std::get_if<WalkVelocity>(&use)) {
      output_.request.walk = *walk;
    }
  }
}

void BehaviorActions::claim(std::string_view part) {
  require_acting();
  request_parts(only(part_named(part)));
}

std::string_view BehaviorActions::holder(std::string_view part) {
  const BodyPart known = part_named(part);
  require_running("body");
  return name_of(claims_->holder(known));
}

std::string_view BehaviorActions::rival(std::string_view part) {
  const BodyPart known = part_named(part);
  require_running("body");
  return name_of(claims_->rival(known, machine().definition().name_id));
}

void BehaviorActions::get_up() {
  require_acting();
  output_.request.get_up = true;
}

const Message& BehaviorActions::message(std::int64_t which) const {
  if (which >= 1 && which <= static_cast<std::int64_t>(heard_.size()))
    return heard_[static_cast<std::size_t>(which - 1)];
  throw std::runtime_error("unknown message " + std::to_string(which) + ": this frame has " +
                           counted(heard_.size(), "message"));
}

void BehaviorActions::send(std::string_view text) {
  constexpr std::size_t kMost = 8;  // per machine and frame, so that a runaway one does not block the others
  require_acting();
  if (text.size() > kLongestMessage)
    throw std::runtime_error("message has " + std::to_string(text.size()) + " bytes (expected at most 240)");
  if (text.find('\0') != std::string_view::npos) throw std::runtime_error("expected a message without zero bytes");
  if (sender_ != &machine()) sent_ = 0;
  sender_ = &machine();
  if (sent_++ >= kMost) throw std::runtime_error("too many messages in one frame (expected at most 8)");
  output_.messages.emplace_back(text);
}

}  // namespace reorient
