// SPDX-License-Identifier: MIT
// The scripts of one kind: loaded, ticked once a frame, reloaded while they run. What survives a reload is kept here.
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

/// How a machine stands after a tick.
struct MachineStatus {
  NameId machine = kNoName;
  NameId state = kNoName;   ///< path
  double entered_at = 0.0;  ///< s
  bool stopped = false;     ///< after too many errors
  int errors = 0;           ///< of its script, since it was loaded
};
template <typename Visit, ConstOr<MachineStatus> T>
void fields(Visit&& visit, T& status) {
  visit(status.machine, status.state, status.entered_at, status.stopped, status.errors);
}

/// What a machine's script costs: of this computer, so never part of a decision or of a digest.
struct MachineCost {
  NameId machine = kNoName;
  double microseconds = 0.0;      ///< in the frame before
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
  /// All references must outlive the host; changed limits hold for what is loaded from then on. `directory`: whose
  /// machines scripts see as `behaviors`; nullptr: this host's own.
  ScriptHost(ScriptTexts texts, ScriptLanguage& language, ParameterRegistry& parameters,
             const ScriptLimits& limits = kDefaultLimits, const MachineDirectory* directory = nullptr);
  ~ScriptHost() override;
  ScriptHost(const ScriptHost&) = delete;
  ScriptHost& operator=(const ScriptHost&) = delete;

  /// "orientation" or "behaviors/orientation.lua". Throws ScriptError; a script that is loaded already is left as it
  /// is.
  void load(const std::string& name);

  /// One frame: every machine ticks, in the order of loading. `world`: values in the order of the language's fields.
  /// The output is valid until the next tick.
  const ScriptOutput& tick(double time, std::span<const double> world);

  /// All leases that are held now, appended.
  void append_leases(std::vector<Lease>& leases) const;

  /// Takes edits over and swaps in every script that they concern and that is right. One report for each such script.
  std::vector<ReloadRecord> apply(std::span<const ScriptEdit> edits);

  const ScriptTexts& texts() const { return texts_; }
  const Names& names() const { return names_; }

  /// All that decides what comes next: texts, machines, what scripts keep, errors, versions to fall back to. What a
  /// script holds in locals is none of it.
  void save(ByteWriter& out) const;
  /// Into a host without scripts, whose parameters have been restored. Throws BadBytes.
  void restore(ByteReader& in);

  // Into lists that keep their memory.
  void read_status(std::vector<MachineStatus>& all) const;
  void read_costs(std::vector<MachineCost>& all) const;
  void read_conditions(std::vector<OpenCondition>& all) const;
  void read_published(std::vector<NameId>& all) const;

  /// The declared machines, for graphs, checks and coverage.
  std::vector<const MachineDefinition*> definitions() const;
  /// What each module that was required offers, by its name ("lib.walk").
  std::map<std::string, std::set<std::string>> module_fields() const;

  bool look_up(std::string_view name, MachineSight& sight) const override;
  std::vector<std::string> machine_names() const override;
  bool is_published(std::string_view flag) const override;

 private:
  std::unique_ptr<Script> compile(const ScriptSlot& slot, BundleHashes& hashes) const;
  void refuse_taken_names(const ScriptSlot& slot, const Script& script) const;
  std::vector<std::string> swap_in(ScriptSlot& slot, std::unique_ptr<Script>& script);
  ReloadRecord reload(ScriptSlot& slot);
  void tick(ScriptSlot& slot, std::span<const double> world);
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
  std::vector<std::unique_ptr<ScriptSlot>> slots_;
  ScriptOutput output_;
  std::vector<NameId> published_;  ///< as the frame began
  double time_ = 0.0;
};

}  // namespace reorient
