// SPDX-License-Identifier: MIT
#include "program/experiment/compass_parameters.h"

#include <algorithm>
#include <stdexcept>

#include "engine/core_parameters.h"
#include "engine/parameters/nearest_name.h"
#include "engine/parameters/parameter_registry.h"
#include "program/options.h"
#include "program/parameter_modules.h"

namespace reorient {
namespace {

bool is_of_peer(const ParameterChange& change) {
  bool is_one = false;
  CompassParameters parameters;
  for_each_peer(parameters, [&](const char* module, auto&) { is_one |= module_of(change.name) == module; });
  return is_one;
}

void declare_peers(CompassParameters& parameters, const std::vector<ParameterChange>& changes,
                   ParameterRegistry& registry) {
  for (const ParameterChange& change : changes) {
    if (is_of_peer(change)) registry.set_early(change);
  }
  for_each_peer(parameters, [&](const char* module, auto& peer) { registry.bind(module, peer); });
}

RoomParameters room_parameters(const std::vector<ParameterChange>& changes) {
  CoreParameters core;
  ParameterRegistry registry;
  for (const ParameterChange& change : changes) registry.set_early(change);
  declare(core, registry);
  return core.room;
}

}  // namespace

std::vector<ParameterChange> without_peers(std::vector<ParameterChange> changes) {
  std::erase_if(changes, is_of_peer);
  return changes;
}

std::vector<Parameter> peer_parameters(const std::vector<ParameterChange>& changes) {
  CompassParameters parameters;
  ParameterRegistry registry;
  declare_peers(parameters, changes, registry);
  return registry.list();
}

CompassParameters compass_parameters(const std::vector<ParameterChange>& changes) {
  CompassParameters parameters;
  ParameterRegistry registry;
  declare_peers(parameters, changes, registry);
  std::vector<std::string> names;
  for (const Parameter& parameter : registry.list()) names.push_back(parameter.name);
  for (const ParameterChange& change : changes) {
    if (is_of_peer(change) && registry.find(change.name) == nullptr)
      throw std::runtime_error((change.source.empty() ? "" : change.source + ": ") + "unknown parameter '" +
                               change.name + "'" + did_you_mean(change.name, names));
  }
  parameters.room = room_parameters(changes);
  ParameterOptions paper;
  paper.files = {"paper"};
  parameters.room_paper = room_parameters(overrides_of(paper));
  return parameters;
}

}  // namespace reorient
