#include "engine/program/program.h"

#include <charconv>
#include <cstdint>
#include <exception>
#include <memory>
#include <ostream>
#include <stdexcept>
#include <string>
#include <system_error>

#include <CLI/CLI.hpp>
#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "engine/assets/home.h"
#include "engine/program/run_command.h"
#include "engine/program/test_command.h"

namespace reorient {
namespace {

constexpr const char* kExamples = R"(Examples:
  reorient run                              a robot is turned round and notices; pictures go into out/
  reorient run --seed 7 --room hall.hdr     the same in another room, with other noise
  reorient run --realtime                   at the robot's own pace: edit scripts/behaviors/*.lua meanwhile
  reorient run --without-room-awareness     the same robot without it stays wrong (exit code 1)
  reorient run --set orientation.lead=0.3   any parameter for this run
  reorient test                             the scripted behaviour tests
Exit codes: 0 the robot ended right, or all tests passed; 1 it did not; 2 bad input.)";

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n') c = ' ';
  }
  while (!text.empty() && text.back() == ' ') text.pop_back();
  return text;
}

/// CLI11 by itself takes a negative or too large number for a seed and wraps it round.
std::string check_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error == std::errc() && end == text.data() + text.size()) return {};
  return "'" + text + "' is no whole number from 0 to 2^64 - 1";
}

/// CLI11's own range lets NaN through.
std::string check_seconds(const std::string& text) {
  constexpr double kLeast = 0.1, kMost = 86400.0;
  double seconds = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (whole && seconds >= kLeast && seconds <= kMost) return {};
  return "'" + text + "' is no number from 0.1 to 86400";
}

void add_run_options(CLI::App& run, RunOptions& options) {
  run.add_option("scenario", options.scenario, "scripts/scenarios/NAME.lua, or a path to a file")
      ->capture_default_str();
  run.add_option("--room", options.room, "equirectangular panorama: .hdr, .png or .jpg (default: a procedural hall)");
  run.add_option("--hall", options.hall, "seed of the procedural hall")->check(check_seed)->capture_default_str();
  run.add_option("--field", options.field, "field dimensions (default: assets/fields/spl.toml)");
  run.add_option("--seed", options.seed, "of all noise; one seed, one digest")
      ->check(check_seed)
      ->capture_default_str();
  run.add_option("--width", options.width, "of the camera image, pixels")
      ->check(CLI::IsMember({160, 320, 640}))
      ->capture_default_str();
  run.add_flag("--realtime", options.realtime, "at the robot's own pace, not as fast as possible");
  run.add_flag("!--without-room-awareness", options.room_awareness, "switch the view of the room off");
  run.add_option("--set", options.set, "NAME=VALUE: override a parameter; may be given again")->allow_extra_args(false);
  run.add_option("--params", options.parameter_files, "TOML file with overrides; may be given again")
      ->allow_extra_args(false);
  run.add_option("--scripts", options.scripts, "root of the scripts (default: scripts/ of the project)");
  run.add_option("--out", options.out, "folder for the pictures")->capture_default_str();
  run.add_flag("!--no-pictures", options.pictures, "write no pictures");
  run.add_option("--json", options.json, "write the summary into this file, for programs");
  run.add_option("--seconds", options.seconds, "longest run, in the robot's seconds")
      ->check(check_seconds)
      ->capture_default_str();
  run.add_flag("--every-transition", options.every_transition, "show busy behaviours' transitions as well");
}

int parse_and_run(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  CLI::App app{"Reorient: a robot that notices that it is turned round."};
  app.name("reorient");
  app.footer(kExamples);
  app.require_subcommand(0, 1);  // none is told below, so that an unknown one is told by its name
  std::string log_level = "info";
  app.add_option("--log", log_level, "what to log: debug, info, warning, error, off")
      ->check(CLI::IsMember({"debug", "info", "warning", "error", "off"}))
      ->capture_default_str();

  RunOptions run_options;
  CLI::App* run = app.add_subcommand("run", "run a scenario on the simulator")->fallthrough();
  add_run_options(*run, run_options);
  TestOptions test_options;
  CLI::App* test = app.add_subcommand("test", "run scripted behaviour tests")->fallthrough();
  test->add_option("paths", test_options.paths, "test files or folders (default: scripts/tests)");
  test->add_option("--scripts", test_options.scripts, "root of the scripts (default: scripts/ of the project)");
  CLI::App* version = app.add_subcommand("version", "print the version");

  try {
    app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    CLI::App* asked = &app;
    for (CLI::App* sub : app.get_subcommands()) asked = sub;
    out << asked->help();
    return kSuccess;
  } catch (const CLI::ParseError& error) {
    err << "reorient: " << one_line(error.what()) << " (see reorient --help)\n";
    return kBadInput;
  }
  if (app.get_subcommands().empty()) {
    throw std::runtime_error("name a subcommand: run, test or version (see reorient --help)");
  }

  spdlog::set_default_logger(
      std::make_shared<spdlog::logger>("reorient", std::make_shared<spdlog::sinks::stderr_color_sink_mt>()));
  spdlog::set_level(spdlog::level::from_str(log_level));
  if (version->parsed()) {
    out << "reorient " << REORIENT_VERSION << '\n';
    return kSuccess;
  }
  const std::filesystem::path home = find_home();
  if (run->parsed()) {
    if (run_options.scripts.empty()) run_options.scripts = home / "scripts";
    if (run_options.field.empty()) run_options.field = home / "assets" / "fields" / "spl.toml";
    return run_scenario(run_options, out, err);
  }
  if (test_options.scripts.empty()) test_options.scripts = home / "scripts";
  return run_tests(test_options, out);
}

}  // namespace

int run_program(int argc, const char* const* argv, std::ostream& out, std::ostream& err) {
  try {
    return parse_and_run(argc, argv, out, err);
  } catch (const std::exception& error) {
    err << "reorient: " << one_line(error.what()) << '\n';
    return kBadInput;
  }
}

}  // namespace reorient
