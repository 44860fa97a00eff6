// SPDX-License-Identifier: MIT
#include "program/program.h"

#include <algorithm>
#include <array>
#include <csignal>
#include <exception>
#include <filesystem>
#include <iostream>
#include <memory>
#include <new>
#include <ostream>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include <CLI/CLI.hpp>
#include <poll.h>
#include <unistd.h>

#include "program/command_line_error.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/limits.h"
#include "program/log.h"
#include "program/program_output.h"
#include "program/safe_output.h"
#include "program/subcommand.h"
#include "workbench/recording/mcap/source.h"

namespace reorient {
namespace {

/// Whether the standard output is a pipe whose reader has ended, as head does.
bool has_reader_ended() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
}

/// The words behind the program's name, in reverse order as the parser takes them. `--set NAME VALUE`, the form of the
/// prompt, becomes `--set NAME=VALUE`.
std::vector<std::string> reversed_words(int argc, const char* const* argv) {
  std::vector<std::string> words;
  for (int i = 1; i < argc; ++i) {
    const bool names_value = words.size() > 1 && words.end()[-2] == "--set" &&
                             words.back().find('=') == std::string::npos &&
                             !std::string_view(argv[i]).starts_with("--");
    if (names_value)
      words.back().append("=").append(argv[i]);
    else
      words.emplace_back(argv[i]);
  }
  std::reverse(words.begin(), words.end());
  return words;
}

int parse_and_run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  CLI::App app{"Reorient: a robot notices when its belief is mirrored, by the colors of the room"};
  app.name("reorient");
  app.formatter(std::make_shared<HelpFormatter>());
  app.set_help_flag("-h,--help", "print this help and exit");
  app.require_subcommand(0, 1);  // report a missing one below, so that an unknown one is reported by its name
  std::string log_level = "info";
  app.add_option("--log", log_level, "log level")
      ->type_name("LEVEL")
      ->check(CLI::IsMember({"debug", "info", "warning", "error", "off"}))
      ->capture_default_str();
  std::string color = "auto";
  app.add_option("--color", color,
                 "color of log lines and of the timeline: always, never, auto (on a terminal, unless NO_COLOR is set)")
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  app.set_version_flag("--version", "reorient " REORIENT_VERSION, "print the version and exit");
  const std::array subcommands{add_run(app),    add_game(app),   add_test(app),      add_experiment(app),
                               add_model(app),  add_check(app),  add_new(app),       add_list(app),
                               add_params(app), add_graph(app),  add_reference(app), add_calibrate(app),
                               add_look(app),   add_replay(app), add_recording(app), add_record_test(app),
                               add_room(app),   add_help(app),   add_version(app),   add_complete(app)};
  for (CLI::Option* option : app.get_options()) option->group("Global options");
  set_examples(app,
               {{"reorient run", "the demonstration: a robot notices that its belief is mirrored"},
                {"reorient room rate hall.hdr", "predict how well room awareness works in a hall"},
                {"reorient new behavior ball_search", "a small script with its test, to start from"},
                {"reorient test", "the scripted behavior tests"},
                {"reorient run --help", "the options of a command"}},
               "Exit codes: 0 success (the robot ended right, all tests passed, no errors found), 1 failure, 2 invalid "
               "input or an output that could not be written. Environment: REORIENT_HOME names the folder with "
               "scripts/behaviors and assets/ (default: the program's own); NO_COLOR switches colors off.");
  try {
    app.parse(reversed_words(argc, argv));
  } catch (const CLI::CallForHelp&) {
    out << asked_of(app).help();
    return kSuccess;
  } catch (const CLI::CallForVersion& asked) {
    out << asked.what() << "\n";
    return kSuccess;
  } catch (const CLI::ParseError& error) {
    print_error(err, text_of(error, app, subcommands));
    return kBadInput;
  }
  set_up_log(log_level, color);
  // A test's stream is no terminal, even if the test's own output is one.
  if (auto* const output = dynamic_cast<SafeOutput*>(out.rdbuf()); output != nullptr)
    output->is_colored =
        color == "always" || (output->writes_to(std::cout) && are_colors_printed(color, STDOUT_FILENO));
  for (const Subcommand& subcommand : subcommands) {
    if (subcommand.parser->parsed()) return subcommand.run(out, err);
  }
  print_error(err, missing_command(app) + " (see reorient --help)");
  return kBadInput;
}

}  // namespace

int run_program(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  if (const std::string shortage = stack_shortage(); !shortage.empty()) {
    print_error(err, shortage);
    return kBadInput;
  }
  name_memory_shortage();
  SafeOutput safe_out(out), safe_err(err);
  std::ostream printed(&safe_out), reported(&safe_err);
  try {
    const int code = parse_and_run(argc, argv, printed, reported);
    if (printed.flush()) return code;
    if (has_reader_ended()) return exit_code_of(SIGPIPE);  // as usual in a pipe: the reader has what it wanted
    print_error(reported, "cannot write to the standard output; check the free space of the disk");
    return kBadInput;
  } catch (const mcap::Stopped&) {
    return exit_code_of(Interruption::signal());
  } catch (const std::bad_alloc&) {  // also of libraries that allocate by themselves
    print_error(reported, memory_shortage());
    return kBadInput;
  } catch (const std::system_error& error) {
    const bool is_shortage = error.code() == std::errc::resource_unavailable_try_again;
    print_error(reported, is_shortage
                              ? "expected another thread or process, found a limit of this user or of its memory "
                                "(ulimit -u, ulimit -v)"
                              : error.what());
    return kBadInput;
  } catch (const std::exception& error) {
    print_error(reported, error.what());
    return kBadInput;
  }
}

}  // namespace reorient
