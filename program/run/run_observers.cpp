// SPDX-License-Identifier: MIT
#include "program/run/run_observers.h"

#include <cmath>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <spdlog/details/null_mutex.h>
#include <spdlog/fmt/fmt.h>
#include <spdlog/sinks/base_sink.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "program/log.h"
#include "program/program_output.h"
#include "workbench/run/log_lines.h"

namespace reorient {
namespace {

spdlog::level::level_enum level_of(LogLine::Level level) {
  return level == LogLine::Level::info      ? spdlog::level::info
         : level == LogLine::Level::warning ? spdlog::level::warn
                                            : spdlog::level::err;
}

/// Clears the terminal line; the next sink writes the text.
class RoomMaker : public spdlog::sinks::base_sink<spdlog::details::null_mutex> {
 public:
  explicit RoomMaker(std::function<void()> make_room) : make_room_(std::move(make_room)) {}

 protected:
  void sink_it_(const spdlog::details::log_msg& /*line*/) override { make_room_(); }
  void flush_() override {}

 private:
  std::function<void()> make_room_;
};

/// The true pose and the believed pose, once a second.
void log_pose(const World& world, const std::optional<GroundTruth>& truth) {
  if (!spdlog::should_log(spdlog::level::debug) || world.time - std::floor(world.time) >= world.time_step) return;
  const auto text = [](const Pose2& pose) {
    return fmt::format("({:.2f}, {:.2f}, {:.0f} deg)", pose.position.x(), pose.position.y(), to_degrees(pose.rotation));
  };
  spdlog::debug(
      "{:.1f} s: belief {} weight {:.2f} reflected {:.2f}, truth {}; {}, {}, {}, "
      "coverage {:.2f}, distinctiveness {:.2f}, separability {:.2f}, goals {:.2f} {:.2f}",
      world.time, text(world.pose.pose), world.pose.cluster_weight, world.pose.reflected_weight,
      truth ? text(truth->pose) : "unknown", counted(world.line_points, "line point"),
      counted(world.goal_posts, "goal post"), counted(world.confidence.visible_tiles, "tile"),
      world.confidence.coverage, world.confidence.distinctiveness, world.confidence.separability,
      world.confidence.goal_opponent, world.confidence.goal_own);
}

}  // namespace

Progress::Progress(std::ostream& err, std::function<bool()> is_hidden)
    : err_(err),
      terminal_(isatty(STDERR_FILENO) == 1),
      is_hidden_(std::move(is_hidden)),
      start_(std::chrono::steady_clock::now()) {}

void Progress::observe(const FrameRecord& frame, const SceneTruth& scene) {
  const double time = frame.world.time;
  if (!first_time_) first_time_ = time;  // not zero if a companion resumes a saved state
  if (time < next_ || (is_hidden_ && is_hidden_())) return;
  next_ = time + (terminal_ ? 0.5 : 10.0);
  std::string states;
  for (const MachineStatus& machine : frame.machines) {
    if (frame.name(machine.machine) == "orientation") states += "  orientation: " + frame.name(machine.state);
  }
  for (const MachineStatus& machine : scene.scenario.machines)
    states += "  " + scene.scenario.name(machine.machine) + ": " + scene.scenario.name(machine.state);
  const double passed = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
  const std::string line =
      fmt::format("{:6.1f} s  {:.1f}x real time  evidence {:+.1f} ({}){}", time, (time - *first_time_) / passed,
                  frame.world.confidence.evidence, to_string(frame.world.room_status), as_line(states));
  show_status(err_, terminal_, line);
}

void Progress::make_room() {
  if (!terminal_ || (is_hidden_ && is_hidden_())) return;
  clear_terminal_line(err_);
  next_ = 0.0;
}

void Progress::end() {
  if (terminal_) clear_terminal_line(err_);
}

RoomForLog::RoomForLog(std::function<void()> make_room) : sink_(std::make_shared<RoomMaker>(std::move(make_room))) {
  std::vector<spdlog::sink_ptr>& sinks = spdlog::default_logger()->sinks();
  sinks.insert(sinks.begin(), sink_);
}

RoomForLog::~RoomForLog() { std::erase(spdlog::default_logger()->sinks(), sink_); }

void RunLog::observe(const FrameRecord& frame, const SceneTruth& scene) {
  for (const std::vector<ReloadRecord>* const reloads : {&frame.reloads, &scene.scenario.reloads})
    for (const ReloadRecord& reload : *reloads) ++(reload.accepted ? accepted_ : rejected_);
  set_log_time(frame.world.time);
  for (const LogLine& line : log_lines(frame, scene))
    spdlog::log(level_of(line.level), "{}{}{}{}", line.source, line.state.empty() ? "" : " (" + line.state + ")",
                line.source.empty() ? "" : ": ", line.text);
  log_pose(frame.world, scene.truth);
}

}  // namespace reorient
