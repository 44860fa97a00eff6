// SPDX-License-Identifier: MIT
#include "program/run/console/world_commands.h"

#include <algorithm>
#include <cmath>
#include <span>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/script/language/world_fields.h"
#include "program/run/console/name_pattern.h"

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

std::string value_text(const World& world, std::size_t field) {
  std::vector<double> values;
  append_world(world, values);
  return value_text(world_fields()[field], values[field]);
}

}  // namespace

std::string value_text(const World& world, std::string_view field) {
  const std::span<const WorldField> fields = world_fields();
  const auto named =
      std::find_if(fields.begin(), fields.end(), [&](const auto& one) { return one.full_name() == field; });
  return named == fields.end() ? "not known" : value_text(world, static_cast<std::size_t>(named - fields.begin()));
}

WorldCommands::WorldCommands() {
  for (const WorldField& field : world_fields()) names_.push_back(field.full_name());
}

Reply WorldCommands::look(const std::string& pattern) const {
  return [fields = pick(pattern, names_, "world value")](const FrameRecord& frame, const SceneTruth&) {
    std::string text;
    for (const std::size_t i : fields) {
      const WorldField& field = world_fields()[i];
      text += fmt::format("  {} = {}  ({})\n", field.full_name(), value_text(frame.world, i), field.description);
    }
    return text;
  };
}

Reply WorldCommands::watch(const std::string& pattern) {
  if (pattern.empty() && watched_.empty())
    return at_once("  no watched values; expected: watch NAME, as in: watch confidence.current\n");
  const std::vector<std::size_t> fields =
      pattern.empty() ? std::vector<std::size_t>() : pick(pattern, names_, "world value");
  for (const std::size_t field : fields) {
    std::erase_if(watched_, [&](const Watched& one) { return one.field == field; });
    watched_.push_back({field, "", 0.0});
  }
  return [this](const FrameRecord& frame, const SceneTruth&) {
    std::string text;
    for (Watched& one : watched_) {
      one.printed = value_text(frame.world, one.field);
      one.printed_at = frame.world.time;
      text += fmt::format("  {:.2f} s  {} = {}\n", one.printed_at, names_[one.field], one.printed);
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
      std::erase_if(watched_, [&](const Watched& one) { return names_[one.field] == watched[i]; });
  }
  return at_once(
      fmt::format("  {} watched\n", watched_.empty() ? "no values" : counted(watched_.size(), "value") + " still"));
}

std::string WorldCommands::changes(const World& world) {
  std::string text;
  for (Watched& one : watched_) {
    if (world.time - one.printed_at + kTolerance < kPause) continue;
    std::string now = value_text(world, one.field);
    if (now == one.printed) continue;
    one.printed = std::move(now);
    one.printed_at = world.time;
    text += fmt::format("  {:.2f} s  {} = {}\n", one.printed_at, names_[one.field], one.printed);
  }
  return text;
}

Words WorldCommands::watched() const {
  Words names;
  for (const Watched& one : watched_) names.push_back(names_[one.field]);
  return names;
}

}  // namespace reorient
