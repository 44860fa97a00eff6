// SPDX-License-Identifier: MIT
#include "workbench/recording/comparison.h"

#include <algorithm>
#include <bit>
#include <string_view>
#include <utility>

#include "engine/record/record_bytes.h"
#include "workbench/recording/value_text.h"
#include "workbench/run/timeline.h"

namespace reorient {
namespace {

bool are_same(double a, double b) { return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b); }

std::string text_of(const WalkVelocity& walk) {
  return exact_text(walk.forward) + ", " + exact_text(walk.left) + ", " + exact_text(walk.turn);
}

std::string text_of(const std::optional<HeadRequest>& head) {
  if (!head) return "nothing";
  return exact_text(head->angles.yaw) + ", " + exact_text(head->angles.pitch) + " at " + exact_text(head->speed);
}

std::string text_of(const Eigen::Vector2d& position) {
  return exact_text(position.x()) + ", " + exact_text(position.y());
}

std::string text_of(const TimelineEvent& event) {
  std::string text = event.machine;
  if (event.command.empty()) return text + ": " + event.state + (event.reason.empty() ? "" : " (" + event.reason + ")");
  return text + ": " + event.command + ", " + event.verdict + (event.reason.empty() ? "" : " (" + event.reason + ")");
}

std::string text_of(const ParameterOutcome& change) {
  return change.name + (change.refusal.empty() ? " = " + change.value : ": " + change.refusal);
}

std::string text_of(const ReloadRecord& reload) {
  return reload.script + (reload.accepted ? " was accepted" : ": " + reload.fault.message);
}

std::vector<std::string> events_of(const FrameRecord& frame) {
  std::vector<std::string> texts;
  for (const TimelineEvent& event : timeline_events(frame, {})) texts.push_back(text_of(event));
  return texts;
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
  return all.empty() ? "nothing" : all;
}

std::string reorientation_of(const FrameRecord& frame) {
  return frame.reorientation ? std::string(to_string(frame.reorientation->reorientation)) : "nothing";
}

using Values = std::vector<std::pair<std::string, std::string>>;

std::string_view name_or_nothing(const FrameRecord& frame, NameId name) {
  return name == kNoName ? std::string_view("nothing") : std::string_view(frame.name(name));
}

/// Values that are not world fields, in the order from causes to effects.
Values values_before_world(const FrameRecord& frame) {
  Values values;
  for (std::size_t camera = 0; camera < frame.percepts.size(); ++camera) {
    const FieldPercept& percept = frame.percepts[camera];
    const std::string name = camera == 0 ? "upper camera: " : "lower camera: ";
    values.emplace_back(name + "line points", std::to_string(percept.line_points.size()));
    values.emplace_back(name + "goal posts", std::to_string(percept.goal_posts.size()));
    values.emplace_back(name + "obstacles", std::to_string(percept.obstacles.size()));
    values.emplace_back(name + "intersections", std::to_string(percept.intersections.size()));
    values.emplace_back(name + "penalty marks", std::to_string(percept.penalty_marks.size()));
    values.emplace_back(name + "center circle",
                        percept.center_circle ? text_of(percept.center_circle->center) : "nothing");
    values.emplace_back(name + "ball", percept.ball ? text_of(percept.ball->position) : "nothing");
    for (const LinePoint& point : percept.line_points) {
      values.emplace_back(name + "position of a line point (m)", text_of(point.position));
    }
  }
  return values;
}

Values values_after_world(const FrameRecord& frame) {
  Values values;
  for (const NamedScalar& scalar : application_values(frame.application, frame.world.time))
    values.emplace_back(scalar.name, exact_text(scalar));
  values.emplace_back("events", joined(events_of(frame)));
  for (const MachineStatus& machine : frame.machines) {
    values.emplace_back("machine " + std::string(name_or_nothing(frame, machine.machine)),
                        std::string(name_or_nothing(frame, machine.state)) + (machine.stopped ? ", stopped" : ""));
  }
  for (const ParameterOutcome& change : frame.parameter_changes) values.emplace_back("parameter", text_of(change));
  for (const ReloadRecord& reload : frame.reloads) values.emplace_back("reload", text_of(reload));
  for (const LogRecord& log : frame.logs) values.emplace_back(log.is_note ? "note" : "log", log.text);
  for (const FaultRecord& fault : frame.faults) values.emplace_back("fault", fault.fault.message);
  return values;
}

Values actions_of(const FrameRecord& frame) {
  const Request& request = frame.answer.request;
  Values values{{"reorientation", reorientation_of(frame)},
                {"head (yaw, pitch in rad, rad/s)", text_of(request.head)},
                {"walk (m/s, m/s, rad/s)", text_of(request.walk)},
                {"get up", request.get_up ? "true" : "false"}};
  for (const ActionRecord& record : frame.application.requests) {
    if (record.verdict != Verdict::granted) continue;
    const DeclaredAction& action = frame.application.declared->actions[record.request.action];
    values.emplace_back("action " + action.name, to_text(record.request.arguments, action.arguments));
  }
  for (const std::string& message : frame.answer.messages) values.emplace_back("message to the team", message);
  return values;
}

std::optional<Difference> first_of(const Values& recorded, const Values& replayed) {
  for (std::size_t i = 0; i < std::max(recorded.size(), replayed.size()); ++i) {
    const std::pair<std::string, std::string> none{"", "nothing"};
    const auto& then = i < recorded.size() ? recorded[i] : none;
    const auto& now = i < replayed.size() ? replayed[i] : none;
    if (then != now) return Difference{0, 0.0, then.first.empty() ? now.first : then.first, then.second, now.second};
  }
  return std::nullopt;
}

std::optional<Difference> first_in_world(const World& recorded, const World& replayed) {
  std::vector<double> then, now;
  append_world(recorded, then);
  append_world(replayed, now);
  for (std::size_t i = 0; i < then.size(); ++i) {
    const WorldField& field = world_fields()[i];
    if (!are_same(then[i], now[i]))
      return Difference{0, 0.0, field.full_name(), exact_text(field, then[i]), exact_text(field, now[i])};
  }
  return std::nullopt;
}

std::optional<Difference> placed(std::optional<Difference> difference, const FrameRecord& frame) {
  if (difference) {
    difference->frame = frame.world.frame;
    difference->time = frame.world.time;
  }
  return difference;
}

std::vector<std::byte> bytes_of(const FrameRecord& frame, Topic topic) {
  std::vector<std::byte> bytes;
  write_topic(frame, topic, bytes);
  return bytes;
}

}  // namespace

