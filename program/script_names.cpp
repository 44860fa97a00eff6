// SPDX-License-Identifier: MIT
#include "program/script_names.h"

#include <cstddef>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/parameters/nearest_name.h"
#include "engine/script/source/lua_tokens.h"
#include "program/former_names.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

struct Kind {
  const char* word;
  const char* folder;
};
constexpr Kind kScenarios{"scenario", "scenarios"};
constexpr Kind kBehaviors{"behavior", "behaviors"};

/// "paper/paper_orientation" of "behaviors/paper/paper_orientation.lua".
std::string name_of(const Kind& kind, const std::string& file) {
  return std::filesystem::path(file).lexically_relative(kind.folder).replace_extension().generic_string();
}

std::string named(const Kind& kind, const Kind& other, const std::filesystem::path& root, const ScriptTexts& texts,
                  const std::string& name) {
  std::string file = script_file(kind.folder, script_named(root, name));
  const std::string stem = std::filesystem::path(name).stem().string();
  const bool is_other = file.starts_with(std::string(other.folder) + "/") ||
                        (texts.find(file) == nullptr && texts.find(script_file(other.folder, stem)) != nullptr);
  if (is_other) {
    throw std::runtime_error(std::string("expected a ") + kind.word + ", found the " + other.word + " '" + name +
                             "': reorient run SCENARIO --with BEHAVIOR");
  }
  if (texts.find(file) != nullptr) return file;
  require_no_other_file(root, name);
  std::vector<std::string> known;
  for (const std::string& one : texts.in_folder(kind.folder)) known.push_back(name_of(kind, one));
  std::string hint = did_you_mean(stem, known);
  if (hint.empty() && !known.empty()) hint = " (expected " + list_of(known) + ")";
  throw std::runtime_error("unknown " + std::string(kind.word) + " '" + name + "' below " + root.string() + hint);
}

}  // namespace

void require_no_other_file(const std::filesystem::path& root, const std::string& name) {
  std::error_code error;
  const bool is_path = name.ends_with(".lua") || name.find('/') != std::string::npos;
  if (!is_path || !std::filesystem::exists(name, error)) return;
  if (!name.ends_with(".lua") || !std::filesystem::is_regular_file(name, error))
    throw std::runtime_error("'" + name + "': expected a script (*.lua), found another file");
  throw std::runtime_error("'" + name + "': expected a script below " + root.string() +
                           ", found one outside; copy it there, or name its own root with --scripts");
}

std::string scenario_file(const std::filesystem::path& root, const ScriptTexts& texts, const std::string& name) {
  const bool is_there = texts.find(script_file(kScenarios.folder, script_named(root, name))) != nullptr;
  return named(kScenarios, kBehaviors, root, texts, is_there ? name : present_name(name));
}

std::string behavior_file(const std::filesystem::path& root, const ScriptTexts& texts, const std::string& name) {
  return named(kBehaviors, kScenarios, root, texts, name);
}

std::set<std::string> with_required(const ScriptTexts& texts, const std::set<std::string>& files) {
  std::set<std::string> all;
  std::vector<std::string> open(files.begin(), files.end());
  while (!open.empty()) {
    const std::string file = std::move(open.back());
    open.pop_back();
    const ScriptText* const script = texts.find(file);
    if (script == nullptr || !all.insert(file).second) continue;
    const std::vector<LuaToken> tokens = lua_tokens(script->text);
    for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {  // the last token is the end
      if (!tokens[i].is(LuaToken::Kind::name, "require")) continue;
      const LuaToken& name = tokens[i + 1].is_symbol("(") ? tokens[i + 2] : tokens[i + 1];
      if (name.kind != LuaToken::Kind::text) {
        const std::vector<std::string> any = texts.files();
        return {any.begin(), any.end()};
      }
      if (std::optional<std::string> required = module_file(name.text)) open.push_back(*std::move(required));
    }
  }
  return all;
}

void require_script_name(const std::string& name) {
  const bool fits = !name.empty() &&
                    name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") == std::string::npos &&
                    name.front() >= 'a' && name.size() <= 60;
  if (!fits)
    throw std::runtime_error("invalid script name '" + name + "' (expected a-z, 0-9 and _, as in ball_search)");
}

}  // namespace reorient
