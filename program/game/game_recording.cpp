// SPDX-License-Identifier: MIT
#include "program/game/game_recording.h"

#include <algorithm>
#include <filesystem>
#include <ostream>
#include <set>
#include <stdexcept>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "program/robots.h"
#include "program/run/venue.h"
#include "program/safe_output.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

constexpr const char* kRecordingExtension = ".mcap";

/// "red_5" for red_5.mcap and red_5.2.mcap, which may be of another game.
std::string robot_of(const std::filesystem::path& file) {
  if (file.extension() != kRecordingExtension) return "";
  const std::string name = file.filename().string();
  return name.substr(0, name.find('.'));
}

/// The recording of a robot that does not play would seem to belong to this game.
void require_no_other_robot(const std::filesystem::path& folder, const std::set<std::string>& robots) {
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(folder, error)) {
    const std::string robot = robot_of(entry.path());
    const bool is_of_a_robot = robot.starts_with("blue_") || robot.starts_with("red_");
    if (!is_of_a_robot || robots.contains(robot)) continue;
    throw std::runtime_error("--record " + folder.string() +
                             ": expected no recording of a robot that does not play, found " +
                             entry.path().filename().string() + "; move it away, or name another folder");
  }
}

RecorderOptions recorder_options_of(const GameRobot& robot, const GameOptions& options) {
  const std::filesystem::path file = options.recording.record / (file_stem_of(robot) + kRecordingExtension);
  RecorderOptions recorder = recorder_options(options.recording, file, true);
  recorder.about = {{"version", REORIENT_VERSION},
                    {"robot", kSimulator},
                    {"scenario", "game"},
                    {"player", fmt::format("{} {}", team_name(robot.team()), robot.number())},
                    {"venue", Venue{options.room, options.hall_seed, options.field}.name()},
                    {"seed", std::to_string(options.seed)},
                    {"images", options.recording.record_images}};
  recorder.application = robot.application();
  recorder.most_waiting = std::size_t{32} << 20;  // there are up to ten queues
  return recorder;
}

}  // namespace

std::string file_stem_of(const GameRobot& robot) {
  return fmt::format("{}_{}", team_name(robot.team()), robot.number());
}

GameRecording::GameRecording(const GameOptions& options, SoccerGame& game) : game_(game) {
  const std::filesystem::path& folder = options.recording.record;
  recorder_options(options.recording, {}, true);  // throws
  if (folder.empty()) return;
  require_writable_folder(folder, "--record");
  std::set<std::string> stems;
  for (std::size_t i = 0; i < game.robots(); ++i) stems.insert(file_stem_of(game.robot(i)));
  require_no_other_robot(folder, stems);
  std::vector<RecorderOptions> all;  // first, so that a mistake in any file begins no recording
  for (std::size_t i = 0; i < game.robots(); ++i) all.push_back(recorder_options_of(game.robot(i), options));
  for (RecorderOptions& one : all) {
    OfRobot& robot = *robots_.emplace_back(std::make_unique<OfRobot>());
    robot.recording = std::make_unique<RunRecording>(
        std::move(one), [&robot](const std::string& line) { robot.reports.push_back(line); },
        EarlierRecording::is_replaced);
    game.show_to(*robot.recording->observer(), robots_.size() - 1);
  }
}

void GameRecording::keep_up(std::ostream& err) {
  constexpr double kPatience = 5.0;  // s
  for (const auto& robot : robots_) {
    if (robot->is_waited_for) robot->is_waited_for = robot->recording->wait_for_thread(kPatience);
    print_reports(*robot, err);
  }
}

void GameRecording::end(std::ostream& out, std::ostream& err) {
  for (std::size_t i = 0; i < robots_.size(); ++i) {
    robots_[i]->recording->end(out, game_.robot(i).digest());
    print_reports(*robots_[i], err);
  }
}

void GameRecording::print_reports(OfRobot& robot, std::ostream& err) {
  for (const std::string& line : std::exchange(robot.reports, {})) print_error(err, line);
}

}  // namespace reorient
