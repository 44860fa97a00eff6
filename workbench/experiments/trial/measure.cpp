// SPDX-License-Identifier: MIT
#include "workbench/experiments/trial/measure.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/world_fields.h"

namespace reorient {
namespace {

constexpr std::string_view kArrow = " > ", kActionPrefix = "action.";

/// Fields that are numbers or booleans.
const WorldField* measurable_field(std::string_view name) {
  for (const WorldField& field : world_fields()) {
    if (field.full_name() == name) return field.type == WorldField::Type::name ? nullptr : &field;
  }
  return nullptr;
}

std::vector<std::string> measurable_fields() {
  std::vector<std::string> names;
  for (const WorldField& field : world_fields()) {
    if (field.type != WorldField::Type::name && field.replacement.empty()) names.push_back(field.full_name());
  }
  return names;
}

std::vector<std::string> commands() {
  std::vector<std::string> names;
  names.reserve(enum_count(Reorientation()));
  for (int i = 0; i < enum_count(Reorientation()); ++i) names.emplace_back(to_string(static_cast<Reorientation>(i)));
  return names;
}

std::string mistake_in_command(const std::string& name) {
  if (name.starts_with(kActionPrefix) && name.size() > kActionPrefix.size()) return "";
  const std::vector<std::string> known = commands();
  if (std::find(known.begin(), known.end(), name) != known.end()) return "";
  return "unknown command '" + name + "'" + did_you_mean(name, known) + " (expected " + list_of(known) +
         ", or action.NAME)";
}

/// "MACHINE/STATE"
bool is_state(std::string_view name) {
  const std::size_t slash = name.find('/');
  return slash != std::string_view::npos && slash > 0 && slash + 1 < name.size();
}

/// A state is entered from outside, or again from itself.
bool enters(std::string_view from, std::string_view to, std::string_view state) {
  return is_within(to, state) && (!is_within(from, state) || (from == state && to == state));
}

template <typename Record>
double transitions_in(const Record& record, const Measure& measure, const std::vector<std::string>& states) {
  double count = 0.0;
  for (const TransitionRecord& one : record.transitions) {
    const std::string machine = record.name(one.machine) + "/";
    const std::string from = machine + record.name(one.from), to = machine + record.name(one.to);
    const bool counts = measure.type == MeasureType::entered ? enters(from, to, states[0])
                                                             : is_within(from, states[0]) && is_within(to, states[1]);
    count += counts ? 1.0 : 0.0;
  }
  return count;
}

double commands_in(const FrameRecord& frame, const Measure& measure) {
  const bool wants_granted = measure.type == MeasureType::granted;
  double count = 0.0;
  for (const CommandRecord& command : frame.commands) {
    const bool is_it = to_string(command.request.reorientation) == measure.name;
    count += is_it && (command.verdict == Verdict::granted) == wants_granted ? 1.0 : 0.0;
  }
  if (!measure.name.starts_with(kActionPrefix)) return count;
  const std::string_view action = std::string_view(measure.name).substr(kActionPrefix.size());
  for (const ActionRecord& record : frame.application.requests) {
    const bool is_it = frame.application.declared->actions.at(record.request.action).name == action;
    count += is_it && (record.verdict == Verdict::granted) == wants_granted ? 1.0 : 0.0;
  }
  return count;
}

double lines_with(const std::vector<LogRecord>& logs, const std::string& text) {
  return static_cast<double>(std::count_if(
      logs.begin(), logs.end(), [&](const LogRecord& log) { return log.text.find(text) != std::string::npos; }));
}

}  // namespace

std::string_view to_string(MeasureType type) {
  constexpr std::array<std::string_view, 9> kNames{"entered", "transitions", "granted", "refused", "logged",
                                                   "mean",    "minimum",     "maximum", "at_end"};
  return kNames.at(static_cast<std::size_t>(type));
}

std::string unit_of(const Measure& measure) {
  const WorldField* const field = measure.is_count() ? nullptr : measurable_field(measure.name);
  return field == nullptr ? "" : std::string(field->unit);
}

std::vector<std::string> states_of(const Measure& measure) {
  if (measure.type == MeasureType::entered) return {measure.name};
  if (measure.type != MeasureType::transition) return {};
  const std::size_t arrow = measure.name.find(kArrow);
  const std::string from = measure.name.substr(0, arrow);
  return {from, from.substr(0, from.find('/') + 1) + measure.name.substr(arrow + kArrow.size())};
}

std::string mistake_in(const Measure& measure) {
  switch (measure.type) {
    case MeasureType::entered:
      if (is_state(measure.name)) return "";
      return "expected MACHINE/STATE, as in \"orientation/correcting\", found '" + measure.name + "'";
    case MeasureType::transition: {
      const std::size_t arrow = measure.name.find(kArrow);
      const bool has_target = arrow != std::string::npos && arrow + kArrow.size() < measure.name.size();
      if (has_target && is_state(measure.name.substr(0, arrow))) return "";
      return "expected MACHINE/STATE > STATE, as in \"orientation/watching > correcting\", found '" + measure.name +
             "'";
    }
    case MeasureType::granted:
    case MeasureType::refused:
      return mistake_in_command(measure.name);
    case MeasureType::logged:
      return measure.name.empty() ? "expected a text of a log line, found an empty one" : "";
    case MeasureType::mean:
    case MeasureType::minimum:
    case MeasureType::maximum:
    case MeasureType::at_end:
      if (measurable_field(measure.name) != nullptr) return "";
      return "unknown number or boolean of the world '" + measure.name + "'" +
             did_you_mean(measure.name, measurable_fields()) + " (docs/script-reference.md lists them)";
  }
  return "";
}

std::string mistake_in_states(const Measure& measure, const std::set<std::string>& known) {
  for (const std::string& state : states_of(measure)) {
    const bool is_known =
        std::any_of(known.begin(), known.end(), [&](const std::string& one) { return is_within(one, state); });
    if (!is_known)
      return "unknown state '" + state + "'" +
             did_you_mean(state, std::vector<std::string>(known.begin(), known.end()));
  }
  return "";
}

MeasureObserver::MeasureObserver(std::vector<Measure> measures, const TrialObserver& trial) : trial_(trial) {
  for (Measure& measure : measures) {
    Tally& tally = tallies_.emplace_back();
    tally.states = states_of(measure);
    for (const WorldField& field : world_fields()) {
      if (field.full_name() == measure.name) break;
      ++tally.field;
    }
    tally.measure = std::move(measure);
  }
}

void MeasureObserver::count(const FrameRecord& frame, const ScenarioRecord& scenario, Tally& tally) const {
  const Measure& measure = tally.measure;
  switch (measure.type) {
    case MeasureType::entered:
    case MeasureType::transition:
      tally.sum += transitions_in(frame, measure, tally.states) + transitions_in(scenario, measure, tally.states);
      return;
    case MeasureType::granted:
    case MeasureType::refused:
      tally.sum += commands_in(frame, measure);
      return;
    case MeasureType::logged:
      tally.sum += lines_with(frame.logs, measure.name) + lines_with(scenario.logs, measure.name);
      return;
    case MeasureType::mean:
    case MeasureType::minimum:
    case MeasureType::maximum:
    case MeasureType::at_end:
      break;
  }
  const double value = world_.at(tally.field);
  tally.sum += value;
  tally.minimum = frames_ == 1 ? value : std::min(tally.minimum, value);
  tally.maximum = frames_ == 1 ? value : std::max(tally.maximum, value);
  tally.last = value;
}

void MeasureObserver::observe(const FrameRecord& frame, const SceneTruth& scene) {
  if (tallies_.empty() || !trial_.result().started) return;
  ++frames_;
  world_.clear();
  append_world(frame.world, world_);
  for (Tally& tally : tallies_) count(frame, scene.scenario, tally);
}

std::vector<MeasuredValue> MeasureObserver::values() const {
  std::vector<MeasuredValue> values;
  for (const Tally& tally : tallies_) {
    const auto value = [&]() -> double {
      switch (tally.measure.type) {
        case MeasureType::mean:
          return tally.sum / static_cast<double>(frames_);
        case MeasureType::minimum:
          return tally.minimum;
        case MeasureType::maximum:
          return tally.maximum;
        case MeasureType::at_end:
          return tally.last;
        default:
          return tally.sum;
      }
    };
    // A value such as "time since never" is infinite.
    const double measured = frames_ > 0 ? value() : std::nan("");
    values.push_back(std::isfinite(measured) ? MeasuredValue(measured) : std::nullopt);
  }
  return values;
}

}  // namespace reorient
