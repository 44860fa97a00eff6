// SPDX-License-Identifier: MIT
#include "workbench/script_tools/check/missing_values.h"

#include <algorithm>
#include <optional>

namespace reorient {
namespace {

/// A name after `input` or `action`: at most two parts, as in "ball.seen".
struct ApplicationUse {
  bool is_action = false;
  std::string first, second;
  TextPosition position;
};

std::optional<ApplicationUse> use_at(std::span<const LuaToken> tokens, std::size_t i) {
  const auto is_member = [&](std::size_t at) {
    return at + 1 < tokens.size() && tokens[at].is_symbol(".") && tokens[at + 1].kind == LuaToken::Kind::name;
  };
  const bool is_action = tokens[i].is(LuaToken::Kind::name, "action");
  if (!is_action && !tokens[i].is(LuaToken::Kind::name, "input")) return std::nullopt;
  if (i > 0 && (tokens[i - 1].is_symbol(".") || tokens[i - 1].is_symbol(":"))) return std::nullopt;
  ApplicationUse use{is_action, {}, {}, tokens[i].position};
  std::size_t at = i + 1;
  if (!is_action && is_member(at) && (tokens[at + 1].text == "age" || tokens[at + 1].text == "valid")) at += 2;
  if (!is_member(at)) return std::nullopt;
  use.first = tokens[at + 1].text;
  if (!is_action && is_member(at + 2)) use.second = tokens[at + 3].text;
  return use;
}

/// The declared name that a script uses: "ball.seen" also for `input.ball.seen`, "pose" for `input.pose.x`. For a whole
/// group, the name of its first value.
std::optional<std::string> declared_name(const ApplicationInterface& declared, const ApplicationUse& use) {
  if (use.is_action) {
    const bool is_known = std::any_of(declared.actions.begin(), declared.actions.end(),
                                      [&](const DeclaredAction& action) { return action.name == use.first; });
    return is_known ? std::optional(use.first) : std::nullopt;
  }
  const std::string group = use.first + ".";
  for (const DeclaredValue& value : declared.values) {
    const bool is_whole_group = use.second.empty() && value.name.starts_with(group);
    if (value.name == use.first || value.name == group + use.second || is_whole_group) return value.name;
  }
  return std::nullopt;
}

}  // namespace

std::vector<MissingValue> missing_values(std::string_view text, const ApplicationInterface& declared,
                                         std::span<const ApplicationInterface> known) {
  std::vector<MissingValue> missing;
  const std::vector<LuaToken> tokens = lua_tokens(text);
  for (std::size_t i = 0; i < tokens.size(); ++i) {
    const std::optional<ApplicationUse> use = use_at(tokens, i);
    if (!use || declared_name(declared, *use)) continue;
    for (const ApplicationInterface& interface : known) {
      const std::optional<std::string> found = declared_name(interface, *use);
      if (!found) continue;
      const std::string name = (use->is_action ? "action." : "input.") + *found;
      auto one = std::find_if(missing.begin(), missing.end(), [&](const auto& other) { return other.name == name; });
      if (one == missing.end()) one = missing.insert(missing.end(), {name, use->position, {}});
      if (std::count(one->interfaces.begin(), one->interfaces.end(), interface.name) == 0)
        one->interfaces.push_back(interface.name);
    }
  }
  return missing;
}

std::string to_text(std::span<const MissingValue> missing) {
  const std::size_t more = missing.size() - 1;
  std::string text = missing.front().name + (more > 0 ? " and " + std::to_string(more) + " more are" : " is") +
                     " missing; the interface";
  const std::vector<std::string>& interfaces = missing.front().interfaces;
  for (std::size_t i = 0; i < interfaces.size(); ++i) text += (i > 0 ? " or '" : " '") + interfaces[i] + "'";
  return text + " has " + (more > 0 ? "them" : "it");
}

}  // namespace reorient
