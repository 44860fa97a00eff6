// SPDX-License-Identifier: MIT
#include "program/former_names.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include <spdlog/spdlog.h>

#include "engine/script/language/world_fields.h"
#include "engine/script/source/lua_tokens.h"

namespace reorient {
namespace {

/// Parameters of earlier versions that are not used any more, and the parameter that replaces each.
constexpr std::pair<std::string_view, std::string_view> kFormerParameters[] = {
    {"background_training.asymmetry", "background_training.separability"},
    {"room_status.asymmetry", "room_status.separability"}};

bool names_field(std::span<const LuaToken> tokens, const WorldField& field) {
  for (std::size_t i = 2; i < tokens.size(); ++i) {
    if (tokens[i - 2].is(LuaToken::Kind::name, field.table) && tokens[i - 1].is_symbol(".") &&
        tokens[i].is(LuaToken::Kind::name, field.name))
      return true;
  }
  return false;
}

}  // namespace

bool warn_of_former_name(const ParameterChange& change) {
  const auto* const former = std::find_if(std::begin(kFormerParameters), std::end(kFormerParameters),
                                          [&](const auto& names) { return names.first == change.name; });
  if (former == std::end(kFormerParameters)) return false;
  spdlog::warn("{}parameter '{}' is not used any more: '{}', a probability, took its place",
               change.source.empty() ? "" : change.source + ": ", former->first, former->second);
  return true;
}

std::set<std::string> files_of(const FrameLoop& engine) {
  std::set<std::string> files;
  for (const MachineDefinition* machine : engine.machines()) files.insert(machine->file);
  return files;
}

void warn_of_former_fields(const ScriptTexts& scripts, const std::set<std::string>& files) {
  for (const std::string& file : files) {
    const ScriptText* const script = scripts.find(file);
    if (script == nullptr) continue;
    const std::vector<LuaToken> tokens = lua_tokens(script->text);
    for (const WorldField& field : world_fields()) {
      if (!field.replacement.empty() && names_field(tokens, field))
        spdlog::warn("{}/{}: {} is a former name: use {}", scripts.root(), file, field.full_name(), field.replacement);
    }
  }
}

}  // namespace reorient
