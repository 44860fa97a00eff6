// SPDX-License-Identifier: MIT
// `reorient recording`: inspects, exports, draws, cuts and recovers recordings.
#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/program.h"
#include "program/recording/damages.h"
#include "program/recording/recorded_times.h"
#include "program/run/run_recording.h"
#include "program/safe_output.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/recording/csv.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/replay.h"
#include "workbench/recording/rewriting.h"
#include "workbench/views/pictures/run_pictures.h"

namespace reorient {
namespace {

constexpr int kLongestTableHead = 100;  // bytes of its first line that identify a table

struct RecordingOptions {
  std::filesystem::path file, out;
  std::string csv;
  RecordedTimes times;
  double at = 0.0;  // s of the robot
};

int info(const std::filesystem::path& file, std::ostream& out) {
  Recording recording(file);
  recording.read_views();
  const mcap::Contents& contents = recording.contents();
  out << fmt::format("{}: {:.1f} MB, written by {}\n", as_line(file.string()),
                     1e-6 * static_cast<double>(recording.source().size()), as_line(contents.library));
  for (const auto& [name, text] : recording.about()) out << fmt::format("  {}: {}\n", as_line(name), as_line(text));

  std::uint64_t frames = 0, exact = 0;
  double first = 0.0, last = 0.0;
  bool continues = false;  // without a gap since a saved state
  RecordedFrame frame;
  const bool can_be_read = recording.format() == kRecordingFormat;
  if (!can_be_read) recording.count_messages();
  while (can_be_read && recording.next(frame)) {
    if (frames++ == 0) first = frame.entry.time;
    last = frame.entry.time;
    continues = frame.entry.is_exact() && (!frame.state.empty() || (continues && frame.follows));
    exact += continues ? 1 : 0;
  }
  if (can_be_read) {
    out << fmt::format("{}, {:.2f} to {:.2f} s of the robot; {} can be replayed exactly\n", counted(frames, "frame"),
                       first, last, exact);
  } else {
    out << fmt::format(
        "its format differs from {}, the one that this program replays: it can be viewed but not replayed\n",
        kRecordingFormat);
    first = recording.begin_time();
    last = recording.end_time();
  }
  const double seconds = last - first;
  out << fmt::format("{:<24} {:>9} {:>8} {:>10}\n", "topic", "messages", "Hz", "MB");
  for (const mcap::Channel& channel : contents.channels) {
    const auto read = recording.tallies().find(channel.id);
    const Recording::Tally tally = read == recording.tallies().end() ? Recording::Tally() : read->second;
    out << fmt::format("{:<24} {:>9} {:>8.1f} {:>10.2f}\n", as_line(channel.topic), tally.messages,
                       seconds > 0.0 ? static_cast<double>(tally.messages) / seconds : 0.0,
                       1e-6 * static_cast<double>(tally.bytes));
  }
  if (!contents.is_complete) out << "its end is missing; 'reorient recording recover' repairs it\n";
  for (const std::string& damage : recording.damages()) out << "damaged " << as_line(damage) << '\n';
  const Recording::Losses losses = recording.losses();
  if (losses.any()) out << text_of(losses) << '\n';
  return recording.damages().empty() && !losses.any() ? kSuccess : kWrong;
}

/// Checks the output file of a command that makes another recording.
void require_other_file(const RecordingOptions& options) {
  NamedFiles files;
  files.reads(options.file, "the recording");
  files.writes(options.out, "--out");
  require_writable_file(options.out, "--out");
}

/// `rewrite`: writes the new file from the old one.
template <typename Rewrite>
int rewrite(const RecordingOptions& options, std::ostream& out, std::ostream& err, Rewrite rewrite) {
  require_other_file(options);
  require_new_or_recording(options.out, "--out");
  Recording recording(options.file);
  const Rewritten done = rewrite(recording);
  tell_damages(recording, err);
  out << fmt::format("{}: {}, {:.2f} to {:.2f} s", as_line(options.out.string()), counted(done.frames, "frame"),
                     done.first_time, done.last_time);
  if (done.losses.any()) out << "; " << text_of(done.losses);
  out << '\n';
  // The exit code warns a user who would delete the old recording: another reader may still recover those frames.
  return done.losses.any() ? kWrong : kSuccess;
}

/// An earlier table may be replaced, but no other file.
void require_new_or_table(const std::filesystem::path& file, const std::string& option) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error) || std::filesystem::file_size(file, error) == 0) return;
  std::string line;
  std::ifstream(file) >> std::setw(kLongestTableHead) >> line;
  if (begins_csv(line)) return;
  throw std::runtime_error(
      option + " " + file.string() +
      ": expected a new file or a table of this command, found another file, which was not changed; name another one");
}

int export_csv(const RecordingOptions& options, std::ostream& out, std::ostream& err) {
  Recording recording(options.file);
  recording.leave_out_images();
  std::uint64_t left_out = 0;
  if (options.out.empty()) {
    left_out = write_csv(recording, options.csv, out);
  } else {
    require_other_file(options);
    require_new_or_table(options.out, "--out");
    FileInTheMaking beside(options.out);
    std::ofstream text(beside.path());
    left_out = write_csv(recording, options.csv, text);
    text.close();
    if (!text)
      throw std::runtime_error("cannot write '" + options.out.string() + "'; check the free space of the disk");
    beside.end();
  }
  tell_damages(recording, err);
  Recording::Losses losses = recording.losses();
  losses.frames += left_out;
  if (losses.any()) err << "reorient: " << as_line(options.file.string()) << ": " << text_of(losses) << '\n';
  return losses.any() ? kWrong : kSuccess;
}

