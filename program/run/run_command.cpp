#include <chrono>
#include <cmath>
#include <memory>
#include <optional>
#include <ostream>
#include <thread>

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "program/program.h"
#include "program/run/live_console.h"
#include "program/run/report.h"
#include "program/run/run_pictures.h"
#include "program/run/simulated_run.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/parameter_file.h"
#include "workbench/run/frame_times.h"
#include "workbench/run/run_history.h"

namespace reorient {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

void log_scripts(const ScriptOutput& output) {
  for (const LogRecord& record : output.logs) spdlog::info("{}: {}", record.issuer, record.text);
  for (const FaultRecord& fault : output.faults) {
    using Consequence = FaultRecord::Consequence;
    const char* consequence = fault.consequence == Consequence::rolled_back ? "; the previous version runs again"
                              : fault.consequence == Consequence::stopped   ? "; it is stopped until it is edited"
                                                                            : "";
    spdlog::error("{}{}", fault.fault.text(), consequence);
  }
}

struct ReloadCounts {
  int accepted = 0;
  int refused = 0;
};

void log_reloads(const std::vector<ReloadReport>& reports, ReloadCounts& counts) {
  for (const ReloadReport& report : reports) {
    ++(report.accepted ? counts.accepted : counts.refused);
    if (report.accepted) {
      spdlog::info("{}: the edit is running", report.script);
    } else {
      spdlog::error("{}: edit rejected; keeping the previous version: {}", report.script, report.fault.text());
    }
    for (const std::string& warning : report.warnings) spdlog::warn("{}: {}", report.script, warning);
  }
}

/// One line on `err` that a terminal overwrites; without a terminal a line for every ten seconds of the robot's time.
class Progress {
 public:
  explicit Progress(std::ostream& err) : err_(err), terminal_(isatty(STDERR_FILENO) == 1) {}

  void show(const FrameLoop& frame, const ScriptHost& scripts, Clock::time_point start) {
    const double time = frame.world().time;
    if (time < next_) return;
    next_ = time + (terminal_ ? 0.5 : 10.0);
    std::string states;
    for (const MachineStatus& machine : scripts.machines()) {
      if (machine.is_scenario || machine.name == "orientation") states += "  " + machine.name + ": " + machine.state;
    }
    const Confidences& confidence = frame.world().confidence;
    err_ << fmt::format("{}{:6.1f} s  current {:.2f}  opposite {:.2f}{}  {:.1f}x real time{}",
                        terminal_ ? "\r\033[K" : "", time, confidence.current, confidence.opposite, states,
                        time / seconds_since(start), terminal_ ? "" : "\n")
         << std::flush;
  }
  void end() {
    if (terminal_) err_ << "\r\033[K" << std::flush;
  }

