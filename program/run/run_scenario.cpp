#include "program/run/run_scenario.h"

#include <chrono>
#include <optional>
#include <ostream>
#include <string>
#include <utility>
#include <vector>

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include "program/interruption.h"
#include "program/model/model_keeper.h"
#include "program/program.h"
#include "program/run/console/history_file.h"
#include "program/run/console/live_console.h"
#include "program/run/narration.h"
#include "program/run/report.h"
#include "program/run/run_observers.h"
#include "program/run/run_recording.h"
#include "program/run/script_edits.h"
#include "program/run/simulation.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/parameter_file.h"
#include "workbench/run/digest_observer.h"
#include "workbench/run/frame_times.h"
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
  std::optional<RecorderOptions> recording_options = recorder_options(options, run.venue);
  // Last, so that a mistake in anything else leaves no empty folder behind.
  require_writable_outputs(options);

  SummaryObserver summary;
  CommandHistory commands;
  FrameTimes frame_times;
  DigestObserver digest;
  RunPictures pictures;
  LiveConsole console(STDIN_FILENO, out,
                      {.scenario = run.parts.scenario,
                       .parameters = run.parameters,
                       .kept_parameters = run.kept_parameters,
                       .scripts = options.scripts},
                      history_path());
  Narration narration(console, options.every_transition, out, err);

  RunParts parts = std::move(run.parts);
  parts.observers = {&summary, &commands, &frame_times, &digest, &narration.log, &narration.timeline};
  if (options.pictures) parts.observers.push_back(&pictures);
  std::optional<ModelKeeper> model;
  if (!options.model.empty())
    parts.observers.push_back(&model.emplace(options.model, run.model, options.sides_changed));
  parts.observers.insert(parts.observers.end(), guests.observers.begin(), guests.observers.end());
  RunRecording recording(
      std::move(recording_options), [&](const std::string& line) { narration.tell(line); },
      EarlierRecording::is_replaced);
  if (Observer* const recorder = recording.observer()) parts.observers.push_back(recorder);
  parts.observers.push_back(&narration.progress);
  parts.in_real_time = options.realtime;
  parts.stop = [&] { return Interruption::signal() != 0 || console.wants_to_quit() || (guests.stop && guests.stop()); };
  if (options.realtime) {
    parts.sources = {run.edits, &console};
    parts.observers.push_back(&console);
    if (isatty(STDIN_FILENO) == 1)
      err << "saved scripts are taken over at once; Enter opens a prompt (help lists its commands)\n";
  }
  const auto start = std::chrono::steady_clock::now();
  const RunEnd end = RunLoop(std::move(parts)).run();
  narration.progress.end();

  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  const RunCircumstances circumstances{.scenario = options.scenario,
                                       .room = run.venue,
                                       .seed = options.seed,
                                       .room_awareness = options.room_awareness,
                                       .wall_seconds = took.count(),
                                       .digest = digest.hex(),
                                       .frame_time = frame_times.whole(),
                                       .frame_time_without_rendering = frame_times.without_observing(),
                                       .reloads_accepted = narration.log.reloads_accepted(),
                                       .reloads_rejected = narration.log.reloads_rejected()};
  RunSummary result = summary.summary(end);
  if (guests.verdict && Interruption::signal() == 0) guests.verdict(result);
  std::vector<std::string> failures;
  if (const std::string failure = run.failure ? run.failure() : ""; !failure.empty()) failures.push_back(failure);
  if (!options.json.empty())
    try_to_write(failures, [&] { write_summary(result, commands, circumstances, options.json); });
  if (!options.save_parameters.empty()) {
    try_to_write(failures, [&] { save_parameters(run.parameters(), run.kept_parameters(), options.save_parameters); });
  }
  if (model) try_to_write(failures, [&] { model->save(); });
  if (options.pictures) {
    for (std::string& failure : pictures.write(options.out)) failures.push_back(std::move(failure));
  }
  recording.end(out);
  if (options.pictures) out << "\npictures: " << options.out.string() << "/\n";
  if (!options.save_parameters.empty()) out << "parameters: " << options.save_parameters.string() << "\n";
  if (model) out << "model: " << options.model.string() << " (" << model->outcome() << ")\n";
  print_summary(result, circumstances, out);
  for (const std::string& failure : failures) err << "reorient: " << failure << "\n";
  if (!failures.empty()) return kBadInput;
  if (Interruption::signal() != 0) return exit_code_of(Interruption::signal());
  return result.succeeded ? kSuccess : kWrong;
}

int run_scenario(const RunOptions& options, const RunGuests& guests, std::ostream& out, std::ostream& err) {
  const Interruption interruption;
  // Before the scripts are read, so that no edit is missed.
  std::optional<ScriptEdits> edits;
  if (options.realtime) edits.emplace(options.scripts);
  Simulation simulation(options);
  return run_prepared(options,
                      {.parts = simulation.parts(),
                       .venue = simulation.venue().name(),
                       .parameters = [&] { return simulation.parameters(); },
                       .kept_parameters = [&] { return simulation.kept_parameters(); },
                       .model = simulation.model(),
                       .edits = edits ? &*edits : nullptr},
                      guests, out, err);
}

}  // namespace reorient
