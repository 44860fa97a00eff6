// The scripts of a robot: loaded, ticked once a frame, reloaded while they run. What survives a reload is kept here.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/file_watcher.h"
#include "engine/script/script.h"
#include "engine/script/script_output.h"
#include "engine/world/world.h"

namespace reorient {

/// What became of an edit.
struct ReloadReport {
  double time = 0.0;
  std::string script;                 ///< file, from the scripts' root
  bool accepted = false;              ///< false: the previous version keeps running
  ScriptFault fault;                  ///< where it was not accepted
  std::vector<std::string> warnings;  ///< states that are gone, parameters that were clamped, memory left out
};

/// How a machine and its script are doing.
struct MachineStatus {
  std::string name;
  std::string script;          ///< file, from the scripts' root
  std::string state;           ///< path
  double time_in_state = 0.0;  ///< s
  double priority = 0.0;
  bool is_scenario = false;
  bool stopped = false;  ///< after too many errors
  int errors = 0;        ///< of the script, since it was loaded
  std::string last_error;
  std::int64_t instructions = 0;  ///< of the script, per frame on average
  double microseconds = 0.0;      ///< of the script, in the frame before
  std::size_t memory = 0;         ///< of the script, bytes
};

class ScriptHost : public MachineDirectory {
 public:
  /// `parameters` and `limits` must outlive the host; changed limits hold for what is loaded from then on. Throws
  /// std::runtime_error with one line when there is no such folder.
  ScriptHost(std::filesystem::path scripts_root, ParameterRegistry& parameters,
             const ScriptLimits& limits = kDefaultLimits);
  ~ScriptHost() override;
  ScriptHost(const ScriptHost&) = delete;
  ScriptHost& operator=(const ScriptHost&) = delete;

  /// "orientation", "behaviors/orientation.lua" or a path that leads there. Throws ScriptError; a script that is loaded
  /// already is left as it is.
  void load_behavior(const std::string& name);
  /// The same for scripts/scenarios; first loads the behaviours that the scenario lists.
  void load_scenario(const std::string& name);

  /// One frame: every machine ticks, in the order of loading. The output is valid until the next tick.
  const ScriptOutput& tick(const World& world);

  /// Looks for changed files, without blocking, and swaps in what was changed and is right. `time`: s, from any steady
  /// clock. Call it between frames.
  std::vector<ReloadReport> poll_files(double time);
  /// The same at once, without watching: every script whose files differ from what was last read of them.
  std::vector<ReloadReport> reload_changed(double time);

  /// Puts a text in place of a file below the root, for tests; reload_changed() then takes it up.
  void replace_file(const std::string& relative, std::string text) { folder_.replace(relative, std::move(text)); }
  std::optional<std::string> read_file(const std::string& relative) const { return folder_.read(relative); }

  std::vector<MachineStatus> machines() const;
  /// The declared machines, for graphs, checks and coverage.
  std::vector<const MachineDefinition*> definitions() const;
  /// What each module that was required offers, by its name ("lib.walk").
  std::map<std::string, std::set<std::string>> module_fields() const;

 private:
  struct Slot;

  bool look_up(std::string_view name, MachineSight& sight) const override;
  std::vector<std::string> machine_names() const override;

  Slot& load(const std::string& name, ScriptKind kind);
  std::string file_of(const std::string& name, ScriptKind kind) const;
  std::unique_ptr<Script> compile(const Slot& slot, BundleHashes& hashes) const;
  void refuse_taken_names(const Slot& slot, const Script& script) const;
  std::vector<std::string> swap_in(Slot& slot, std::unique_ptr<Script>& script);
  ReloadReport reload(Slot& slot, double time);
  void tick(Slot& slot);
  void note_fault(Slot& slot, ScriptFault fault);

  ScriptFolder folder_;
  ParameterRegistry& parameters_;
  const ScriptLimits& limits_;
  FileWatcher watcher_;
  std::vector<std::unique_ptr<Slot>> slots_;
  ScriptOutput output_;
  FrameDraft draft_;
  std::vector<double> world_;
  double time_ = 0.0;
};

}  // namespace reorient