 private:
  std::ostream& err_;
  bool terminal_;
  double next_ = 0.0;
};

/// Where the robot is and where it believes it is, once a second.
void log_pose(const World& world) {
  if (world.time - std::floor(world.time) >= world.time_step || !spdlog::should_log(spdlog::level::debug)) return;
  const auto text = [](const Pose2& pose) {
    return fmt::format("({:.2f}, {:.2f}, {:.0f} deg)", pose.position.x(), pose.position.y(), to_degrees(pose.rotation));
  };
  spdlog::debug(
      "{:.1f} s: belief {} share {:.2f} reflected {:.2f}, truth {}; {} line points, {} posts, {} tiles, "
      "coverage {:.2f}, distinctiveness {:.2f}, goals {:.2f} {:.2f}",
      world.time, text(world.pose.pose), world.pose.cluster_weight, world.pose.reflected_weight,
      world.truth ? text(world.truth->pose) : "unknown", world.line_points, world.goal_posts,
      world.confidence.visible_tiles, world.confidence.coverage, world.confidence.distinctiveness,
      world.confidence.goal_opponent, world.confidence.goal_own);
}

std::string room_name(const RunOptions& options) {
  return options.room.empty() ? fmt::format("procedural hall {}", options.hall) : options.room;
}

void add_options(CLI::App& run, RunOptions& options) {
  run.add_option("scenario", options.scenario, "scripts/scenarios/NAME.lua, or a path to a file")
      ->capture_default_str();
  run.add_option("--with", options.with, "a behaviour beside those of the scenario; may be given again")
      ->allow_extra_args(false);
  run.add_option("--room", options.room, "equirectangular panorama: .hdr, .png or .jpg (default: a procedural hall)");
  run.add_option("--hall-seed", options.hall, "seed of the procedural hall")->check(check_seed)->capture_default_str();
  run.add_option("--field", options.field, "field dimensions (default: assets/fields/spl.toml)");
  run.add_option("--seed", options.seed, "of all noise; one seed, one digest")
      ->check(check_seed)
      ->capture_default_str();
  run.add_option("--width", options.width, "of the camera image, pixels")
      ->check(CLI::IsMember({160, 320, 640}))
      ->capture_default_str();
  run.add_flag("--realtime", options.realtime,
               "at the robot's own pace: scripts are reloaded when they are saved; Enter opens a prompt for commands");
  run.add_flag("!--no-room-awareness", options.room_awareness, "switch the view of the room off");
  add_parameter_options(run, options.parameters);
  run.add_option("--save-params", options.save_parameters,
                 "write what differs from the defaults at the end into this file");
  add_scripts_option(run, options.scripts);
  run.add_option("--out", options.out, "folder for the pictures")->capture_default_str();
  run.add_flag("!--no-pictures", options.pictures, "write no pictures");
  run.add_option("--json", options.json, "write the summary into this file, for programs");
  run.add_option("--seconds", options.seconds, "longest run, in the robot's seconds")
      ->check(check_seconds)
      ->capture_default_str();
  run.add_flag("--every-transition", options.every_transition, "show busy behaviours' transitions as well");
}

/// Returns the exit code.
int tell_results(const RunOptions& options, const RunCircumstances& circumstances, const RunHistory& history,
                 const std::optional<ScenarioVerdict>& verdict, std::ostream& out) {
  const RunSummary summary = summarize(history, verdict);
  if (!options.json.empty()) write_summary(summary, history, circumstances, options.json);
  print_timeline(history, options.every_transition, out);
  if (options.pictures) out << "\npictures: " << options.out.string() << "/\n";
  if (!options.save_parameters.empty()) out << "parameters: " << options.save_parameters.string() << "\n";
  print_summary(summary, circumstances, out);
  return summary.correct && summary.succeeded ? kSuccess : kWrong;
}

int run_scenario(const RunOptions& options, std::ostream& out, std::ostream& err) {
  SimulatedRun run(options);
  // Last, so that a mistake in anything else leaves no empty folder behind.
  if (!options.json.empty()) require_writable_file(options.json, "--json");
  if (!options.save_parameters.empty()) require_writable_file(options.save_parameters, "--save-params");
  if (options.pictures) require_writable_folder(options.out, "--out");

  RunHistory history;
  RunPictures pictures;
  FrameTimes frame_times;
  ReloadCounts reloads;
  Progress progress(err);
  std::optional<LiveConsole> console;
  if (options.realtime) {
    console.emplace(STDIN_FILENO);
    if (isatty(STDIN_FILENO) == 1)
      err << "saved scripts are taken over at once; Enter opens a prompt to tune parameters (help lists its "
             "commands)\n";
  }
  const Clock::time_point start = Clock::now();
  const auto step = [&] {
    const Clock::time_point begin = Clock::now();
    // Right before the frame, so that an edit does not wait for one frame more.
    if (options.realtime) log_reloads(run.scripts().poll_files(seconds_since(start)), reloads);
    if (!run.step()) return false;
    frame_times.add(seconds_since(begin), run.observing());
    return true;
  };
  while (!(console && console->wants_to_quit()) && step()) {
    const FrameLoop& frame = run.frame();
    history.add(frame);
    if (options.pictures) pictures.look(frame);
    log_scripts(frame.script_output());
    log_pose(frame.world());
    if (!(console && console->is_open())) progress.show(frame, run.scripts(), start);
    if (options.realtime) {
      console->poll(run.parameters(), run.scripts(), out);
      std::this_thread::sleep_until(start + std::chrono::duration<double>(frame.world().time));
    }
  }
  progress.end();

  const RunCircumstances circumstances{.scenario = options.scenario,
                                       .room = room_name(options),
                                       .seed = options.seed,
                                       .room_awareness = options.room_awareness,
                                       .wall_seconds = seconds_since(start),
                                       .digest = run.frame().digest().hex(),
                                       .frame_time = frame_times.whole(),
                                       .frame_time_without_rendering = frame_times.without_observing(),
                                       .reloads_accepted = reloads.accepted,
                                       .reloads_refused = reloads.refused};
  if (options.pictures) pictures.write(run.frame(), history, options.out);
  if (!options.save_parameters.empty()) save_parameters(run.parameters(), options.save_parameters);
  return tell_results(options, circumstances, history, run.verdict(), out);
}

}  // namespace

Subcommand add_run(CLI::App& program) {
  const auto options = std::make_shared<RunOptions>();
  CLI::App* const parser = program.add_subcommand("run", "run a scenario on the simulator")->fallthrough();
  add_options(*parser, *options);
  return {parser, [options](std::ostream& out, std::ostream& err) {
            options->scripts = scripts_root(options->scripts);
            return run_scenario(*options, out, err);
          }};
}

}  // namespace reorient
