// SPDX-License-Identifier: MIT
#include "engine/script/script.h"

#include <algorithm>
#include <cmath>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/called_view.h"
#include "engine/script/sandbox/binding.h"
#include "engine/script/script_error.h"

namespace reorient {
namespace {

Script& script_of(lua_State* L) { return *static_cast<Script*>(lua_touserdata(L, lua_upvalueindex(1))); }

/// Arguments: the globals, a name that is not among them.
int refuse_unknown_global(lua_State* L) {
  if (lua_type(L, 2) != LUA_TSTRING) return 0;
  const std::string name = lua_tostring(L, 2);
  std::vector<std::string> known;
  for (lua_pushnil(L); lua_next(L, 1) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) == LUA_TSTRING) known.emplace_back(lua_tostring(L, -2));
  }
  std::sort(known.begin(), known.end());
  const std::string hint = did_you_mean(name, known);
  return luaL_error(L, "unknown name '%s'%s", name.c_str(), hint.c_str());
}

int refuse_new_global(lua_State* L) {
  return luaL_error(L, "unknown variable '%s': write 'local %s', or keep { } for values that survive a reload",
                    luaL_tolstring(L, 2, nullptr), luaL_tolstring(L, 2, nullptr));
}

/// Throws ScriptError if there are errors in declarations.
void refuse(const std::vector<ScriptFault>& faults) {
  if (faults.empty()) return;
  ScriptFault first = faults.front();
  if (const std::size_t more = faults.size() - 1; more > 0)
    first.message += " (and " + std::to_string(more) + " more; reorient check shows all)";
  ScriptError error(std::move(first));
  error.all = faults;
  throw error;
}

}  // namespace

Script::Script(const ScriptTexts& texts, const std::string& file, ScriptLanguage& language, const ScriptLimits& limits,
               const ParameterRegistry& parameters, const MachineDirectory& directory, BundleHashes& hashes,
               const std::optional<CalledAs>& called)
    : texts_(&texts),
      sources_(texts.root()),
      language_(language),
      limits_(limits),
      registry_(parameters),
      hashes_(&hashes),
      sandbox_(limits) {
  sandbox_.grant(limits.instructions_per_load);
  add_globals(directory);
  try {
    load_module(file);
  } catch (const ScriptError&) {
    // After an error in a declaration, this one may be its consequence.
    if (declarations_->faults.empty()) throw;
  }
  refuse(declarations_->faults);
  lua_pop(sandbox_.state(), 1);
  declarations_->close();
  std::vector<std::string> left_out;
  known_ = memory(left_out);
  places_.clear();
  is_loaded_ = true;
  texts_ = nullptr;
  hashes_ = nullptr;
  const std::string word(to_string(language.kind()));
  if (declarations_->machines.empty())
    throw ScriptError({file, 1, "missing declaration: expected " + word + " \"name\" { ... }", {}});
  if (called) name_as_called(*called);
}

void Script::add_globals(const MachineDirectory& directory) {
  lua_State* const L = sandbox_.state();
  world_ = std::make_unique<WorldTables>(L, language_);
  add_script_functions(L, language_);
  language_.add_globals(L);
  add_behavior_view(L, directory);
  if (language_.kind() == ScriptKind::behavior) add_called_view(L, directory, language_.actions());
  declarations_ = std::make_unique<Declarations>(
      L, language_.kind() == ScriptKind::scenario, language_.body_parts(),
      [this](const std::string& name) -> const SourceLocations& {
        constexpr std::size_t kLettersPerInstruction = 32;
        const ScriptText* const text = texts_->find(name);
        const std::size_t letters = text == nullptr ? 0 : text->text.size();
        sandbox_.charge(static_cast<std::int64_t>(letters / kLettersPerInstruction));
        return places_of(name);
      },
      [this](const ParameterDeclaration& declaration) { return registry_.preview(declaration); });
  lua_newtable(L);
  loaded_ = luaL_ref(L, LUA_REGISTRYINDEX);
  lua_pushlightuserdata(L, this);
  lua_pushcclosure(L, &Script::require, 1);
  lua_setglobal(L, "require");
  lua_pushlightuserdata(L, &language_.actions());
  lua_pushcclosure(L, &Script::print, 1);
  lua_setglobal(L, "print");
  lua_pushglobaltable(L);
  lua_createtable(L, 0, 3);
  lua_pushcfunction(L, refuse_unknown_global);
  lua_setfield(L, -2, "__index");
  lua_pushcfunction(L, refuse_new_global);
  lua_setfield(L, -2, "__newindex");
  lua_pushboolean(L, 0);
  lua_setfield(L, -2, "__metatable");
  lua_setmetatable(L, -2);
  lua_pop(L, 1);
}

