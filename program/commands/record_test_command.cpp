// SPDX-License-Identifier: MIT
// `reorient record-test`: a part of a recording becomes a scripted test.
#include <filesystem>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "engine/record/record_bytes.h"
#include "program/help.h"
#include "program/options.h"
#include "program/program.h"
#include "program/recording/damages.h"
#include "program/recording/recorded_times.h"
#include "program/script_names.h"
#include "program/shell_word.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/rewriting.h"

namespace reorient {
namespace {

struct RecordTestOptions {
  std::filesystem::path file, scripts;
  std::string name;
  RecordedTimes times;
};

std::string in_lua(std::string_view text) {
  std::string quoted = "\"";
  for (const char letter : text) {
    if (letter == '"' || letter == '\\') quoted += '\\';
    const auto code = static_cast<unsigned char>(letter);
    if (code < 32 || code == 127) {
      quoted += fmt::format("\\{:03}", code);
    } else {
      quoted += letter;
    }
  }
  return quoted + '"';
}

/// Expectations: the commands of the robot, and the last states of its behaviors.
std::string expectations(const std::filesystem::path& file) {
  Recording recording(file);
  RecordedFrame frame;
  std::string text;
  FrameRecord last;
  while (recording.next(frame)) {
    last = read_record(frame.entry.record);
    for (std::size_t i = 0; i < last.commands.size(); ++i) {
      const CommandRecord& command = last.commands[i];
      if (i == 0) text += fmt::format("\n  advance_to({:.2f})\n", last.world.time);
      text += fmt::format("  expect.command({}, {})\n", in_lua(to_string(command.request.reorientation)),
                          in_lua(to_string(command.verdict)));
      text += fmt::format("  expect.reason({}, {})\n", in_lua(last.name(command.request.issuer.machine)),
                          in_lua(last.name(command.request.issuer.reason)));
    }
  }
  text += fmt::format("\n  advance_to({:.2f})\n", last.world.time);
  for (const MachineStatus& machine : last.machines)
    text +=
        fmt::format("  expect.state({}, {})\n", in_lua(last.name(machine.machine)), in_lua(last.name(machine.state)));
  return text;
}

int record_test(const RecordTestOptions& options, std::ostream& out, std::ostream& err) {
  const std::string name = options.name.empty() ? options.file.stem().string() : options.name;
  require_script_name(name);
  const std::filesystem::path tests = scripts_root(options.scripts) / "tests";
  const std::filesystem::path part = tests / "recordings" / (name + ".mcap"), test = tests / (name + "_test.lua");
  for (const std::filesystem::path& file : {part, test}) {
    if (std::filesystem::exists(file))
      throw std::runtime_error(file.string() +
                               ": expected a new file, found an existing one; choose another name: --name NAME");
  }
  Recording recording(options.file);
  require_recorded(recording, options.times, err);
  std::error_code error;
  std::filesystem::create_directories(part.parent_path(), error);
  if (error)
    throw std::runtime_error("cannot create the folder " + part.parent_path().string() + ": " + error.message());
  const Rewritten done = cut_recording(recording, options.times.from, options.times.to, part, Views::left_out);
  tell_damages(recording, err);
  const auto write_test = [&] {
    write_whole_file(
        test,
        fmt::format(
            R"(--- Recorded: {}, {:.2f} to {:.2f} s. The expectations are what the robot did; change them to what it should do.

test("{} continues as recorded", function()
  replay "recordings/{}.mcap"
{}  -- expect.as_recorded()  -- all commands and motions stay as recorded
end)
)",
            as_line(options.file.filename().string()), done.first_time, done.last_time, name, name,
            expectations(part)));
  };
  try {
    write_test();
  } catch (const std::exception&) {
    std::filesystem::remove(part, error);  // so that another try with this name is possible
    throw;
  }
  out << fmt::format("{}: {}, {:.1f} MB\n{}\nNext: reorient test {}{}\n", as_line(part.string()),
                     counted(done.frames, "frame"), 1e-6 * static_cast<double>(std::filesystem::file_size(part)),
                     as_line(test.string()), shell_word(test.string()),
                     options.scripts.empty() ? "" : " --scripts " + shell_word(options.scripts.string()));
  if (!done.losses.any()) return kSuccess;
  err << "reorient: " << as_line(options.file.string()) << ": " << text_of(done.losses) << '\n';
  return kWrong;
}

}  // namespace

Subcommand add_record_test(CLI::App& program) {
  const auto options = std::make_shared<RecordTestOptions>();
  CLI::App* const parser =
      program.add_subcommand("record-test", "write a scripted test from a part of a recording")->fallthrough();
  set_examples(*parser, {{"reorient record-test run.mcap --from 40 --to 45", "test with the frames of 5 s"},
                         {"reorient record-test run.mcap --name flips_once", "test with another name"}});
  parser->add_option("file", options->file, "recording that 'reorient run --record FILE' wrote")
      ->type_name("FILE")
      ->required();
  add_time_options(*parser, options->times);
  parser->add_option("--name", options->name, "name of the test: a-z, 0-9 and _ (default: the file's name)")
      ->type_name("NAME");
  add_scripts_option(*parser, options->scripts, kPlainGroup);
  return {parser, [options](std::ostream& out, std::ostream& err) { return record_test(*options, out, err); }};
}

}  // namespace reorient
