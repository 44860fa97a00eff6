// SPDX-License-Identifier: MIT
#include "program/run/engine_setup.h"

#include <utility>

#include "program/run/venue.h"
#include "program/script_names.h"

namespace reorient {
namespace {

/// The motions that a robot must execute for a behavior to be useful.
struct ShippedBehavior {
  const char* name;
  Abilities needs;
};
constexpr ShippedBehavior kShipped[] = {
    {"orientation", {false, false, false}},     {"background_training", {false, false, false}},
    {"kidnap_recovery", {false, false, false}}, {"goal_search", {true, false, false}},
    {"wall_gaze", {true, false, false}},        {"head_scan", {true, false, false}},
    {"get_up", {false, false, true}},           {"penalty_marks", {false, true, false}},
};

}  // namespace

std::vector<std::string> behaviors_for(const Abilities& abilities) {
  std::vector<std::string> names;
  for (const ShippedBehavior& one : kShipped) {
    const bool possible = (!one.needs.head || abilities.head) && (!one.needs.walk || abilities.walk) &&
                          (!one.needs.get_up || abilities.get_up);
    if (possible) names.emplace_back(one.name);
  }
  return names;
}

FrameSetup engine_setup(const EngineOptions& options, const ScriptTexts& scripts,
                        std::vector<ParameterChange> parameters) {
  return {.field = {},
          .seed = options.seed,
          .room_awareness = options.room_awareness,
          .scripts = scripts,
          .behaviors = {},
          .parameters = std::move(parameters)};
}

FrameSetup engine_setup(const EngineOptions& options, const ScriptTexts& scripts, RobotBody body,
                        const FieldDimensions& field, const Abilities& abilities) {
  FrameSetup setup = engine_setup(options, scripts, overrides_of(options.parameters));
  setup.body = std::move(body);
  setup.field = field;
  setup.application = interface_named(options.interface);
  for (const std::string& name : options.behaviors.empty() ? behaviors_for(abilities) : options.behaviors)
    setup.behaviors.push_back(behavior_file(options.scripts, scripts, name));
  return setup;
}

}  // namespace reorient