std::string_view Script::read(const std::string& file) {
  const ScriptText* const found = texts_->find(file);
  (*hashes_)[file] =
      found != nullptr ? std::optional<std::uint64_t>(content_hash(found->text + found->problem)) : std::nullopt;
  if (found == nullptr) {
    const std::size_t slash = file.rfind('/');
    const std::string folder = file.substr(0, slash == std::string::npos ? 0 : slash);
    const std::string hint = did_you_mean(file, texts_->in_folder(folder));
    throw ScriptError({file, 0, "script not found in " + texts_->root() + hint, {}});
  }
  if (!found->problem.empty()) throw ScriptError({file, 0, found->problem, {}});
  sources_.apply({file, *found});
  return found->text;
}

const SourceLocations& Script::places_of(const std::string& file) {
  const auto known = places_.find(file);
  if (known != places_.end()) return known->second;
  const ScriptText* const text = texts_->find(file);
  return places_.emplace(file, SourceLocations(text == nullptr ? std::string_view() : text->text)).first->second;
}

void Script::load_module(const std::string& file) {
  const std::string_view text = read(file);
  if (std::optional<ScriptFault> fault = sandbox_.compile(text, file)) {
    fault->column = places_of(file).column_of_syntax_error(fault->message, fault->line);
    throw ScriptError(std::move(*fault));
  }
  loading_.push_back(file);
  std::optional<ScriptFault> fault = sandbox_.call(0, 1);
  loading_.pop_back();
  if (!fault) return;
  if (fault->file.empty()) fault->file = file;
  throw ScriptError(std::move(*fault));
}

/// require "lib.walk": the value that scripts/lib/walk.lua returns, the same one each time.
int Script::require(lua_State* L) {
  Script& script = script_of(L);
  const char* const module = luaL_checkstring(L, 1);
  std::string failure;
  bool has_place = false;
  lua_rawgeti(L, LUA_REGISTRYINDEX, script.loaded_);
  if (lua_getfield(L, -1, module) != LUA_TNIL) return 1;
  lua_pop(L, 1);
  try {
    const std::optional<std::string> file = module_file(module);
    if (script.is_loaded_) {
      failure = "require is only allowed at the top of a script, not in its functions";
    } else if (!file) {
      failure = "require: expected a name such as \"lib.walk\"";
    } else if (std::find(script.loading_.begin(), script.loading_.end(), *file) != script.loading_.end()) {
      failure = *file + " requires itself directly or through other files";
    } else {
      script.load_module(*file);
    }
  } catch (const ScriptError& error) {
    failure = error.what();
    has_place = error.fault.line > 0;
  }
  if (!failure.empty()) {
    if (has_place) {  // also of a used-up budget: the error names the line in the other file that used it up
      lua_pushlstring(L, failure.data(), failure.size());
      return lua_error(L);
    }
    script.sandbox_.raise_if_exhausted();
    return luaL_error(L, "%s", failure.c_str());
  }
  if (lua_isnil(L, -1)) {
    lua_pop(L, 1);
    lua_pushboolean(L, 1);
  }
  lua_pushvalue(L, -1);
  lua_setfield(L, -3, module);
  return 1;
}

/// As Lua's print, into the log.
int Script::print(lua_State* L) {
  const int count = lua_gettop(L);
  luaL_Buffer line;
  luaL_buffinit(L, &line);
  for (int i = 1; i <= count; ++i) {
    if (i > 1) luaL_addchar(&line, ' ');
    lua_getglobal(L, "tostring");
    lua_pushvalue(L, i);
    lua_call(L, 1, 1);
    luaL_addvalue(&line);
  }
  luaL_pushresult(&line);
  lua_replace(L, 1);
  lua_settop(L, 1);
  return lua::Bound<&ScriptActions::inform>::call(L);
}

std::vector<ParameterDeclaration> Script::parameters() const {
  std::vector<ParameterDeclaration> all;
  for (const DeclaredParameter& parameter : declarations_->parameters) {
    if (!parameter.is_argument) all.push_back(parameter.declaration);
  }
  return all;
}

std::map<std::string, std::set<std::string>> Script::module_fields() const {
  std::map<std::string, std::set<std::string>> all;
  lua_State* const L = sandbox_.state();
  lua_rawgeti(L, LUA_REGISTRYINDEX, loaded_);
  for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
    if (lua_type(L, -2) != LUA_TSTRING || !lua_istable(L, -1)) continue;
    std::set<std::string>& fields = all[lua_tostring(L, -2)];
    for (lua_pushnil(L); lua_next(L, -2) != 0; lua_pop(L, 1)) {
      if (lua_type(L, -2) == LUA_TSTRING) fields.insert(lua_tostring(L, -2));
    }
  }
  lua_pop(L, 1);
  return all;
}

