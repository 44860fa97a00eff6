#include "program/run/report.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <ostream>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

constexpr int kBusy = 20;  // transitions in a run beyond which a behaviour's are left out of the timeline

struct TimelineRow {
  double time;
  std::string behavior;
  std::string state;
  std::string command;
  std::string reason;
  std::string verdict;
};

std::map<std::string, int> count_transitions(const RunHistory& history) {
  std::map<std::string, int> counts;
  for (const TransitionRecord& transition : history.transitions()) ++counts[transition.machine];
  return counts;
}

std::vector<TimelineRow> collect_rows(const RunHistory& history, const std::map<std::string, int>& counts,
                                      bool every_transition) {
  std::vector<TimelineRow> rows;
  for (const TransitionRecord& transition : history.transitions()) {
    if (!every_transition && counts.at(transition.machine) > kBusy) continue;
    rows.push_back(
        {transition.time, transition.machine, transition.from + " > " + transition.to, "", transition.reason, ""});
  }
  for (const CommandRecord& record : history.commands()) {
    const CommandRequest& request = record.request;
    rows.push_back({record.time, request.issuer, request.state, std::string(to_string(request.command)), request.reason,
                    std::string(to_string(record.verdict))});
  }
  std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.time < b.time; });
  return rows;
}

nlohmann::json to_json(const Pose2& pose) {
  return {{"x", pose.position.x()}, {"y", pose.position.y()}, {"rotation", pose.rotation}};
}

nlohmann::json to_json(const TimeQuantiles& times) {
  constexpr double kMilliseconds = 1e3;
  return {{"median", kMilliseconds * times.median},
          {"percentile_99", kMilliseconds * times.percentile_99},
          {"longest", kMilliseconds * times.longest}};
}

template <typename Value>
nlohmann::json or_null(const std::optional<Value>& value) {
  return value ? nlohmann::json(*value) : nlohmann::json();
}

}  // namespace

void print_timeline(const RunHistory& history, bool every_transition, std::ostream& out) {
  const std::map<std::string, int> counts = count_transitions(history);
  const std::vector<TimelineRow> rows = collect_rows(history, counts, every_transition);
  std::size_t behavior = 9, state = 5, command = 7, reason = 6;
  for (const TimelineRow& row : rows) {
    behavior = std::max(behavior, row.behavior.size());
    state = std::max(state, row.state.size());
    command = std::max(command, row.command.size());
    reason = std::max(reason, row.reason.size());
  }
  out << fmt::format("{:>8}  {:<{}}  {:<{}}  {:<{}}  {:<{}}  {}\n", "time", "behaviour", behavior, "state", state,
                     "command", command, "reason", reason, "verdict");
  for (const TimelineRow& row : rows) {
    std::string line = fmt::format("{:>6.2f} s  {:<{}}  {:<{}}  {:<{}}  {:<{}}  {}", row.time, row.behavior, behavior,
                                   row.state, state, row.command, command, row.reason, reason, row.verdict);
    line.erase(line.find_last_not_of(' ') + 1);
    out << line << '\n';
  }
  for (const auto& [machine, count] : counts) {
    if (!every_transition && count > kBusy) {
      out << fmt::format("          {}: {} changes of state, shown with --every-transition\n", machine, count);
    }
  }
}

void print_summary(const RunSummary& summary, const RunCircumstances& circumstances, std::ostream& out) {
  out << fmt::format("\n{}{}\n", summary.correct && summary.succeeded ? "right: " : "wrong: ", summary.verdict);
  if (summary.corrected_after) {
    out << fmt::format("  turned round at {:.1f} s, corrected after {:.1f} s\n", *summary.belief_wrong_at,
                       *summary.corrected_after);
  } else if (summary.belief_wrong_at) {
    out << fmt::format("  turned round at {:.1f} s, not corrected\n", *summary.belief_wrong_at);
  }
  if (summary.error) {
    out << fmt::format("  pose error {:.2f} m, {:.1f} degrees\n", summary.error->position,
                       to_degrees(summary.error->rotation));
  }
  out << fmt::format("  {} flips, {} purges, {} resets\n", summary.flips, summary.purges, summary.resets);
  out << fmt::format("  {:.1f} s in {} frames, {:.0f} frames per second ({:.1f} times real time)\n", summary.seconds,
                     summary.frames, summary.frames / circumstances.wall_seconds,
                     summary.seconds / circumstances.wall_seconds);
  out << "digest: " << circumstances.digest << '\n';
}

void write_summary(const RunSummary& summary, const RunHistory& history, const RunCircumstances& circumstances,
                   const std::filesystem::path& file) {
  nlohmann::json json{
      {"scenario", circumstances.scenario},
      {"room", circumstances.room},
      {"seed", circumstances.seed},
      {"room_awareness", circumstances.room_awareness},
      {"correct", summary.correct},
      {"succeeded", summary.succeeded},
      {"verdict", summary.verdict},
      {"belief_wrong_at_seconds", or_null(summary.belief_wrong_at)},
      {"corrected_after_seconds", or_null(summary.corrected_after)},
      {"position_error_metres", nullptr},
      {"rotation_error_degrees", nullptr},
      {"flips", summary.flips},
      {"purges", summary.purges},
      {"resets", summary.resets},
      {"seconds", summary.seconds},
      {"frames", summary.frames},
      {"frames_per_second", summary.frames / circumstances.wall_seconds},
      {"digest", circumstances.digest},
      {"frame_time_milliseconds", to_json(circumstances.frame_time)},
      {"frame_time_without_rendering_milliseconds", to_json(circumstances.frame_time_without_rendering)},
      {"reloads_accepted", circumstances.reloads_accepted},
      {"reloads_refused", circumstances.reloads_refused},
  };
  if (summary.error) {
    json["position_error_metres"] = summary.error->position;
    json["rotation_error_degrees"] = to_degrees(summary.error->rotation);
  }
  if (!history.samples().empty()) {
    json["belief"] = to_json(history.samples().back().belief.pose);
    if (const auto& truth = history.samples().back().truth) json["truth"] = to_json(truth->pose);
  }
  json["commands"] = nlohmann::json::array();
  for (const CommandRecord& record : history.commands()) {
    json["commands"].push_back({{"time", record.time},
                                {"issuer", record.request.issuer},
                                {"state", record.request.state},
                                {"command", to_string(record.request.command)},
                                {"reason", record.request.reason},
                                {"verdict", to_string(record.verdict)}});
  }
  write_whole_file(file, json.dump(2) + '\n');
}

}  // namespace reorient
