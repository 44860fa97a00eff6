// SPDX-License-Identifier: MIT
#include "program/run/report.h"

#include <algorithm>
#include <cmath>
#include <ostream>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "geometry/angle.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

nlohmann::json to_json(const Pose2& pose) {
  return {{"x", pose.position.x()}, {"y", pose.position.y()}, {"rotation", pose.rotation}};
}

nlohmann::json to_json(const TimeQuantiles& times) {
  constexpr double kMilliseconds = 1e3;
  return {{"median", kMilliseconds * times.median},
          {"percentile_99", kMilliseconds * times.percentile_99},
          {"longest", kMilliseconds * times.longest}};
}

/// Makes all texts valid UTF-8, because scripts may print any bytes and files may have any name.
void make_utf8(nlohmann::json& json) {
  if (json.is_structured()) {
    for (nlohmann::json& each : json) make_utf8(each);
  } else if (json.is_string()) {
    json = as_utf8(json.get_ref<const std::string&>());
  }
}

template <typename Value>
nlohmann::json or_null(const std::optional<Value>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

/// The periods of wrong belief. Empty if the belief was never wrong.
std::string wrong_belief_in_words(const RunSummary& summary) {
  if (!summary.belief_wrong_at) return {};
  const std::string last = summary.corrected_after ? fmt::format("{:.1f} s, corrected after {:.1f} s",
                                                                 *summary.belief_wrong_at, *summary.corrected_after)
                                                   : fmt::format("{:.1f} s, not corrected", *summary.belief_wrong_at);
  if (summary.wrong_periods < 2) return "belief wrong at " + last;
  return fmt::format("belief wrong {} times, at most for {:.1f} s; last at {}", summary.wrong_periods,
                     summary.longest_wrong, last);
}

/// The error of the camera's angles straight ahead. Empty if it is small or uncertain.
std::string bias_in_words(const CameraBias& bias) {
  constexpr double kLeastReported = from_degrees(0.5), kSure = 3.0;  // multiple of the deviation
  const auto [roll, pitch] = bias_ahead(bias);
  if (std::max(std::abs(pitch), std::abs(roll)) < std::max(kLeastReported, kSure * bias.deviation)) return {};
  return fmt::format("the camera looks {:.1f} degrees {} than is measured and is rolled by {:.1f} degrees (to {:.1f})",
                     to_degrees(std::abs(pitch)), pitch > 0.0 ? "lower" : "higher", to_degrees(roll),
                     to_degrees(bias.deviation));
}

}  // namespace

void print_summary(const RunSummary& summary, const RunCircumstances& circumstances, std::ostream& out) {
  const char* const judgement = circumstances.is_ended_by_user ? "not judged"
                                : !summary.succeeded           ? "wrong"
                                : summary.error                ? "right"
                                                               : "not judged";
  out << fmt::format("\n{}: {}\n", judgement, as_line(summary.verdict));
  if (const std::string periods = wrong_belief_in_words(summary); !periods.empty()) out << "  " << periods << '\n';
  if (summary.error) {
    out << fmt::format("  belief {} at the end: off by {:.2f} m, {:.1f} degrees\n",
                       summary.correct ? "correct" : "wrong", summary.error->position,
                       to_degrees(summary.error->rotation));
  }
  if (const std::string bias = bias_in_words(summary.camera_bias); !bias.empty()) out << "  " << bias << '\n';
  for (const StoppedScript& script : summary.stopped) {
    out << fmt::format("  {} was stopped: {}, the last: {}\n", as_line(script.script), counted(script.errors, "error"),
                       as_line(script.last));
  }
  out << fmt::format("  {}, {}, {}\n", counted(summary.flips, "flip"), counted(summary.purges, "purge"),
                     counted(summary.resets, "reset"));
  out << fmt::format("  {:.1f} s in {}, {:.0f} frames per second ({:.1f} times real time)\n", summary.seconds,
                     counted(summary.frames, "frame"), static_cast<double>(summary.frames) / circumstances.wall_seconds,
                     summary.seconds / circumstances.wall_seconds);
  out << "digest: " << circumstances.digest << '\n';
}

