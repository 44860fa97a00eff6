// SPDX-License-Identifier: MIT
#include "program/run/companion/run_companion.h"

#include <memory>
#include <optional>
#include <ostream>
#include <random>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "engine/record/digest.h"
#include "program/former_names.h"
#include "program/interruption.h"
#include "program/monotonic_clock.h"
#include "program/output_mailbox.h"
#include "program/run/companion/state_file.h"
#include "program/run/console/history_file.h"
#include "program/run/console/name_pattern.h"
#include "program/run/live/run_live_view.h"
#include "program/run/live_run.h"
#include "program/run/missing_interface.h"
#include "program/run/simulation.h"
#include "program/run/venue.h"
#include "program/safe_output.h"
#include "robots/companion/companion.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/body_file.h"
#include "workbench/files/field_file.h"
#include "workbench/files/interface_file.h"

namespace reorient {
namespace {

std::uint64_t random_number() {
  std::random_device device;
  return (static_cast<std::uint64_t>(device()) << 32) | device();
}

/// The robots and fields that this program has files of. A client with another robot or field sends its dimensions.
KnownRobots known_robots(const RunOptions& options) {
  const auto named = [](const std::string& name, auto load) -> decltype(std::optional(load(name))) {
    try {
      if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-_") != std::string::npos)
        return std::nullopt;
      return load(name);
    } catch (const std::runtime_error&) {
      return std::nullopt;
    }
  };
  return {[named](const std::string& name) {
            return named(name, [](const std::string& one) { return load_body(body_file(one)); });
          },
          [named](const std::string& name) {
            return named(name, [](const std::string& one) { return load_field(field_file(one)); });
          },
          parse_interface, interface_named(options.interface)};
}

/// The program's version and a digest of everything else that must be equal when a process continues from a saved
/// state. It contains --sides-changed, because the state is in the axes of one half: otherwise the model file would be
/// saved in the wrong axes.
std::string circumstances_of(const Handshake& handshake, const FrameSetup& setup, const RunOptions& options) {
  std::vector<std::byte> bytes;
  ByteWriter out(bytes);
  out(identity_of(handshake), setup.room_awareness, setup.behaviors, setup.parameters, options.model.string(),
      options.sides_changed);
  Digest digest;
  digest.add(bytes);
  return REORIENT_VERSION " " + digest.hex();
}

/// The companion as the robot of the run loop: saves the state before it waits for the next frame.
class KeptCompanion : public Robot {
 public:
  KeptCompanion(Companion& companion, StateKeeper& keeper) : companion_(companion), keeper_(keeper) {}
  void set_engine(const FrameLoop& engine) { engine_ = &engine; }

  bool observe(Observation& observation) override {
    if (any_frame_) keeper_.keep(*engine_, companion_, monotonic_clock(), had_initial_pose_);
    const bool is_there = companion_.observe(observation);
    any_frame_ = any_frame_ || is_there;
    had_initial_pose_ = is_there && observation.external.initial_pose;
    return is_there;
  }
  bool any_frame() const { return any_frame_; }
  void answer(const Answer& answer) override {
    keeper_.release_command(companion_);
    companion_.answer(answer);
  }

 private:
  Companion& companion_;
  StateKeeper& keeper_;
  const FrameLoop* engine_ = nullptr;
  bool any_frame_ = false;
  bool had_initial_pose_ = false;
};

/// Sends the states of machines, log lines and faults to the client.
class CompanionReport : public Observer {
 public:
  explicit CompanionReport(Companion& companion) : companion_(companion) {}

  void observe(const FrameRecord& frame, const SceneTruth& /*scene*/) override {
    for (const MachineStatus& machine : frame.machines)
      companion_.tell_state(frame.name(machine.machine), machine.stopped ? "stopped" : frame.name(machine.state));
    for (const FaultRecord& fault : frame.faults)
      companion_.tell_note(NoteKind::fault, fault.script + ": " + fault.fault.message);
    for (const LogRecord& log : frame.logs) companion_.tell_note(NoteKind::log, log.text);
  }