/// Replays all frames up to that time, because the record does not contain everything that is drawn.
int draw_pictures(const RecordingOptions& options, std::ostream& out, std::ostream& err) {
  const Interruption interruption;
  const auto stop = [] { return Interruption::signal() != 0; };
  Recording recording(options.file, stop);
  require_recorded(recording, options.at);
  const std::filesystem::path folder = options.out.empty() ? "out" : options.out;
  require_writable_folder(folder, "--out");
  Replay replay(recording, 0.0, options.at);
  RunPictures pictures(PicturedMoment::last_frame);
  double time = 0.0;
  while (const FrameLoop* const engine = replay.next_stretch()) {
    replay.run({}, {&pictures}, stop);
    time = engine->record().world.time;
  }
  if (stop()) return exit_code_of(Interruption::signal());
  tell_damages(recording, err);
  if (replay.stretches() == 0)
    throw std::runtime_error(options.file.string() +
                             ": expected frames that can be replayed, found none; see 'reorient recording info'");
  const std::vector<std::string> failures = pictures.write(folder);
  for (const std::string& failure : failures) print_error(err, failure);
  out << fmt::format("pictures of {:.2f} s: {}/\n", time, as_line(folder.string()));
  if (!failures.empty()) return kBadInput;
  return time + kReadingError < options.at ? kWrong : kSuccess;  // the frames up to this time are lost
}

}  // namespace

Subcommand add_recording(CLI::App& program) {
  CLI::App* const parser = program.add_subcommand("recording", "inspect, cut, recover or export a recording");
  parser->require_subcommand(1);
  set_examples(*parser, {{"reorient run --record run.mcap", "record a run"},
                         {"reorient recording info run.mcap", "what the recording contains"},
                         {"reorient recording export run.mcap --csv events", "its commands and changes of state"}});
  const auto options = std::make_shared<RecordingOptions>();
  const auto add = [&](const char* name, const char* description, std::initializer_list<Example> examples) {
    CLI::App* const word = parser->add_subcommand(name, description);
    set_examples(*word, examples);
    word->add_option("file", options->file, "recording that 'reorient run --record FILE' wrote")
        ->type_name("FILE")
        ->required();
    return word;
  };
  add("info", "print topics, times, sizes, and what can be replayed",
      {{"reorient recording info run.mcap", "one recording"}, {"reorient recording info part.mcap", "a part of it"}});
  CLI::App* const cut = add("cut", "copy a part that can be replayed like the whole recording",
                            {{"reorient recording cut run.mcap --from 40 --to 50 --out part.mcap", "10 s"},
                             {"reorient recording cut run.mcap --to 50 --out part.mcap", "all up to 50 s"}});
  add_time_options(*cut, options->times);
  CLI::App* const recover = add("recover", "copy all that can be read of a damaged or incomplete recording",
                                {{"reorient recording recover run.mcap --out whole.mcap", "recover"},
                                 {"reorient recording info whole.mcap", "see what was recovered"}});
  CLI::App* const csv = add("export", "write values of a recording as a CSV table",
                            {{"reorient recording export run.mcap --csv world --out run.csv", "all world fields"},
                             {"reorient recording export run.mcap --csv events", "commands and changes of state"}});
  csv->add_option("--csv", options->csv,
                  "table: world (all fields that behaviors read, a line for each frame), events (commands and changes "
                  "of state)")
      ->type_name("TABLE")
      ->check(CLI::IsMember(csv_topics()))
      ->required();
  csv->add_option("--out", options->out, "file to write (default: the standard output)")->type_name("FILE");
  CLI::App* const pictures = add("pictures", "draw the four pictures of a run at any time",
                                 {{"reorient recording pictures run.mcap --at 43.5", "pictures of the time 43.5 s"},
                                  {"reorient recording pictures run.mcap --at 20 --out early", "in another folder"}});
  pictures->add_option("--at", options->at, "time in the robot's seconds")
      ->type_name("SECONDS")
      ->check(check_moment)
      ->required();
  pictures->add_option("--out", options->out, "folder for the pictures (default: out)")->type_name("FOLDER");
  for (CLI::App* const word : {cut, recover})
    word->add_option("--out", options->out, "file to write")->type_name("FILE")->required();
  return {parser, [options, cut, recover, csv, pictures](std::ostream& out, std::ostream& err) {
            if (csv->parsed()) return export_csv(*options, out, err);
            if (pictures->parsed()) return draw_pictures(*options, out, err);
            if (cut->parsed()) {
              return rewrite(*options, out, err, [&](Recording& recording) {
                require_recorded(recording, options->times, err);
                return cut_recording(recording, options->times.from, options->times.to, options->out);
              });
            }
            if (recover->parsed()) {
              return rewrite(*options, out, err,
                             [&](Recording& recording) { return recover_recording(recording, options->out); });
            }
            return info(options->file, out);
          }};
}

}  // namespace reorient
