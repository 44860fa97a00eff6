// SPDX-License-Identifier: MIT
#include "program/run/console/operator_commands.h"

#include <stdexcept>
#include <string>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/parameter.h"
#include "geometry/settable_pose.h"

namespace reorient {
namespace {

/// The number in a word. Throws std::runtime_error with one line.
double number_of(const char* name, const std::string& word, double least, double most, const char* unit) {
  const ParameterDeclaration wanted{name, ParameterKind::real, 0.0, least, most, unit, "", {}};
  return std::get<double>(parse_parameter(wanted, word));
}

RunControls& controls_of(RunControls* controls) {
  if (controls == nullptr) throw std::runtime_error("expected a run, found a replay");
  return *controls;
}

/// Requests the action, and answers with the time of the first frame that shows it.
Reply act(RunControls* controls, std::string_view name, const OperatorRequestValues& values) {
  const OperatorRequest request = operator_request(name, values);
  return [controls, text = request.text(), number = controls_of(controls).request(request, kOperatorName)](
             const FrameRecord& frame, const SceneTruth&) -> std::optional<std::string> {
    if (!controls->is_carried_out(number)) return std::nullopt;
    return fmt::format("  {} at {:.2f} s\n", text, frame.world.time);
  };
}

OperatorRequestValues pose_values(const Words& words) {
  constexpr double kMostDegrees = 36000.0;
  OperatorRequestValues values;
  values.x = number_of("X", words[0], -kFarthestPose, kFarthestPose, "m");
  values.y = number_of("Y", words[1], -kFarthestPose, kFarthestPose, "m");
  values.degrees = number_of("DEGREES", words[2], -kMostDegrees, kMostDegrees, "degrees");
  return values;
}

OperatorRequestValues penalty_values(const Words& words) {
  const std::string word = words.empty() ? "on" : words[0];
  if (word != "on" && word != "off") throw std::runtime_error("penalize: expected on or off, found '" + word + "'");
  OperatorRequestValues values;
  values.penalized = word == "on";
  return values;
}

OperatorRequestValues light_values(const Words& words) {
  OperatorRequestValues values;
  values.stops = number_of("STOPS", words[0], -kMostStops, kMostStops, "stops");
  return values;
}

std::string speed_text(const RunPace& pace) { return fmt::format("  {} times real time\n", to_text(pace.speed())); }

/// Answers after the last of the frames.
Reply take_frames(RunControls& controls, const Words& words) {
  const ParameterDeclaration wanted{"N", ParameterKind::integer, 1, 1.0, RunPace::kMostFrames, "frames", "", {}};
  controls.take_frames(words.empty() ? 1 : std::get<int>(parse_parameter(wanted, words[0])));
  return [&controls](const FrameRecord& frame, const SceneTruth&) -> std::optional<std::string> {
    const RunPace& pace = controls.pace();
    if (pace.is_paused() && pace.permits_frame()) return std::nullopt;
    return fmt::format("  {} at {:.2f} s\n", pace.is_paused() ? "paused" : "continued", frame.world.time);
  };
}

}  // namespace

bool is_paused(const RunControls* controls) { return controls != nullptr && controls->pace().is_paused(); }

std::vector<Command> operator_commands(RunControls* controls) {
  const auto action = [controls](std::string_view name, OperatorRequestValues (*values)(const Words&)) {
    return [controls, name, values](const Words& words, FrameInputs&) {
      return act(controls, name, values != nullptr ? values(words) : OperatorRequestValues());
    };
  };
  return {
      {"pick_up", "", "lift the robot", action("pick_up", nullptr)},
      {"put_down", "X Y DEGREES", "place the robot (m, m, degrees), as in: put_down -3 1.5 90",
       action("put_down", pose_values)},
      {"mirror", "", "carry the robot to the mirrored pose of its true pose", action("mirror", nullptr)},
      {"push_over", "", "make the robot fall", action("push_over", nullptr)},
      {"penalize", "[on|off]", "penalize the robot, or end the penalty", action("penalize", penalty_values),
       [](const Words& before) {
         return before.empty() ? Words{"on", "off"} : Words();
       }},
      {"change_light", "", "change the light as set by the parameters light", action("change_light", nullptr)},
      {"set_exposure_compensation", "STOPS", "change the hall's light, in powers of two",
       action("set_exposure_compensation", light_values)},
      {"set_initial_pose", "X Y DEGREES", "set the initial pose (m, m, degrees), with every robot",
       action("set_initial_pose", pose_values)},
      {"pause", "", "pause the run; the prompt continues",
       [controls](const Words&, FrameInputs&) {
         controls_of(controls).change_pace("pause").pause();
         return [](const FrameRecord& frame, const SceneTruth&) {
           return fmt::format("  paused at {:.2f} s\n", frame.world.time);
         };
       }},
      {"resume", "", "continue a paused run",
       [controls](const Words&, FrameInputs&) {
         controls_of(controls).change_pace("resume").resume();
         return at_once(speed_text(controls->pace()));
       }},
      {"frame", "[N]", "run this many frames of a paused run; alone: one",
       [controls](const Words& words, FrameInputs&) { return take_frames(controls_of(controls), words); }},
      {"speed", "FACTOR", "set the speed of the run, 0.05 to 20; 1 is real time",
       [controls](const Words& words, FrameInputs&) {
         controls_of(controls).set_speed(
             number_of("FACTOR", words[0], RunPace::kSlowest, RunPace::kFastest, "times real time"));
         return at_once(speed_text(controls->pace()));
       }},
  };
}

}  // namespace reorient
