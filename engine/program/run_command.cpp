#include "engine/program/run_command.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <ostream>
#include <stdexcept>
#include <thread>

#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "engine/assets/field_file.h"
#include "engine/core_parameters.h"
#include "engine/frame.h"
#include "engine/parameters/parameter_registry.h"
#include "engine/program/program.h"
#include "engine/program/report.h"
#include "engine/program/run_pictures.h"
#include "engine/record/frame_times.h"
#include "engine/record/run_history.h"
#include "robots/simulator/simulator.h"

namespace reorient {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) { return std::chrono::duration<double>(Clock::now() - start).count(); }

/// Everything that can be tuned in a simulated run, under one roof.
struct Tuning {
  CoreParameters core;
  SimulatorParameters simulator;
  RoomShape room_shape;
  ParameterRegistry registry;

  explicit Tuning(int image_width) {
    simulator.image = image_width == 640   ? ImageSize::vga_640x480
                      : image_width == 320 ? ImageSize::qvga_320x240
                                           : ImageSize::qqvga_160x120;
    declare(core, registry);
    registry.bind("simulator", simulator);
    registry.bind("body", simulator.body);
    registry.bind("sensor", simulator.sensor);
    registry.bind("room_shape", room_shape);
  }
  Tuning(const Tuning&) = delete;
};

void override_parameters(ParameterRegistry& registry, const RunOptions& options) {
  for (const std::filesystem::path& file : options.parameter_files) registry.load_file(file);
  for (const std::string& assignment : options.set) {
    const std::size_t equals = assignment.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw std::runtime_error("--set '" + assignment + "': write NAME=VALUE, as in --set orientation.lead=0.3");
    }
    registry.set_early(assignment.substr(0, equals), assignment.substr(equals + 1), ParameterOrigin::command_line);
  }
}

/// Found out before the run, not after it; so is the next.
void require_writable_file(const std::filesystem::path& file) {
  std::filesystem::path probe = file;
  probe += ".partial";
  std::error_code failed;
  const bool writable = !std::filesystem::is_directory(file, failed) && std::ofstream(probe).put('x').flush().good();
  std::filesystem::remove(probe, failed);
  if (!writable) throw std::runtime_error("cannot write '" + file.string() + "'; name another file with --json");
}

void require_writable(const std::filesystem::path& folder) {
  std::error_code failed;
  std::filesystem::create_directories(folder, failed);
  const std::filesystem::path probe = folder / ".reorient-probe";
  const bool writable = !failed && std::ofstream(probe).put('x').flush().good();
  std::filesystem::remove(probe, failed);
  if (!writable)
    throw std::runtime_error("cannot write into '" + folder.string() + "'; name another folder with --out");
}

void obey(const ExperimenterAction& action, Experimenter& experimenter) {
  using Kind = ExperimenterAction::Kind;
  switch (action.kind) {
    case Kind::pick_up:
      experimenter.pick_up();
      break;
    case Kind::put_down:
      experimenter.put_down(action.pose);
      break;
    case Kind::push_over:
      experimenter.push_over();
      break;
    case Kind::penalize:
      experimenter.penalize(action.penalized);
      break;
    case Kind::set_exposure:
      experimenter.set_exposure(action.stops);
      break;
    case Kind::start_at:
      break;  // said to the robot, not done to it: the frame loop's
  }
}

void log_scripts(const ScriptOutput& output) {
  for (const LogRecord& record : output.logs) spdlog::info("{}: {}", record.issuer, record.text);
  for (const FaultRecord& fault : output.faults) {
    using Consequence = FaultRecord::Consequence;
    const char* consequence = fault.consequence == Consequence::rolled_back ? "; the version before runs again"
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
      spdlog::error("{}: the edit is refused, the version before goes on: {}", report.script, report.fault.text());
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
      "coverage {:.2f}, informative {:.2f}, goals {:.2f} {:.2f}",
      world.time, text(world.pose.pose), world.pose.share, world.pose.reflected_share,
      world.truth ? text(world.truth->pose) : "unknown", world.line_points, world.goal_posts,
      world.confidence.visible_tiles, world.confidence.coverage, world.confidence.informative,
      world.confidence.goal_opponent, world.confidence.goal_own);
}

std::string room_name(const RunOptions& options) {
  return options.room.empty() ? fmt::format("procedural hall {}", options.hall) : options.room;
}

}  // namespace

int run_scenario(const RunOptions& options, std::ostream& out, std::ostream& err) {
  Tuning tuning(options.width);
  override_parameters(tuning.registry, options);
  ScriptHost scripts(options.scripts, tuning.registry);
  scripts.load_scenario(options.scenario);
  for (const std::string& unclaimed : tuning.registry.unclaimed()) throw std::runtime_error(unclaimed);
  const FieldDimensions field = load_field(options.field);
  const Room room = options.room.empty() ? procedural_hall(options.hall, tuning.room_shape)
                                         : load_room(options.room, tuning.room_shape);
  const Pose2 beside_the_field(-field.penalty_mark_x, -0.5 * field.width - 0.5, kPi / 2.0);
  Simulator simulator(tuning.simulator, field, room, beside_the_field, options.seed);
  TimedRobot robot(simulator);
  FrameLoop frame(robot, scripts, tuning.core, field, {options.seed, options.room_awareness});
  // Last, so that a mistake in anything else leaves no empty folder behind.
  if (!options.json.empty()) require_writable_file(options.json);
  if (options.pictures) require_writable(options.out);

  RunHistory history;
  RunPictures pictures;
  Progress progress(err);
  const Clock::time_point start = Clock::now();
  std::optional<ScenarioVerdict> verdict;
  FrameTimes frame_times;
  ReloadCounts reloads;
  const auto step = [&] {
    const Clock::time_point begin = Clock::now();
    // Right before the frame, so that an edit does not wait for one frame more.
    if (options.realtime) log_reloads(scripts.poll_files(seconds_since(start)), reloads);
    if (!frame.step()) return false;
    frame_times.add(seconds_since(begin), robot.observing());
    return true;
  };
  while (!verdict && frame.world().time < options.seconds && step()) {
    for (const ExperimenterAction& action : frame.script_output().actions) obey(action, simulator);
    history.add(frame);
    if (options.pictures) pictures.look(frame);
    log_scripts(frame.script_output());
    log_pose(frame.world());
    progress.show(frame, scripts, start);
    verdict = frame.script_output().verdict;
    if (options.realtime) std::this_thread::sleep_until(start + std::chrono::duration<double>(frame.world().time));
  }
  progress.end();

  const RunCircumstances circumstances{.scenario = options.scenario,
                                       .room = room_name(options),
                                       .seed = options.seed,
                                       .room_awareness = options.room_awareness,
                                       .wall_seconds = seconds_since(start),
                                       .digest = frame.digest().hex(),
                                       .frame_time = frame_times.whole(),
                                       .frame_time_without_rendering = frame_times.without_observing(),
                                       .reloads_accepted = reloads.accepted,
                                       .reloads_refused = reloads.refused};
  const RunSummary summary = summarize(history, verdict);
  if (options.pictures) pictures.write(frame, history, options.out);
  if (!options.json.empty()) write_summary(summary, history, circumstances, options.json);
  print_timeline(history, options.every_transition, out);
  if (options.pictures) out << "\npictures: " << options.out.string() << "/\n";
  print_summary(summary, circumstances, out);
  return summary.right && summary.succeeded ? kSuccess : kWrong;
}

}  // namespace reorient
