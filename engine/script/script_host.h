// SPDX-License-Identifier: MIT
// The scripts of one type: loaded, ticked once per frame, reloaded while they run. Stores what survives a reload.
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
#include "engine/script/script.h"
#include "engine/script/script_output.h"
#include "geometry/const_or.h"

namespace reorient {

/// The status of a machine after a tick.
struct MachineStatus {
  NameId machine = kNoName;
  NameId state = kNoName;   ///< path
  double entered_at = 0.0;  ///< s
  bool stopped = false;     ///< after too many errors
  int errors = 0;           ///< of its script since loading
};
template <typename Visit, ConstOr<MachineStatus> T>
void fields(Visit&& visit, T& status) {
  visit(status.machine, status.state, status.entered_at, status.stopped, status.errors);
}

/// Cost of a machine's script: depends on the computer, so it is part of neither decisions nor digests.
struct MachineCost {
  NameId machine = kNoName;
  double microseconds = 0.0;      ///< in the previous frame
  std::int64_t instructions = 0;  ///< per frame on average
  std::uint64_t memory = 0;       ///< bytes
};
template <typename Visit, ConstOr<MachineCost> T>
void fields(Visit&& visit, T& cost) {
  visit(cost.machine, cost.microseconds, cost.instructions, cost.memory);
}

struct ScriptSlot;

class ScriptHost : public MachineDirectory {
 public:
  /// All references must outlive the host; changed limits apply to scripts that are loaded later. `directory`: the
  /// machines that scripts read as `behaviors`; nullptr: this host's own.
  ScriptHost(ScriptTexts texts, ScriptLanguage& language, ParameterRegistry& parameters,
             const ScriptLimits& limits = kDefaultLimits, const MachineDirectory* directory = nullptr);
  ~ScriptHost() override;
  ScriptHost(const ScriptHost&) = delete;
  ScriptHost& operator=(const ScriptHost&) = delete;

  /// "orientation" or "behaviors/orientation.lua", and the behaviors that it runs. Throws ScriptError; without effect
  /// if the script is already loaded. `arguments`: values for its `args`, as a caller gives them.
  void load(const std::string& name, std::vector<CallArgument> arguments = {});

  /// One frame: every machine ticks, in the order of loading. `world`: values in the order of the language's fields.
  /// The output is valid until the next tick.
  const ScriptOutput& tick(double time, std::span<const double> world);

  /// Appends all active leases.
  void append_leases(std::vector<Lease>& leases) const;

  /// Applies edits and replaces every affected script that is valid. Reports one result per affected script.
  std::vector<ReloadRecord> apply(std::span<const ScriptEdit> edits);

  const ScriptTexts& texts() const { return texts_; }
  const Names& names() const { return names_; }

  /// The whole state: texts, machines, kept values, errors, versions to fall back to. Local variables of a script
  /// are not included.
  void save(ByteWriter& out) const;
  /// Restores into a host without scripts, whose parameters have been restored. Throws BadBytes.
  void restore(ByteReader& in);

  // Write into lists whose memory is reused.
  void read_status(std::vector<MachineStatus>& all) const;
  void read_costs(std::vector<MachineCost>& all) const;
  void read_conditions(std::vector<OpenCondition>& all) const;
  void read_published(std::vector<NameId>& all) const;

  /// The declared machines, for graphs, checks and coverage.
  std::vector<const MachineDefinition*> definitions() const;
  /// The `args` of a script that was loaded by name.
  std::vector<ParameterDeclaration> arguments_of(const std::string& file) const;
  /// The fields of each required module, by its name ("lib.walk").
  std::map<std::string, std::set<std::string>> module_fields() const;

  bool look_up(std::string_view name, MachineSight& sight) const override;
  bool is_published(std::string_view flag) const override;
  bool look_up_called(const Machine& caller, std::string_view behavior, CalledSight& sight) const override;

 private:
  using Slots = std::vector<std::unique_ptr<ScriptSlot>>;
  /// A behavior that another one runs, before its caller was accepted.
  struct Callee {
    std::unique_ptr<ScriptSlot> slot;
    std::unique_ptr<Script> script;
  };

  std::unique_ptr<Script> compile(const ScriptSlot& slot, BundleHashes& hashes) const;
  void refuse_taken_names(const ScriptSlot& slot, const Script& script) const;
  std::vector<std::string> swap_in(ScriptSlot& slot, std::unique_ptr<Script>& script);
  ReloadRecord reload(ScriptSlot& slot);
  void tick(ScriptSlot& slot, std::span<const double> world);
  template <typename Run>
  void run_frame(ScriptSlot& slot, std::span<const double> world, Run&& run);

  // Behaviors that others run (script_calls.cpp).
  void compile_callees(ScriptSlot& slot, const Script& script, BundleHashes& hashes, std::vector<Callee>& all) const;
  static const Script* known_callee(const ScriptSlot& slot, const MachineDefinition& machine,
                                    const CallDefinition& call, const std::vector<Callee>& all);
  const Script& compile_callee(ScriptSlot& caller, const MachineDefinition& machine, const CallDefinition& call,
                               BundleHashes& hashes, std::vector<Callee>& all) const;
  void take_in_callees(ScriptSlot& slot, std::vector<Callee>& callees);
  void remove(ScriptSlot& slot);
  void set_priorities(ScriptSlot& slot);
  void renew_callees();
  void check_callers(const ScriptSlot& slot, const Script& script) const;
  void tick_callees(ScriptSlot& caller, std::span<const double> world);
  void tick_callee(ScriptSlot& caller, ScriptSlot& callee, std::span<const double> world);
  bool give_arguments(ScriptSlot& caller, ScriptSlot& callee, Machine& machine, const CallDefinition& call);

  void note_faults(ScriptSlot& slot, std::vector<ScriptFault> faults);
  FaultRecord::Consequence count_fault(ScriptSlot& slot, const ScriptFault& fault);
  void renew_names();
  void restore(ScriptSlot& slot, ByteReader& in);
  std::unique_ptr<Script> restored_script(const ScriptSlot& slot, ByteReader& in);

  ScriptTexts texts_;
  ScriptLanguage& language_;
  ParameterRegistry& parameters_;
  const ScriptLimits& limits_;
  const MachineDirectory& directory_;
  Names names_;
  Slots slots_;  ///< each before the behaviors that it runs
  ScriptOutput output_;
  std::vector<NameId> published_;  ///< at the start of the frame
  double time_ = 0.0;
};

}  // namespace reorient
