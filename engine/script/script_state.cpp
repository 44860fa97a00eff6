// SPDX-License-Identifier: MIT
// The state of the scripts as bytes. Lua's own memory is not included: a script is compiled again from its texts
// and gets its kept values back.
#include <algorithm>

#include "engine/script/script_error.h"
#include "engine/script/script_host.h"
#include "engine/script/script_slot.h"

namespace reorient {
namespace {

constexpr std::uint32_t kMostScripts = 1000;

template <typename Archive>
void archive_counters(Archive& archive, ScriptSlot& slot) {
  archive(slot.file, slot.read, slot.swapped_at, slot.recent_errors, slot.errors, slot.last_error_at, slot.last_error,
          slot.stopped, slot.frames, slot.instructions_before, slot.called, slot.visit, slot.end, slot.given,
          slot.was_refused);
}

/// Limits outside of their ranges could let a script run forever.
struct RangeCheck {
  template <typename Number>
  void operator()(const char*, Number& value, Number least, Number most, const char*, const char*) {
    check_bytes(value >= least && value <= most, "script: limit out of range");
  }
};

void save_script(ByteWriter& out, Script& script) {
  std::vector<std::string> left_out;
  out(script.limits(), script.sources(), script.memory(left_out), script.sandbox());
}

constexpr std::uint32_t kNoCaller = kMostScripts;

}  // namespace

void ScriptHost::save(ByteWriter& out) const {
  out(texts_, names_, time_, static_cast<std::uint32_t>(slots_.size()));
  for (const auto& slot : slots_) {
    archive_counters(out, *slot);
    const auto caller =
        std::find_if(slots_.begin(), slots_.end(), [&](const auto& it) { return it.get() == slot->caller; });
    out(slot->caller == nullptr ? kNoCaller : static_cast<std::uint32_t>(caller - slots_.begin()));
    save_script(out, *slot->script);
    for (const ScriptSlot::Running& running : slot->machines) out(running.machine);
    out(slot->last_good != nullptr);
    if (slot->last_good) save_script(out, *slot->last_good);
  }
}

void ScriptHost::restore(ByteReader& in) {
  std::uint32_t count = 0;
  in(texts_, names_, time_, count);
  check_bytes(count <= kMostScripts, "too many scripts");
  for (std::uint32_t i = 0; i < count; ++i) {
    auto slot = std::make_unique<ScriptSlot>();
    restore(*slot, in);
    if (slot->caller != nullptr) slot->caller->callees.push_back(slot.get());
    slots_.push_back(std::move(slot));
  }
}

void ScriptHost::restore(ScriptSlot& slot, ByteReader& in) {
  archive_counters(in, slot);
  std::uint32_t caller = kNoCaller;
  in(caller);
  check_bytes(caller < slots_.size() || caller == kNoCaller, "script: unknown caller");
  if (caller != kNoCaller) slot.caller = slots_[caller].get();
  check_bytes(slot.called.has_value() == (slot.caller != nullptr), "script: expected a caller");
  check_bytes(!slot.called || slot.caller->machine_named(slot.called->caller) != nullptr, "script: unknown caller");
  for (const auto& other : slots_) {
    const bool is_same_call = slot.caller == nullptr || (other->called && other->called->caller == slot.called->caller);
    check_bytes(other->file != slot.file || other->caller != slot.caller || !is_same_call, "script: listed twice");
  }
  slot.script = restored_script(slot, in);
  check_bytes(slot.caller == nullptr || slot.script->machines().size() == 1, "script: expected one machine");
  for (const MachineDefinition& definition : slot.script->machines()) {
    slot.machines.push_back({Machine(definition), {}, 0.0});
    in(slot.machines.back().machine);
  }
  bool has_last_good = false;
  in(has_last_good);
  if (has_last_good) slot.last_good = restored_script(slot, in);
  try {
    parameters_.declare_for(slot.file, slot.script->parameters());
  } catch (const std::runtime_error& error) {
    throw BadBytes(error.what());
  }
}

std::unique_ptr<Script> ScriptHost::restored_script(const ScriptSlot& slot, ByteReader& in) {
  ScriptLimits limits;
  ScriptTexts sources;
  Script::Memory memory;
  in(limits, sources, memory);
  describe(limits, RangeCheck{});
  BundleHashes ignored;
  try {
    require_room(slots_, slot, limits);
    auto script =
        std::make_unique<Script>(sources, slot.file, language_, limits, parameters_, directory_, ignored, slot.called);
    refuse_taken_names(slot, *script);
    in(script->sandbox());
    script->restore(memory);
    script->intern(names_);
    return script;
  } catch (const ScriptError& error) {
    throw BadBytes(error.what());
  }
}

}  // namespace reorient
