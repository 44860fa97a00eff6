// SPDX-License-Identifier: MIT
#include "program/former_names.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <spdlog/spdlog.h>

#include "engine/script/language/world_fields.h"
#include "engine/script/source/lua_tokens.h"
#include "workbench/scenario/scenario_language.h"

namespace reorient {
namespace {

/// Parameters of earlier versions that are no longer used, and the parameter that replaces each.
constexpr std::pair<std::string_view, std::string_view> kFormerParameters[] = {
    {"background_training.asymmetry", "background_training.separability"},
    {"room_status.asymmetry", "room_status.separability"}};

/// Parameters that only have a new name.
constexpr std::pair<std::string_view, std::string_view> kRenamedParameters[] = {
    {"color.grey_within", "color.gray_within"}};

/// Functions of the library lib.decision.
constexpr std::pair<std::string_view, std::string_view> kFormerThresholds[] = {{"in_doubt", "unconfirmed_threshold"},
                                                                               {"in_peace", "confirmed_threshold"}};

/// Scenarios, and the experiments of the same name.
constexpr std::pair<std::string_view, std::string_view> kFormerScenarios[] = {{"turned_round", "mirrored_placement"}};

/// `where`: "team.toml:7", or empty.
void warn_of(const std::string& where, std::string_view former, std::string_view present) {
  spdlog::warn("{}{} is a former name: use {}", where.empty() ? "" : where + ": ", former, present);
}

/// Whether "table.field" or, without a field, "table." is in the script.
bool has_name(std::span<const LuaToken> tokens, std::string_view table, std::string_view field = {}) {
  for (std::size_t i = 1; i < tokens.size(); ++i) {
    if (!tokens[i - 1].is(LuaToken::Kind::name, table) || !tokens[i].is_symbol(".")) continue;
    if (field.empty() || (i + 1 < tokens.size() && tokens[i + 1].is(LuaToken::Kind::name, field))) return true;
  }
  return false;
}

}  // namespace

std::string present_name(const std::string& name) {
  for (const auto& [former, present] : kFormerScenarios) {
    if (name != former) continue;
    warn_of({}, former, present);
    return std::string(present);
  }
  return name;
}

std::vector<ParameterChange> with_present_names(std::vector<ParameterChange> changes, const ScriptTexts& scripts) {
  for (ParameterChange& change : changes) {
    for (const auto& [former, present] : kFormerScenarios) {
      if (!change.name.starts_with(std::string(former) + ".")) continue;
      if (scripts.find("scenarios/" + std::string(former) + ".lua") != nullptr) continue;
      const std::string name = std::string(present) + change.name.substr(former.size());
      warn_of(change.source, change.name, name);
      change.name = name;
    }
    if (change.name == "trial.event") change.value = present_name(change.value);
  }
  return changes;
}

void rename_parameters(std::vector<ParameterChange>& changes) {
  for (ParameterChange& change : changes) {
    for (const auto& [former, present] : kRenamedParameters) {
      if (change.name != former) continue;
      warn_of(change.source, former, present);
      change.name = present;
    }
  }
}

bool warn_of_former_name(const ParameterChange& change) {
  const auto* const former = std::find_if(std::begin(kFormerParameters), std::end(kFormerParameters),
                                          [&](const auto& names) { return names.first == change.name; });
  if (former == std::end(kFormerParameters)) return false;
  spdlog::warn("{}parameter '{}' is no longer used: '{}', a probability, replaces it",
               change.source.empty() ? "" : change.source + ": ", former->first, former->second);
  return true;
}

std::set<std::string> files_of(const FrameLoop& engine) {
  std::set<std::string> files;
  for (const MachineDefinition* machine : engine.machines()) files.insert(machine->file);
  return files;
}

void warn_of_former_fields(const ScriptTexts& scripts, const std::set<std::string>& files) {
  const ScenarioLanguage scenarios;
  for (const std::string& file : files) {
    const ScriptText* const script = scripts.find(file);
    if (script == nullptr) continue;
    const std::vector<LuaToken> tokens = lua_tokens(script->text);
    const std::string where = scripts.root() + "/" + file;
    for (const WorldField& field : world_fields()) {
      if (!field.replacement.empty() && has_name(tokens, field.table, field.name))
        warn_of(where, field.full_name(), field.replacement);
    }
    for (const auto& [former, present] : kFormerThresholds) {
      if (has_name(tokens, "decision", former))
        warn_of(where, "decision." + std::string(former), "decision." + std::string(present));
    }
    for (const FormerTable& table : scenarios.former_tables()) {
      if (has_name(tokens, table.name)) warn_of(where, table.name, table.replacement);
    }
  }
}

}  // namespace reorient