void Script::intern(Names& names) {
  for (MachineDefinition& machine : declarations_->machines) intern_names(machine, names);
}

void Script::begin_frame(std::span<const double> world) {
  exit_faults_.clear();
  world_->refresh(world);
  if (parameter_revision_ != registry_.revision()) {
    parameter_revision_ = registry_.revision();
    for (DeclaredParameter& parameter : declarations_->parameters) {
      if (parameter.is_argument) continue;
      const Parameter* known = registry_.find(parameter.declaration.name);
      if (known != nullptr) declarations_->set_value(parameter, known->value);
    }
  }
  sandbox_.grant(limits_.instructions_per_frame);
}

void Script::push_function(int function) { lua_rawgeti(sandbox_.state(), LUA_REGISTRYINDEX, function); }

bool Script::holds(Machine& machine, int state, int function) {
  language_.actions().set_running(&machine, state, ScriptActions::Phase::evaluating);
  push_function(function);
  if (std::optional<ScriptFault> fault = sandbox_.call(0, 1)) throw ScriptError(std::move(*fault));
  const bool result = lua_toboolean(sandbox_.state(), -1) != 0;
  lua_pop(sandbox_.state(), 1);
  return result;
}

double Script::seconds(Machine& machine, int state, const Dwell& dwell) {
  if (dwell.kind == Dwell::Kind::seconds) return dwell.seconds;
  if (dwell.kind == Dwell::Kind::parameter)
    return declarations_->parameters[static_cast<std::size_t>(dwell.index)].number;
  language_.actions().set_running(&machine, state, ScriptActions::Phase::evaluating);
  push_function(dwell.index);
  if (std::optional<ScriptFault> fault = sandbox_.call(0, 1)) throw ScriptError(std::move(*fault));
  const bool is_number = lua_type(sandbox_.state(), -1) == LUA_TNUMBER;
  const double seconds = lua_tonumber(sandbox_.state(), -1);
  lua_pop(sandbox_.state(), 1);
  if (is_number && seconds >= 0.0) return seconds;
  const StateDefinition& definition = machine.definition().states[static_cast<std::size_t>(state)];
  throw ScriptError({definition.file,
                     definition.position.line,
                     "a function for lasting or after must return a non-negative number of seconds",
                     {},
                     0});
}

void Script::run(Machine& machine, int state, int function) {
  if (function == LUA_NOREF) return;
  language_.actions().set_running(&machine, state, ScriptActions::Phase::acting);
  push_function(function);
  if (std::optional<ScriptFault> fault = sandbox_.call(0, 0)) throw ScriptError(std::move(*fault));
}

void Script::run_exit(Machine& machine, int state, int function) {
  try {
    run(machine, state, function);
  } catch (ScriptError& error) {
    exit_faults_.push_back(std::move(error.fault));
  }
}

Script::Memory Script::memory(std::vector<std::string>& left_out) const {
  Memory all;
  std::size_t bytes = static_cast<std::size_t>(limits_.max_memory) * 1024 / 2;  // must fit into the next version, too
  lua_State* const L = sandbox_.state();
  for (const KeptMemory& kept : declarations_->memories) {
    lua_rawgeti(L, LUA_REGISTRYINDEX, kept.table);
    all[kept.name] = read_kept(L, -1, bytes, left_out);
    lua_pop(L, 1);
  }
  return all;
}

Script::Memory Script::removed() const {
  Memory all;
  lua_State* const L = sandbox_.state();
  for (const KeptMemory& kept : declarations_->memories) {
    const auto known = known_.find(kept.name);
    if (known == known_.end()) continue;
    lua_rawgeti(L, LUA_REGISTRYINDEX, kept.table);
    all[kept.name] = removed_from(L, -1, known->second);
    lua_pop(L, 1);
  }
  return all;
}

void Script::take_over(const Script& before, std::vector<std::string>& left_out) {
  write(before.memory(left_out), before.removed(), KeptFor::another_version);
}

void Script::restore(const Memory& memory) {
  Memory removed;
  for (const auto& [name, values] : memory) removed[name] = removed_from(values, known_[name]);
  write(memory, removed, KeptFor::same_version);
}

void Script::write(const Memory& memory, const Memory& removed, KeptFor version) {
  lua_State* const L = sandbox_.state();
  for (const KeptMemory& kept : declarations_->memories) {
    const auto found = memory.find(kept.name);
    if (found == memory.end()) continue;
    const auto removed_keys = removed.find(kept.name);
    lua_rawgeti(L, LUA_REGISTRYINDEX, kept.table);
    write_kept(L, -1, found->second, removed_keys == removed.end() ? KeptTable() : removed_keys->second, version);
    lua_pop(L, 1);
    add_kept(known_[kept.name], found->second);
  }
}

}  // namespace reorient