 private:
  Companion& companion_;
};

/// The engine's setup for a client. Throws std::runtime_error with one line.
FrameSetup setup_for(const Handshake& handshake, const RunOptions& options, const ScriptTexts& scripts) {
  FrameSetup setup = engine_setup(
      options, scripts, handshake.body, handshake.field,
      {.head = handshake.carries_out_head, .walk = handshake.carries_out_walk, .get_up = handshake.carries_out_get_up});
  setup.application = handshake.application;
  return setup;
}

/// Reports errors of options and scripts at the start and not to the first client.
void try_out(const RunOptions& options, const ScriptTexts& scripts) {
  Handshake any_client;
  any_client.application =
      options.interface.empty() ? merged(known_interfaces(options.scripts)) : interface_named(options.interface);
  any_client.carries_out_head = any_client.carries_out_walk = any_client.carries_out_get_up = true;
  const FrameLoop engine(setup_for(any_client, options, scripts));
}

}  // namespace

int run_companion(const RunOptions& options, std::ostream& out, std::ostream& err) {
  ScriptEdits edits(options.scripts);
  try_out(options, edits.texts());
  // Before this point, nothing can be lost, so a signal ends the program at once, also while scripts load.
  const Interruption interruption;
  if (!options.model.empty()) require_writable_file(options.model, "--model");
  std::optional<SavedModel> model = model_to_begin_with(options);
  const std::filesystem::path socket = options.socket.empty() ? default_socket_path() : options.socket;
  const std::filesystem::path state = options.state.empty() ? socket.string() + ".state" : options.state.string();
  for (const std::filesystem::path& file : {state, aside_of(state)}) {
    require_writable_file(file, "--state");
    require_no_link(file);
  }
  const std::optional<RecorderOptions> recording_options = recorder_options(options, "");

  // The prompt's engine changes with each client of another robot.
  FrameLoop* engine_now = nullptr;
  RunControls controls(false, false);
  const OutputMailbox mailbox(out, err);
  const ConsoleSubject subject{
      .parameters = [&] { return engine_now != nullptr ? engine_now->parameters() : std::vector<Parameter>(); },
      .scripts = [&] { return edits.known(); },
      .engine = [&] { return engine_now; },
      .controls = &controls};
  LiveConsole console(STDIN_FILENO, out, subject, history_path());
  const LiveViewPointer view = start_live_view(options.live, LiveLoad::usual, subject, options.scripts, console, err);
  const auto is_over = [&] {
    if (engine_now == nullptr) {
      console.poll_without_robot();
      poll_without_robot(view.get());
    }
    return is_ended_by_hand(console);
  };
  LiveRun* live_now = nullptr;
  const auto tell = [&](const std::string& line) {
    if (live_now != nullptr) return live_now->tell(printable(line));
    print_error(err, printable(line));
  };
  Companion companion({.socket = socket,
                       .known = known_robots(options),
                       .server = random_number(),
                       .now = monotonic_clock,
                       .is_over = is_over,
                       .tell = tell,
                       .stores_commands = true});
  err << "reorient: listening at " << as_line(socket.string()) << "; waiting for a client\n" << std::flush;

  bool fresh = options.fresh;
  std::vector<std::string> failures;
  while (const Handshake* const connected = companion.wait_for_handshake()) {
    const Handshake handshake = *connected;
    std::optional<StateKeeper> kept;
    std::unique_ptr<FrameLoop> engine;
    std::size_t behaviors = 0;
    bool continues = false;
    try {
      FrameSetup setup = setup_for(handshake, options, edits.texts());
      setup.model = model;
      behaviors = setup.behaviors.size();
      kept.emplace(state, circumstances_of(handshake, setup, options));
      std::string why_not;
      if (!fresh) engine = kept->restore(companion, why_not);
      continues = engine != nullptr;
      if (continues) edits.add_missed(engine->scripts());
      if (!why_not.empty()) spdlog::warn("{}: state not used: {}", state.string(), why_not);
      if (!engine) engine = std::make_unique<FrameLoop>(std::move(setup));
      warn_of_missing_values(options.scripts, engine->scripts(), files_of(*engine), engine->application());
    } catch (const std::exception& error) {
      // A model of another wall, or a script with a new error. Other clients may connect, and the script may be fixed.
      const bool is_models = dynamic_cast<const UnfitModel*>(&error) != nullptr;
      const std::string mistake = (is_models ? "--model " + options.model.string() + ": " : "") + error.what();
      companion.refuse(mistake);
      continue;
    }
    StateKeeper& keeper = *kept;
    fresh = false;
    engine_now = engine.get();
    companion.begin(handshake, continues, static_cast<int>(behaviors));
    err << fmt::format("reorient: client connected: {}, field of {:.1f} x {:.1f} m, {} localization, {}, {}\n",
                       printable(handshake.body.name), handshake.field.length, handshake.field.width,
                       handshake.own_localization ? "its own" : "Reorient's", counted(behaviors, "behavior"),
                       continues ? "continues from the saved state" : "starts without knowledge")
        << std::flush;

    LiveRun live(options, console, out, err);
    live_now = &live;
    CompanionReport report(companion);
    auto owned = std::make_unique<KeptCompanion>(companion, keeper);
    KeptCompanion* const robot = owned.get();
    robot->set_engine(*engine);
    RobotInstance instance{std::move(owned), handshake.body, RobotInstance::Clock::real, nullptr, nullptr};
    controls.take();  // those for the client before
    controls.set_field(handshake.field);
    live.run({.parts = {.robot = instance,
                        .engine = *engine,
                        .sources = {},
                        .observers = {&report},
                        .stop = {},
                        .controls = &controls},
              .edits = &edits,
              .model = model,
              .recording = recording_options,
              .live = view.get()});
    if (robot->any_frame()) keeper.finish(*engine, companion);
    live.end_recording();
    if (live.model() != nullptr) {
      const std::size_t before = failures.size();
      live.save_model(failures);
      try_to_write(failures, [&] { model = model_to_begin_with(options); });
      for (std::size_t i = before; i < failures.size(); ++i) print_error(err, failures[i]);
    }
    engine_now = nullptr;
    live_now = nullptr;
    if (is_over() || !companion.has_other_robot()) break;
  }
  end_live_view(view.get(), user_who_ended_run(console.wants_to_quit()), out);
  const Companion::Counts& counts = companion.counts();
  out << fmt::format("{} of {}: {} superseded by newer ones, {} unusable; {} not sent\n",
                     counted(counts.frames, "frame"), counted(counts.clients, "client"), counts.superseded,
                     counts.unusable, counted(counts.unanswered, "answer"));
  if (counts.percepts > 0) out << counted(counts.percepts, "percept") << " with invalid numbers dropped\n";
  return exit_code_of_runs(failures);
}

}  // namespace reorient
