// SPDX-License-Identifier: MIT
// `reorient replay`: runs the frames of a recording again and compares them.
#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/frame.h"
#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/options.h"
#include "program/program.h"
#include "program/recording/damages.h"
#include "program/recording/recorded_times.h"
#include "program/run/live/live_options.h"
#include "program/run/live/live_replay.h"
#include "program/safe_output.h"
#include "program/script_names.h"
#include "program/subcommand.h"
#include "workbench/files/script_files.h"
#include "workbench/recording/comparison.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/replay.h"
#include "workbench/recording/what_if.h"
#include "workbench/run/digest_observer.h"

namespace reorient {
namespace {

struct ReplayOptions {
  std::filesystem::path file, scripts;
  ParameterOptions parameters;
  RecordedTimes times;
  bool events = false;
  LiveOptions live;

  bool asks_what_if() const { return !scripts.empty() || !overrides_of(parameters).empty(); }
};

/// The changes of scripts and parameters against the recording.
WhatIfChanges other_than_recorded(const FrameLoop& engine, const ReplayOptions& options) {
  WhatIfChanges changes;
  if (!options.scripts.empty())
    changes.scripts = edits_between(engine.scripts(), read_scripts(scripts_root(options.scripts)));
  changes.parameters = overrides_of(options.parameters);
  // They override every recorded value, whatever its origin.
  for (ParameterChange& change : changes.parameters) change.origin = ParameterOrigin::live;
  return changes;
}

void print_difference(const char* what, const Difference& difference, std::ostream& out) {
  out << fmt::format("{} frame {} at {:.2f} s: {}\n  recorded: {}\n  replayed: {}\n", what, difference.frame,
                     difference.time, as_line(difference.what), as_line(difference.recorded),
                     as_line(difference.replayed));
}

/// The first decision in which the runs differ.
void print_first_decision(const ReplayComparison& comparison, std::ostream& out) {
  const std::optional<ReplayComparison::Event> first = comparison.first_decision();
  if (!first) {
    out << "no decision of a behavior differs\n";
  } else {
    out << fmt::format("the first decision that differs is at {:.2f} s, {}:\n  {}\n", first->time,
                       first->recorded ? "recorded, but not replayed" : "replayed, but not recorded",
                       as_line(first->text));
  }
}

void print_events(const ReplayComparison& comparison, bool all, std::ostream& out) {
  for (const ReplayComparison::Event& event : comparison.events()) {
    const bool is_both = event.recorded && event.replayed;
    if (is_both && !all) continue;
    out << fmt::format("{:9.2f} s  {}  {}\n", event.time,
                       is_both          ? "both     "
                       : event.recorded ? "recorded "
                                        : "replayed ",
                       as_line(event.text));
  }
}

int show_replay(const ReplayOptions& options, std::ostream& out, std::ostream& err) {
  LiveReplayOptions live{options.file, scripts_root(options.scripts), options.times, options.live, {}};
  if (options.asks_what_if())
    live.changes = [&options](const FrameLoop& engine) { return other_than_recorded(engine, options); };
  return replay_live(live, out, err);
}

int replay(const ReplayOptions& options, std::ostream& out, std::ostream& err) {
  const Interruption interruption;
  if (options.live.is_on) return show_replay(options, out, err);
  const auto stop = [] { return Interruption::signal() != 0; };
  Recording recording(options.file, stop);
  require_recorded(recording, options.times, err);
  Replay again(recording, options.times.from, options.times.to);
  ReplayComparison comparison(again.playback());
  DigestObserver digest;
  double last_time = 0.0;
  const auto begin = std::chrono::steady_clock::now();
  while (const FrameLoop* const engine = again.next_stretch()) {
    WhatIfSource changed(options.asks_what_if() ? other_than_recorded(*engine, options) : WhatIfChanges());
    RequireTaken taken(changed);
    again.run({&changed}, {&digest, &comparison, &taken}, stop);
    last_time = engine->record().world.time;
    if (options.asks_what_if()) break;  // another stretch would begin with the recorded state, without the changes
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  tell_damages(recording, err);
  if (stop()) return exit_code_of(Interruption::signal());
  if (comparison.frames() == 0)
    throw std::runtime_error(
        options.file.string() +
        ": expected frames that can be replayed from there, found none; see 'reorient recording info'");

  const std::uint64_t skipped = again.playback().skipped() + recording.losses().frames;
  // Damage after the requested part does not matter.
  const bool is_reached = recording.damages().empty() || last_time >= options.times.to;
  const bool is_whole = is_reached && skipped == 0 && again.stretches() == 1;
  out << fmt::format("{}, up to {:.2f} s, replayed in {:.2f} s{}\n",
                     skipped == 0 ? counted(comparison.frames(), "frame")
                                  : fmt::format("{} of {} frames", comparison.frames(), comparison.frames() + skipped),
                     last_time, took.count(), is_whole ? "" : "; the rest cannot be replayed");
  if (again.stretches() > 1) out << fmt::format("in {}\n", counted(again.stretches(), "part"));
  out << "digest: " << digest.hex() << '\n';
  if (comparison.different() == 0) {
    out << (is_whole ? "all frames are the same as recorded\n" : "these frames are the same as recorded\n");
  } else {
    out << fmt::format("{} of them {} not the same as recorded\n", comparison.different(),
                       comparison.different() == 1 ? "is" : "are");
    if (comparison.first()) print_difference("the first is", *comparison.first(), out);
    print_first_decision(comparison, out);
    if (comparison.first_action()) {
      print_difference("the robot would have acted differently from", *comparison.first_action(), out);
      out << "  after this, the recorded inputs differ from what the robot would have seen\n";
    } else {
      out << "the robot would have acted the same\n";
    }
  }
  if (options.events || comparison.different() > 0) print_events(comparison, options.events, out);
  return (is_whole && comparison.different() == 0) || options.asks_what_if() ? kSuccess : kWrong;
}

}  // namespace

Subcommand add_replay(CLI::App& program) {
  const auto options = std::make_shared<ReplayOptions>();
  CLI::App* const parser = program.add_subcommand("replay", "run the frames of a recording again and compare them");
  set_examples(*parser, {{"reorient replay run.mcap", "the same frames again"},
                         {"reorient replay run.mcap --set decision.false_flips=1", "what if: another parameter"},
                         {"reorient replay run.mcap --scripts mine --events", "what if: other scripts"},
                         {"reorient replay run.mcap --live", "in real time, in a viewer with a time bar"}});
  parser->add_option("file", options->file, "recording that 'reorient run --record FILE' wrote")
      ->type_name("FILE")
      ->required();
  parser
      ->add_option("--scripts", options->scripts, "what if: root folder of the scripts (default: the recorded scripts)")
      ->type_name("FOLDER")
      ->group(kParameterGroup)
      ->check(check_not_empty);
  add_parameter_options(*parser, options->parameters);
  add_time_options(*parser, options->times);
  parser->get_option("--from")->description(
      "first time in the robot's seconds; the replay begins at the last saved state before it");
  parser->add_flag("--events", options->events, "list all commands and changes of state, also the same ones")
      ->group(kOutputGroup);
  for (const char* const name : {"--from", "--to"}) parser->get_option(name)->group("Part of the recording");
  add_live_options(*parser, options->live, "Live view");
  return {parser, [parser, options](std::ostream& out, std::ostream& err) {
            find_live(*parser, options->live);
            return replay(*options, out, err);
          }};
}

}  // namespace reorient