void write_summary(const RunSummary& summary, const CommandHistory& commands, const RunCircumstances& circumstances,
                   const std::filesystem::path& file) {
  nlohmann::json json{
      {"scenario", circumstances.scenario},
      {"room", circumstances.room},
      {"seed", circumstances.seed},
      {"room_awareness", circumstances.room_awareness},
      {"scripts", circumstances.scripts.string()},
      {"assets", circumstances.assets.string()},
      {"correct", summary.error ? nlohmann::json(summary.correct) : nlohmann::json()},
      {"succeeded", circumstances.is_ended_by_user ? nlohmann::json() : nlohmann::json(summary.succeeded)},
      {"verdict", summary.verdict},
      {"belief_wrong_at_seconds", or_null(summary.belief_wrong_at)},
      {"corrected_after_seconds", or_null(summary.corrected_after)},
      {"wrong_periods", summary.wrong_periods},
      {"longest_wrong_seconds", summary.longest_wrong},
      {"position_error_meters", nullptr},
      {"rotation_error_degrees", nullptr},
      {"mean_position_error_meters", nullptr},
      {"mean_rotation_error_degrees", nullptr},
      {"flips", summary.flips},
      {"purges", summary.purges},
      {"resets", summary.resets},
      {"wrong_seconds", summary.wrong_seconds},
      {"seconds", summary.seconds},
      {"frames", summary.frames},
      {"frames_per_second", static_cast<double>(summary.frames) / circumstances.wall_seconds},
      {"digest", circumstances.digest},
      {"frame_time_milliseconds", to_json(circumstances.frame_time)},
      {"frame_time_without_rendering_milliseconds", to_json(circumstances.frame_time_without_rendering)},
      {"reloads_accepted", circumstances.reloads_accepted},
      {"reloads_rejected", circumstances.reloads_rejected},
  };
  if (summary.error) {
    json["position_error_meters"] = summary.error->position;
    json["rotation_error_degrees"] = to_degrees(summary.error->rotation);
  }
  if (summary.mean_error) {
    json["mean_position_error_meters"] = summary.mean_error->position;
    json["mean_rotation_error_degrees"] = to_degrees(summary.mean_error->rotation);
  }
  if (summary.frames > 0) {
    json["belief"] = to_json(summary.belief.pose);
    const CameraBias& bias = summary.camera_bias;
    json["camera_bias_degrees"] = {
        {"torso_roll", to_degrees(bias.torso.roll)},     {"torso_pitch", to_degrees(bias.torso.pitch)},
        {"upper_roll", to_degrees(bias.mounts[0].roll)}, {"upper_pitch", to_degrees(bias.mounts[0].pitch)},
        {"lower_roll", to_degrees(bias.mounts[1].roll)}, {"lower_pitch", to_degrees(bias.mounts[1].pitch)},
        {"deviation", to_degrees(bias.deviation)}};
  }
  if (summary.truth) json["truth"] = to_json(summary.truth->pose);
  json["commands"] = nlohmann::json::array();
  for (const TimelineEvent& event : commands.commands()) {
    json["commands"].push_back({{"time", event.time},
                                {"issuer", event.machine},
                                {"state", event.state},
                                {"command", event.command},
                                {"reason", event.reason},
                                {"verdict", event.verdict}});
  }
  json["commands_dropped"] = commands.dropped();
  json["stopped"] = nlohmann::json::array();
  for (const StoppedScript& script : summary.stopped)
    json["stopped"].push_back({{"script", script.script}, {"errors", script.errors}, {"last", script.last}});
  json["reorientations"] = nlohmann::json::array();
  for (const JudgedReorientation& judged : summary.reorientations) {
    json["reorientations"].push_back({{"time", judged.time},
                                      {"command", to_string(judged.reorientation)},
                                      {"correct_before", or_null(judged.correct_before)},
                                      {"correct_after", or_null(judged.correct_after)}});
  }
  make_utf8(json);
  write_whole_file(file, json.dump(2) + '\n');
}

}  // namespace reorient
