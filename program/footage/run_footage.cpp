// SPDX-License-Identifier: MIT
#include "program/footage/run_footage.h"

#include <charconv>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/nearest_name.h"
#include "program/footage/footage_run.h"
#include "program/interruption.h"
#include "program/run/run_scenario.h"
#include "program/run/simulation.h"
#include "program/safe_output.h"
#include "workbench/files/calibration_file.h"

namespace reorient {
namespace {

/// The value of --belief: right, mirrored, error in degrees to the left, or both, as in mirrored:10.
std::optional<BeliefChange> belief_change_of(const RunOptions& options) {
  if (options.belief.empty()) {
    if (options.lifted) throw std::runtime_error("--lifted: expected --belief with the pose after lifting, found none");
    return std::nullopt;
  }
  BeliefChange change;
  change.at = options.belief_at;
  change.kind = options.lifted ? BeliefChange::Kind::lifted : BeliefChange::Kind::told;
  constexpr std::string_view kMirrored = "mirrored";
  std::string_view rest = options.belief;
  change.mirrored = rest.starts_with(kMirrored);
  if (change.mirrored) rest.remove_prefix(kMirrored.size());
  if (change.mirrored && rest.starts_with(':')) rest.remove_prefix(1);
  if ((change.mirrored && rest.empty()) || rest == "right") return change;
  double degrees = 0.0;
  const auto [stop, error] = std::from_chars(rest.data(), rest.data() + rest.size(), degrees);
  if (error != std::errc() || stop != rest.data() + rest.size() || !(std::abs(degrees) <= 180.0))
    throw std::runtime_error(
        "--belief: expected right, mirrored, degrees from -180 to 180, or mirrored:DEGREES, found '" + options.belief +
        "'");
  change.turned_by = from_degrees(degrees);
  return change;
}

/// The source of the robot's pose, according to the first image.
std::string pose_line(const FootageSetup& setup, const RobotBody& body, const FootageFrame& first) {
  const std::string at = setup.at.empty() ? "an unknown position" : setup.at;
  if (first.heading) return "pose: the recorded rotation, at " + at;
  if (first.pose) return "pose: as recorded";
  std::string line = std::string("pose: by field lines") + (first.odometry ? " and the recorded odometry" : "") +
                     ", beginning at " + at;
  const std::vector<std::string> unused = unused_columns(setup.source, setup.footage, body);
  if (!unused.empty()) line += "; columns that are not used: " + list_of(unused);
  return line;
}

}  // namespace

int run_footage(const RunOptions& options, std::ostream& out, std::ostream& err) {
  ScriptEdits edits(options.scripts);
  const std::filesystem::path& offset = options.footage.camera_offset;
  const std::uint64_t mounting = offset.empty() ? 0 : mounting_of(load_calibration(offset));
  const FootageSetup setup{
      {options}, options.scenario, options.footage, as_mounted(model_to_begin_with(options), mounting), options.at};
  FootageOptions robot_options = robot_options_of(setup);
  robot_options.change = belief_change_of(options);
  PreparedFootage prepared = prepare_footage(setup, edits.texts());
  const RobotBody body = prepared.frame.body;
  const FieldDimensions field = prepared.frame.field;
  auto robot = std::make_unique<FootageRobot>(open_footage(setup.source, setup.footage, body), robot_options);
  FootageRobot& itself = *robot;
  RobotInstance instance{std::move(robot), body, RobotInstance::Clock::simulated, nullptr, &itself};
  FrameLoop engine(std::move(prepared.frame));
  // Before this point, nothing can be lost, so a signal ends the program at once, also while scripts load.
  const Interruption interruption;
  print_error(err, prepared.wall);
  print_error(err, pose_line(setup, body, itself.frame()));
  const auto failure = [&] {
    if (!itself.missed_change()) return itself.failure();
    return fmt::format("--belief-at {}: expected a moment of the footage, which lasts {:.1f} s",
                       robot_options.change->at, itself.seconds());
  };
  const auto verdict = [&](RunSummary& summary) {
    if (!itself.failure().empty()) {
      summary.verdict = "the footage could not be read to its end";
      return;
    }
    summary.verdict = itself.is_over()
                          ? fmt::format("the footage is over after {}", counted(itself.frames(), "image"))
                          : fmt::format("ended after {}, as set by --seconds", counted(summary.frames, "image"));
    summary.succeeded = !summary.error || summary.correct;
    if (!summary.error) summary.verdict += "; the footage has no true pose";
  };
  RunParts parts{instance, engine, nullptr, nullptr, {}, {}, {}, options.seconds.value_or(0.0), false};
  return run_prepared(options,
                      {.live = {.parts = std::move(parts),
                                .edits = options.realtime ? &edits : nullptr,
                                .model = setup.model,
                                .recording = {}},
                       .venue = setup.source.string(),
                       .subject = {.parameters = [&] { return engine.parameters(); },
                                   .kept_parameters = [&] { return prepared.kept; },
                                   .scripts = [&] { return edits.known(); },
                                   .engine = [&] { return &engine; }},
                       .field = field,
                       .failure = failure},
                      {{}, {}, verdict}, out, err);
}

}  // namespace reorient
