// SPDX-License-Identifier: MIT
#include "program/run/run_scenario.h"

#include <chrono>
#include <memory>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <unistd.h>

#include "engine/parameters/utf8.h"
#include "program/interruption.h"
#include "program/output_mailbox.h"
#include "program/run/console/history_file.h"
#include "program/run/live/run_live_view.h"
#include "program/run/report.h"
#include "program/run/simulation.h"
#include "program/safe_output.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/home.h"
#include "workbench/files/parameter_file.h"
#include "workbench/run/digest_observer.h"
#include "workbench/run/frame_times.h"
#include "workbench/run/run_controls.h"
#include "workbench/run/run_summary.h"
#include "workbench/views/pictures/run_pictures.h"

namespace reorient {
namespace {

void require_writable_outputs(const RunOptions& options) {
  if (!options.json.empty()) require_writable_file(options.json, "--json");
  if (!options.save_parameters.empty()) require_writable_file(options.save_parameters, "--save-params");
  if (!options.model.empty()) require_writable_file(options.model, "--model");
  if (options.pictures) require_writable_folder(options.out, "--out");
}

}  // namespace

int run_prepared(const RunOptions& options, PreparedRun run, const RunGuests& guests, std::ostream& out,
                 std::ostream& err) {
  run.live.recording = recorder_options(options, run.venue);
  // Last, so that a mistake in anything else leaves no empty folder behind.
  require_writable_outputs(options);

  SummaryObserver summary;
  CommandHistory commands;
  FrameTimes frame_times;
  DigestObserver digest;
  RunPictures pictures;
  std::optional<OutputMailbox> mailbox;
  if (options.realtime) mailbox.emplace(out, err);
  const RobotInstance& robot = run.live.parts.robot;
  RunControls controls(robot.the_operator != nullptr && robot.truth != nullptr,
                       options.realtime && robot.clock == RobotInstance::Clock::simulated);
  controls.set_field(run.field);
  run.subject.controls = &controls;
  LiveConsole console(STDIN_FILENO, out, run.subject, history_path());
  const LiveViewPointer view =
      start_live_view(options.live, LiveLoad::usual, run.subject, options.scripts, console, err);
  LiveRun live(options, console, out, err);

  run.live.live = view.get();
  RunParts& parts = run.live.parts;
  parts.observers = {&summary, &commands, &frame_times, &digest};
  if (options.pictures) parts.observers.push_back(&pictures);
  parts.observers.insert(parts.observers.end(), guests.observers.begin(), guests.observers.end());
  parts.in_real_time = options.realtime;
  parts.controls = &controls;
  parts.stop = guests.stop;
  if (options.realtime && isatty(STDIN_FILENO) == 1)
    err << "saved scripts are reloaded at once; Enter opens a prompt (help lists its commands)\n";
  const auto start = std::chrono::steady_clock::now();
  const RunEnd end = live.run(std::move(run.live));
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const std::string user = user_who_ended_run(console.wants_to_quit());
  const bool is_ended_by_user = end == RunEnd::stopped && !summary.has_verdict() && !user.empty();
  const RunCircumstances circumstances{.scenario = options.scenario,
                                       .room = run.venue,
                                       .seed = options.seed,
                                       .room_awareness = options.room_awareness,
                                       .scripts = std::filesystem::absolute(options.scripts),
                                       .assets = std::filesystem::absolute(find_home() / "assets"),
                                       .wall_seconds = took.count(),
                                       .digest = digest.hex(),
                                       .frame_time = frame_times.whole(),
                                       .frame_time_without_rendering = frame_times.without_observing(),
                                       .reloads_accepted = live.log().reloads_accepted(),
                                       .reloads_rejected = live.log().reloads_rejected(),
                                       .is_ended_by_user = is_ended_by_user};
  RunSummary result = summary.summary(end);
  if (is_ended_by_user) result.verdict = "ended by " + user;
  if (guests.verdict && !is_ended_by_user) guests.verdict(result);
  std::vector<std::string> failures;
  if (const std::string failure = run.failure ? run.failure() : ""; !failure.empty()) failures.push_back(failure);
  if (!options.json.empty())
    try_to_write(failures, [&] { write_summary(result, commands, circumstances, options.json); });
  if (!options.save_parameters.empty()) {
    try_to_write(failures, [&] {
      save_parameters(run.subject.parameters(), run.subject.kept_parameters(), options.save_parameters);
    });
  }
  live.save_model(failures);
  if (options.pictures) {
    for (std::string& failure : pictures.write(options.out)) failures.push_back(std::move(failure));
  }
  live.end_recording();
  if (options.pictures) out << "\npictures: " << as_line(options.out.string()) << "/\n";
  if (!options.save_parameters.empty()) out << "parameters: " << as_line(options.save_parameters.string()) << "\n";
  if (live.model() != nullptr)
    out << "model: " << as_line(options.model.string()) << " (" << live.model()->outcome() << ")\n";
  end_live_view(view.get(), user, out);
  print_summary(result, circumstances, out);
  for (const std::string& failure : failures) print_error(err, failure);
  return exit_code_of_runs(failures, result.succeeded || is_ended_by_user);
}

int run_scenario(const RunOptions& options, const RunGuests& guests, std::ostream& out, std::ostream& err) {
  // Before the scripts are read, so that no edit is missed.
  std::optional<ScriptEdits> edits;
  if (options.realtime) edits.emplace(options.scripts);
  Simulation simulation(options);
  // Before this point, nothing can be lost, so a signal ends the program at once, also while scripts load.
  const Interruption interruption;
  return run_prepared(options,
                      {.live = {.parts = simulation.parts(),
                                .edits = edits ? &*edits : nullptr,
                                .model = simulation.model(),
                                .recording = {}},
                       .venue = simulation.venue().name(),
                       .subject = {.scenario = &simulation.scenario(),
                                   .parameters = [&] { return simulation.parameters(); },
                                   .kept_parameters = [&] { return simulation.kept_parameters(); },
                                   .scripts = [&] { return edits->known(); },
                                   .engine = [&] { return &simulation.engine(); }},
                       .field = simulation.field()},
                      guests, out, err);
}

}  // namespace reorient
