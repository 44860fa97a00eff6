// SPDX-License-Identifier: MIT
// Functions of tests that replay a recording: the recorded frames with the current behaviors.
#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include "engine/parameters/nearest_name.h"
#include "engine/script/language/world_fields.h"
#include "engine/script/sandbox/sandbox.h"
#include "workbench/script_tools/testing/test_bench.h"

namespace reorient {
namespace {

constexpr double kTimeTolerance = 1e-6;  // s: times of frames are sums of rounded steps

}  // namespace

/// replay "recordings/flip.mcap" loads a recording; advance() and advance_to() continue it.
void TestBench::replay(std::string_view file) {
  if (behaviors_ || scenario_)
    throw std::runtime_error("replay: this test has already loaded behaviors for a fake world (use a separate test)");
  if (file.find('\0') != std::string_view::npos)
    throw std::runtime_error("replay: expected a file name without zero bytes");
  // Opening a recording takes about as much time as this number of instructions.
  constexpr std::int64_t kPriceOfARecording = 1'000'000;
  Sandbox::of(lua_).charge(kPriceOfARecording);
  if (!play_recording_) throw std::runtime_error("replay: recordings are not supported here");
  within_budget([&] { replay_ = play_recording_(std::string(file), texts_, [this] { return budget_.exceeded(); }); });
  added_ = {};
  seen_ = {};
  step_replay();
  read_machines();
}

/// Calls `play`, whose exception is that of an exceeded budget if it was stopped for that.
void TestBench::within_budget(const std::function<void()>& play) {
  std::optional<std::string> failure;
  try {
    play();
  } catch (const std::runtime_error& error) {
    failure = error.what();
  }
  if (!failure) return;
  require_budget(lua_);
  throw std::runtime_error(*failure);
}

void TestBench::require_fake_world(const char* what) const {
  if (replay_)
    throw std::runtime_error(std::string(what) + ": expected a fake world, found a replay (its world was recorded)");
}

/// False at the end of the recording.
bool TestBench::step_replay() {
  const FrameRecord* frame = nullptr;
  within_budget([&] { frame = replay_->step(std::exchange(added_, {})); });
  if (frame == nullptr) return false;
  for (const ParameterOutcome& change : frame->parameter_changes) {
    if (!change.refusal.empty()) throw std::runtime_error(change.refusal);
  }
  for (const ReloadRecord& reload : frame->reloads) {
    if (!reload.accepted) refused_ = reload.fault;
  }
  seen_.note(*frame->names, frame->transitions, frame->logs, frame->faults);
  seen_.note_messages(frame->answer.messages);
  seen_.note_commands(frame->commands, frame->begun);
  faults_.insert(faults_.end(), frame->faults.size(), {});
  std::transform(frame->faults.begin(), frame->faults.end(),
                 faults_.end() - static_cast<std::ptrdiff_t>(frame->faults.size()),
                 [](const FaultRecord& fault) { return fault.fault; });
  trace_.note(replay_->machines(), *frame->names, frame->transitions);
  leases_ = frame->leases;
  request_ = frame->answer.request;
  const double before = std::exchange(replayed_world_, frame->world).time;
  replayed_machines_.clear();
  for (const MachineStatus& status : frame->machines)
    replayed_machines_.push_back({frame->name(status.machine), frame->name(status.state)});
  budget_.spend(std::max(0.0, replayed_world_.time - before));
  return true;
}

/// advance_to(43.5): up to the last frame that is not after this time of the recording.
void TestBench::advance_to(double time) {
  if (!replay_) throw std::runtime_error("advance_to: no recording is loaded (call replay \"FILE\" first)");
  if (!(time >= replayed_world_.time - kTimeTolerance))
    throw std::runtime_error("advance_to: expected a later time, this replay is already at " +
                             std::to_string(replayed_world_.time) + " s");
  begin_advance();
  while (replayed_world_.time + 0.5 * replayed_world_.time_step <= time) {
    require_budget(lua_);
    if (!step_replay())
      throw std::runtime_error("the recording ends at " + std::to_string(replayed_world_.time) + " s");
  }
  read_machines();
}

/// A value of the world in this frame, as behaviors see it.
int TestBench::world_value(lua_State* L) {
  const std::string name = luaL_checkstring(L, 1);
  const std::span<const WorldField> all = world_fields();
  const auto field =
      std::find_if(all.begin(), all.end(), [&](const WorldField& each) { return each.full_name() == name; });
  if (field == all.end()) {
    std::vector<std::string> known;
    for (const WorldField& each : all) known.push_back(each.full_name());
    throw std::runtime_error("world_value: unknown world field '" + name + "'" + did_you_mean(name, known));
  }
  std::vector<double> values;
  append_world(world(), values);
  const double value = values[static_cast<std::size_t>(field - all.begin())];
  if (field->type == WorldField::Type::boolean) {
    lua_pushboolean(L, value != 0.0 ? 1 : 0);
  } else if (field->type == WorldField::Type::name) {
    const std::string_view text = field->names[static_cast<std::size_t>(value)];
    lua_pushlstring(L, text.data(), text.size());
  } else {
    lua_pushnumber(L, value);
  }
  return 1;
}

void TestBench::expect_as_recorded() {
  if (!replay_) throw std::runtime_error("expect.as_recorded: no recording is loaded (call replay \"FILE\" first)");
  if (const std::optional<std::string> difference = replay_->first_difference())
    fail("the recorded actions of the robot", *difference);
}

}  // namespace reorient
