// SPDX-License-Identifier: MIT
#include "workbench/experiments/condition/condition.h"

#include <algorithm>
#include <cstddef>
#include <stdexcept>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"

namespace reorient {
namespace {

template <typename Value, typename Wanted>
void set(Value& value, const std::optional<Wanted>& wanted) {
  if (wanted) value = *wanted;
}

template <typename Value>
void append(std::vector<Value>& all, const std::vector<Value>& more) {
  all.insert(all.end(), more.begin(), more.end());
}

void add_cells(const Experiment& experiment, const Cell& so_far, std::vector<Cell>& cells) {
  if (so_far.choices.size() == experiment.axes.size()) {
    apply(experiment.overrides, cells.emplace_back(so_far).condition);
    return;
  }
  for (const AxisChoice& choice : experiment.axes[so_far.choices.size()].choices) {
    Cell cell = so_far;
    cell.choices.push_back(choice.name);
    apply(choice.patch, cell.condition);
    add_cells(experiment, cell, cells);
  }
}

}  // namespace

void apply(const ConditionPatch& patch, Condition& condition) {
  for (const ConditionPatch& first : patch.first) apply(first, condition);
  set(condition.scenario, patch.scenario);
  append(condition.with, patch.with);
  append(condition.without, patch.without);
  append(condition.parameter_files, patch.parameter_files);
  append(condition.parameters, patch.parameters);
  set(condition.room, patch.room);
  set(condition.hall_seed, patch.hall_seed);
  set(condition.field, patch.field);
  set(condition.interface, patch.interface);
  set(condition.body, patch.body);
  set(condition.cameras, patch.cameras);
  set(condition.width, patch.width);
  set(condition.room_awareness, patch.room_awareness);
  set(condition.seconds, patch.seconds);
  set(condition.learned_before, patch.learned_before);
  set(condition.compasses, patch.compasses);
  set(condition.pose_errors, patch.pose_errors);
  set(condition.measurement.from, patch.measured_from);
  set(condition.measurement.limit, patch.limit);
  set(condition.measurement.hold, patch.hold);
  set(condition.measurement.to_the_end, patch.to_the_end);
  set(condition.measurement.symmetric_room, patch.symmetric_room);
  for (const auto& [what, place] : patch.said_at) condition.said_at[what] = place;
}

std::string as_text(const Condition& condition) {
  std::string text;
  const auto add = [&text](std::string_view name, std::string_view value) {
    text.append(name).append(" = ").append(value).append("\n");
  };
  const auto number = [](double value) { return to_text(ParameterValue(value)); };
  add("scenario", condition.scenario);
  for (const std::string& behavior : condition.with) add("with", behavior);
  for (const std::string& behavior : condition.without) add("without", behavior);
  for (const std::string& file : condition.parameter_files) add("params", file);
  for (const ParameterChange& change : condition.parameters) add(change.name, change.value);
  add("room", condition.room);
  add("hall_seed", condition.hall_seed ? std::to_string(*condition.hall_seed) : "");
  add("field", condition.field);
  if (!condition.interface.empty()) add("interface", condition.interface);
  add("body", condition.body);
  add("cameras", condition.cameras);
  add("width", std::to_string(condition.width));
  add("room_awareness", condition.room_awareness ? "true" : "false");
  add("seconds", number(condition.seconds));
  if (condition.learned_before > 0.0) add("learned_before", number(condition.learned_before));
  if (condition.compasses) add("compasses", "true");
  if (condition.pose_errors) add("pose_errors", "true");
  add("measured_from", condition.measurement.from);
  add("limit", number(condition.measurement.limit));
  add("hold", number(condition.measurement.hold));
  add("to_the_end", condition.measurement.to_the_end ? "true" : "false");
  add("symmetric_room", condition.measurement.symmetric_room ? "true" : "false");
  for (const Measure& measure : condition.measures)
    add(std::string("measure.").append(to_string(measure.type)), measure.name);
  return text;
}

void choose(Experiment& experiment, const std::string& axis, const std::vector<std::string>& names,
            const std::function<AxisChoice(const Axis& axis, const std::string& name)>& otherwise) {
  std::vector<std::string> axes;
  for (Axis& one : experiment.axes) {
    axes.push_back(one.name);
    if (one.name != axis) continue;
    std::vector<AxisChoice> chosen;
    for (const std::string& name : names) {
      const auto is_it = [&](const AxisChoice& choice) { return choice.name == name; };
      const auto found = std::find_if(one.choices.begin(), one.choices.end(), is_it);
      AxisChoice choice = found != one.choices.end() ? *found : otherwise(one, name);
      if (std::none_of(chosen.begin(), chosen.end(), [&](const auto& other) { return other.name == choice.name; }))
        chosen.push_back(std::move(choice));
    }
    one.choices = std::move(chosen);
    one.usual.clear();
    return;
  }
  throw std::runtime_error(as_line(experiment.name + ": unknown axis '" + axis + "'" + did_you_mean(axis, axes)));
}

Experiment with_usual_choices(Experiment experiment) {
  for (Axis& axis : experiment.axes) {
    if (axis.usual.empty()) continue;
    std::erase_if(axis.choices, [&axis](const AxisChoice& choice) {
      return std::find(axis.usual.begin(), axis.usual.end(), choice.name) == axis.usual.end();
    });
    axis.usual.clear();
  }
  return experiment;
}

std::vector<Cell> cells_of(const Experiment& experiment) {
  const Experiment taken = with_usual_choices(experiment);
  constexpr std::size_t kMostCells = 10'000;
  std::size_t count = 1;
  for (const Axis& axis : taken.axes) {
    count *= axis.choices.size();
    if (count > kMostCells)
      throw std::runtime_error(as_line(experiment.name) + ": expected at most " + std::to_string(kMostCells) +
                               " cells, found more; remove choices or split the experiment");
  }
  Cell first;
  apply(taken.base, first.condition);
  first.condition.measures = taken.measures;
  std::vector<Cell> cells;
  add_cells(taken, first, cells);
  return cells;
}

bool belongs_to(const Reference& reference, const Experiment& experiment, const std::vector<std::string>& choices) {
  return std::all_of(reference.choices.begin(), reference.choices.end(), [&](const auto& wanted) {
    for (std::size_t i = 0; i < experiment.axes.size(); ++i) {
      if (experiment.axes[i].name == wanted.first && choices[i] == wanted.second) return true;
    }
    return false;
  });
}

}  // namespace reorient