std::optional<Difference> first_difference(const FrameRecord& recorded, const FrameRecord& replayed) {
  std::optional<Difference> found = first_of(values_before_world(recorded), values_before_world(replayed));
  if (!found) found = first_in_world(recorded.world, replayed.world);
  if (!found) found = first_of(values_after_world(recorded), values_after_world(replayed));
  if (!found) found = first_of(actions_of(recorded), actions_of(replayed));
  for (const TopicInfo& row : kTopics) {
    if (found || !digested_topics().has(row.topic)) continue;
    const std::vector<std::byte> then = bytes_of(recorded, row.topic), now = bytes_of(replayed, row.topic);
    if (then == now) continue;
    const auto place = std::mismatch(then.begin(), then.end(), now.begin(), now.end()).first - then.begin();
    found = Difference{0, 0.0, "topic " + std::string(row.name), std::to_string(then.size()) + " bytes",
                       std::to_string(now.size()) + " bytes, different from byte " + std::to_string(place)};
  }
  return placed(std::move(found), replayed);
}

std::optional<Difference> first_difference_in_action(const FrameRecord& recorded, const FrameRecord& replayed) {
  return placed(first_of(actions_of(recorded), actions_of(replayed)), replayed);
}

void ReplayComparison::observe(const FrameRecord& frame, const SceneTruth& /*scene*/) {
  ++frames_;
  const FrameEntry& entry = playback_.frame().entry;
  bytes_.clear();
  write_record(frame, bytes_, digested_topics(), &places_);
  digest_topics(bytes_, places_, digests_);
  const bool is_same = digests_ == entry.digests;
  if (is_same && frame.transitions.empty() && frame.begun.empty() && frame.commands.empty()) return;
  const FrameRecord recorded = read_record(entry.record);
  add_events(recorded, frame);
  if (is_same) return;
  ++different_;
  if (!first_) first_ = first_difference(recorded, frame);
  if (!first_action_) first_action_ = first_difference_in_action(recorded, frame);
}

std::optional<ReplayComparison::Event> ReplayComparison::first_decision() const {
  const auto first =
      std::find_if(events_.begin(), events_.end(), [](const Event& event) { return event.recorded != event.replayed; });
  return first == events_.end() ? std::nullopt : std::optional(*first);
}

void ReplayComparison::add_events(const FrameRecord& recorded, const FrameRecord& replayed) {
  std::vector<std::string> now = events_of(replayed);
  for (std::string& text : events_of(recorded)) {
    if (events_.size() >= kMostEvents) return;
    const auto same = std::find(now.begin(), now.end(), text);
    const bool is_both = same != now.end();
    if (is_both) now.erase(same);
    events_.push_back({recorded.world.time, std::move(text), true, is_both});
  }
  for (std::string& text : now) {
    if (events_.size() < kMostEvents) events_.push_back({replayed.world.time, std::move(text), false, true});
  }
}

}  // namespace reorient
