// SPDX-License-Identifier: MIT
// One version of one script: a behavior or scenario and its required modules, compiled, declared and validated.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/language/behavior_view.h"
#include "engine/script/language/declarations.h"
#include "engine/script/language/kept_value.h"
#include "engine/script/language/script_language.h"
#include "engine/script/language/world_tables.h"
#include "engine/script/machine/machine.h"
#include "engine/script/sandbox/sandbox.h"
#include "engine/script/script_texts.h"

namespace reorient {

/// The files of a script as they were read, by name; no hash: the file was missing.
using BundleHashes = std::map<std::string, std::optional<std::uint64_t>>;

/// A behavior that another one runs.
struct CalledAs {
  std::string behavior;   ///< "walk_to": the name of its file and its machine
  std::string caller;     ///< name of the machine that runs it
  Priorities priorities;  ///< of that machine

  /// Of the machine: "striker/approach/walk_to".
  std::string name() const { return caller + "/" + behavior; }
};
template <typename Visit, ConstOr<CalledAs> T>
void fields(Visit&& visit, T& called) {
  visit(called.behavior, called.caller, called.priorities);
}

class Script : public MachineCallbacks {
 public:
  /// Reads, compiles, runs the declarations and validates them. Throws ScriptError. `hashes` gets every file that it
  /// tried to read, also on failure. All references except `texts` and `hashes` must outlive the script. `called`: its
  /// machine has the name of its caller, too.
  Script(const ScriptTexts& texts, const std::string& file, ScriptLanguage& language, const ScriptLimits& limits,
         const ParameterRegistry& parameters, const MachineDirectory& directory, BundleHashes& hashes,
         const std::optional<CalledAs>& called = {});
  Script(const Script&) = delete;
  Script& operator=(const Script&) = delete;

  const std::deque<MachineDefinition>& machines() const { return declarations_->machines; }
  /// Gives all names of the machines their numbers.
  void intern(Names& names);
  std::vector<ParameterDeclaration> parameters() const;
  std::vector<ParameterDeclaration> arguments() const;
  void set_priorities(const Priorities& priorities);
  /// Sets every argument: to the value that is given, or to its default. A function is called in `caller`, whose
  /// machine is in `state`. Throws ScriptError of the caller.
  void take_arguments(std::span<const CallArgument> given, Script& caller, Machine& machine, int state);
  Sandbox& sandbox() { return sandbox_; }
  const Sandbox& sandbox() const { return sandbox_; }
  const ScriptLimits& limits() const { return limits_; }
  /// The files of the script, as they were read.
  const ScriptTexts& sources() const { return sources_; }
  /// The fields of each required module that is a table.
  std::map<std::string, std::set<std::string>> module_fields() const;

  /// Before the machines tick: the frame's world, changed parameters, a new budget.
  void begin_frame(std::span<const double> world);
  void end_frame() { language_.actions().clear_running(); }
  /// Errors in `exit` since the frame began.
  std::vector<ScriptFault>& exit_faults() { return exit_faults_; }

  using Memory = std::map<std::string, KeptTable>;
  /// The `keep` memory of all its files. `left_out` names values that could not be stored.
  Memory memory(std::vector<std::string>& left_out) const;
  /// Takes over the kept values of another version and removes the keys that it removed. Values that only this version
  /// declares have their initial value.
  void take_over(const Script& before, std::vector<std::string>& left_out);
  /// Replaces the memory of this newly loaded script with the memory of the same version.
  void restore(const Memory& memory);

  bool holds(Machine& machine, int state, int function) override;
  double seconds(Machine& machine, int state, const Dwell& dwell) override;
  void run(Machine& machine, int state, int function) override;
  void run_exit(Machine& machine, int state, int function) override;

 private:
  static int require(lua_State* L);
  static int print(lua_State* L);
  /// Pushes what the file returns. Throws ScriptError.
  void load_module(const std::string& file);
  std::string_view read(const std::string& file);
  const SourceLocations& places_of(const std::string& file);
  void add_globals(const MachineDirectory& directory);
  void push_function(int function);
  void name_as_called(const CalledAs& called);
  ParameterValue argument_value(const ParameterDeclaration& argument, const CallArgument& given, Machine& machine,
                                int state);
  Memory removed() const;
  void write(const Memory& memory, const Memory& removed, KeptFor version);

  const ScriptTexts* texts_;  ///< while it is loaded
  ScriptTexts sources_;
  ScriptLanguage& language_;
  ScriptLimits limits_;
  const ParameterRegistry& registry_;
  BundleHashes* hashes_;                           ///< while it is loaded
  std::map<std::string, SourceLocations> places_;  ///< while it is loaded
  std::vector<std::string> loading_;               ///< files whose `require` has not returned yet
  Sandbox sandbox_;
  std::unique_ptr<WorldTables> world_;
  std::unique_ptr<Declarations> declarations_;
  Memory known_;  ///< its memory after loading or taking over, to find the keys that it removes later
  std::uint64_t parameter_revision_ = 0;
  std::vector<ScriptFault> exit_faults_;
  int loaded_ = LUA_NOREF;  ///< table of the modules required so far
  bool is_loaded_ = false;
};

}  // namespace reorient
