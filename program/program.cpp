// SPDX-License-Identifier: MIT
#include "program/program.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <memory>
#include <new>
#include <ostream>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>
#include <poll.h>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>
#include <unistd.h>

#include "engine/parameters/utf8.h"
#include "program/command_line_error.h"
#include "program/help.h"
#include "program/interruption.h"
#include "program/limits.h"
#include "program/subcommand.h"
#include "workbench/recording/mcap/source.h"

namespace reorient {
namespace {

/// NO_COLOR: https://no-color.org
spdlog::color_mode color_mode(const std::string& asked) {
  if (asked == "always") return spdlog::color_mode::always;
  const char* const no_color = std::getenv("NO_COLOR");
  const bool is_unwanted = asked == "never" || (no_color != nullptr && *no_color != '\0');
  return is_unwanted ? spdlog::color_mode::never : spdlog::color_mode::automatic;
}

/// Whether the standard output is a pipe whose reader has ended, as head does.
bool has_reader_ended() {
  pollfd output{STDOUT_FILENO, POLLOUT, 0};
  return poll(&output, 1, 0) > 0 && (output.revents & POLLERR) != 0;
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
  app.add_option("--color", color, "color of log lines: always, never, auto (on a terminal, unless NO_COLOR is set)")
      ->type_name("WHEN")
      ->check(CLI::IsMember({"auto", "always", "never"}))
      ->capture_default_str();
  app.set_version_flag("--version", "reorient " REORIENT_VERSION, "print the version and exit");
  const std::array subcommands{add_run(app),    add_test(app),      add_experiment(app),  add_model(app),
                               add_check(app),  add_new(app),       add_list(app),        add_params(app),
                               add_graph(app),  add_reference(app), add_calibrate(app),   add_look(app),
                               add_replay(app), add_recording(app), add_record_test(app), add_room(app),
                               add_help(app),   add_version(app),   add_complete(app)};
  for (CLI::Option* option : app.get_options()) option->group("Global options");
  set_examples(app,
               {{"reorient run", "the demonstration: a robot notices that its belief is mirrored"},
                {"reorient room rate hall.hdr", "predict how well room awareness works in a hall"},
                {"reorient new behavior ball_search", "a small script with its test, to start from"},
                {"reorient test", "the scripted behavior tests"},
                {"reorient run --help", "the options of a command"}},
               "Exit codes: 0 success (the robot ended right, all tests passed, no errors found), 1 failure, 2 invalid "
               "input or an output that could not be written.");
  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    out << asked_of(app).help();
    return kSuccess;
  } catch (const CLI::CallForVersion& asked) {
    out << asked.what() << "\n";
    return kSuccess;
  } catch (const CLI::ParseError& error) {
    err << "reorient: " << as_line(text_of(error, app, subcommands)) << "\n";
    return kBadInput;
  }
  spdlog::set_default_logger(std::make_shared<spdlog::logger>(
      "reorient", std::make_shared<spdlog::sinks::stderr_color_sink_mt>(color_mode(color))));
  spdlog::set_level(spdlog::level::from_str(log_level));
  // On a terminal a log line takes the place of the progress line, which is drawn again below it.
  spdlog::set_pattern(isatty(STDERR_FILENO) == 1 ? "\r\033[K[%T] [%^%l%$] %v" : "[%T] [%^%l%$] %v");
  for (const Subcommand& subcommand : subcommands) {
    if (subcommand.parser->parsed()) return subcommand.run(out, err);
  }
  err << "reorient: " << missing_command(app) << " (see reorient --help)\n";
  return kBadInput;
}

}  // namespace

int run_program(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  if (const std::string shortage = stack_shortage(); !shortage.empty()) {
    err << "reorient: " << shortage << '\n';
    return kBadInput;
  }
  name_memory_shortage();
  try {
    const int code = parse_and_run(argc, argv, out, err);
    if (out.flush()) return code;
    if (has_reader_ended()) return exit_code_of(SIGPIPE);  // as usual in a pipe: the reader has what it wanted
    err << "reorient: cannot write to the standard output; check the free space of the disk\n";
    return kBadInput;
  } catch (const mcap::Stopped&) {
    return exit_code_of(Interruption::signal());
  } catch (const std::bad_alloc&) {  // also of libraries that allocate by themselves
    err << "reorient: " << memory_shortage() << '\n';
    return kBadInput;
  } catch (const std::system_error& error) {
    const bool is_shortage = error.code() == std::errc::resource_unavailable_try_again;
    err << "reorient: "
        << (is_shortage ? "expected another thread or process, found a limit of this user or of its memory (ulimit -u, "
                          "ulimit -v)"
                        : as_line(error.what()))
        << '\n';
    return kBadInput;
  } catch (const std::exception& error) {
    err << "reorient: " << as_line(error.what()) << '\n';
    return kBadInput;
  }
}

}  // namespace reorient
