// SPDX-License-Identifier: MIT
#include "program/run/console/world_commands.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <span>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "engine/script/language/world_fields.h"
#include "program/run/console/name_pattern.h"
#include "workbench/run/application_values.h"

namespace reorient {
namespace {

constexpr double kPause = 0.5;       // s between two lines of one value
constexpr double kTolerance = 1e-6;  // s: frame times are sums of rounded steps

/// The value for the user: "upright", "1.250 m".
std::string value_text(const WorldField& field, double value) {
  if (std::isnan(value)) return "not known";
  if (field.type == WorldField::Type::boolean) return value != 0.0 ? "true" : "false";
  if (field.type == WorldField::Type::name) return std::string(field.names[static_cast<std::size_t>(value)]);
  const double rounded = std::round(value * 1000.0) / 1000.0 + 0.0;  // and no "-0.000"
  const std::string number = field.is_integer ? fmt::format("{:.0f}", value) : fmt::format("{:.3f}", rounded);
  return field.unit.empty() ? number : fmt::format("{} {}", number, field.unit);
}

std::string value_text(const NamedScalar& scalar) {
  if (const bool* const yes = std::get_if<bool>(&scalar.value)) return *yes ? "true" : "false";
  if (const auto* const text = std::get_if<std::string>(&scalar.value)) return as_line(*text);
  const double number = std::get<double>(scalar.value);
  if (std::isinf(number)) return "never";
  const double rounded = std::round(number * 1000.0) / 1000.0 + 0.0;  // and no "-0.000"
  return fmt::format("{:.3f}{}{}", rounded, scalar.unit.empty() ? "" : " ", scalar.unit);
}

/// A value by its name.
struct Described {
  std::string value;  ///< with its unit
  std::string_view description;
};

/// Calls `take(name, described)` for each value of the frame.
void each_value(const FrameRecord& frame, const std::function<void(const std::string&, const Described&)>& take) {
  std::vector<double> values;
  append_world(frame.world, values);
  for (std::size_t i = 0; i < values.size(); ++i) {
    const WorldField& field = world_fields()[i];
    take(field.full_name(), {value_text(field, values[i]), field.description});
  }
  for (const NamedScalar& scalar : application_values(frame.application, frame.world.time))
    take(scalar.name, {value_text(scalar), scalar.description});
}

}  // namespace

std::string value_text(const FrameRecord& frame, std::string_view name) {
  const std::span<const WorldField> fields = world_fields();
  const auto named =
      std::find_if(fields.begin(), fields.end(), [&](const auto& one) { return one.full_name() == name; });
  if (named != fields.end()) {
    std::vector<double> values;
    append_world(frame.world, values);
    return value_text(*named, values[static_cast<std::size_t>(named - fields.begin())]);
  }
  for (const NamedScalar& scalar : application_values(frame.application, frame.world.time)) {
    if (scalar.name == name) return value_text(scalar);
  }
  return "not known";
}

void WorldCommands::take_application(const ApplicationInterface& declared) {
  names_.clear();
  for (const WorldField& field : world_fields()) names_.push_back(field.full_name());
  for (const NamedScalar& scalar : application_values(declared)) names_.push_back(scalar.name);
}

Reply WorldCommands::look(const std::string& pattern) const {
  std::set<std::string> wanted;
  for (const std::size_t i : pick(pattern, names_, "world value")) wanted.insert(names_[i]);
  return [wanted](const FrameRecord& frame, const SceneTruth&) {
    std::string text;
    each_value(frame, [&](const std::string& name, const Described& described) {
      if (wanted.contains(name)) text += fmt::format("  {} = {}  ({})\n", name, described.value, described.description);
    });
    return text;
  };
}

Reply WorldCommands::watch(const std::string& pattern) {
  if (pattern.empty() && watched_.empty())
    return at_once("  no watched values; expected: watch NAME, as in: watch confidence.current\n");
  const std::vector<std::size_t> fields =
      pattern.empty() ? std::vector<std::size_t>() : pick(pattern, names_, "world value");
  for (const std::size_t field : fields) {
    std::erase_if(watched_, [&](const Watched& one) { return one.name == names_[field]; });
    watched_.push_back({names_[field], "", 0.0});
  }
  return [this](const FrameRecord& frame, const SceneTruth&) {
    std::string text;
    for (Watched& one : watched_) {
      one.printed = value_text(frame, one.name);
      one.printed_at = frame.world.time;
      text += fmt::format("  {:.2f} s  {} = {}\n", one.printed_at, one.name, one.printed);
    }
    return text;
  };
}

Reply WorldCommands::unwatch(const std::string& pattern) {
  const Words watched = this->watched();
  if (pattern.empty()) {
    watched_.clear();
  } else {
    for (const std::size_t i : pick(pattern, watched, "watched value"))
      std::erase_if(watched_, [&](const Watched& one) { return one.name == watched[i]; });
  }
  return at_once(
      fmt::format("  {} watched\n", watched_.empty() ? "no values" : counted(watched_.size(), "value") + " still"));
}

std::string WorldCommands::changes(const FrameRecord& frame) {
  const double time = frame.world.time;
  std::string text;
  for (Watched& one : watched_) {
    if (time - one.printed_at + kTolerance < kPause) continue;
    std::string now = value_text(frame, one.name);
    if (now == one.printed) continue;
    one.printed = std::move(now);
    one.printed_at = time;
    text += fmt::format("  {:.2f} s  {} = {}\n", one.printed_at, one.name, one.printed);
  }
  return text;
}

Words WorldCommands::watched() const {
  Words names;
  for (const Watched& one : watched_) names.push_back(one.name);
  return names;
}

}  // namespace reorient
