// SPDX-License-Identifier: MIT
#include "program/options.h"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <iterator>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>
#include <spdlog/spdlog.h>

#include "engine/parameters/nearest_name.h"
#include "program/former_names.h"
#include "program/run/venue.h"
#include "workbench/files/home.h"
#include "workbench/files/parameter_file.h"

namespace reorient {

void add_parameter_options(CLI::App& parser, ParameterOptions& options) {
  parser.add_option("--set", options.assignments, "set a parameter; repeatable ('reorient params' lists them)")
      ->type_name("NAME=VALUE")
      ->group(kParameterGroup)
      ->allow_extra_args(false);
  parser
      .add_option("--params", options.files, "load parameters: a TOML file, or a name in assets/parameters; repeatable")
      ->type_name("FILE")
      ->group(kParameterGroup)
      ->check(check_not_empty)
      ->allow_extra_args(false);
}

namespace {

constexpr std::string_view kParameterFiles[] = {".toml"};

std::filesystem::path parameter_file(const std::filesystem::path& named) {
  std::filesystem::path file = asset_file("parameters", named, kParameterFiles);
  std::error_code error;
  if (std::filesystem::is_directory(file, error))
    throw std::runtime_error("--params " + named.string() + ": expected a file, found a folder");
  if (!std::filesystem::exists(file, error) && is_asset_name(named)) {
    throw std::runtime_error("--params " + named.string() +
                             ": expected a file, or a name in assets/parameters, found neither" +
                             did_you_mean(named.string(), asset_names("parameters", kParameterFiles)));
  }
  return file;
}

}  // namespace

std::vector<std::filesystem::path> parameter_files_of(const ParameterOptions& options) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& named : options.files) files.push_back(parameter_file(named));
  return files;
}

std::vector<ParameterChange> overrides_of(const ParameterOptions& options) {
  std::vector<ParameterChange> changes;
  for (const std::filesystem::path& file : parameter_files_of(options)) {
    for (ParameterChange& change : read_parameters(file)) changes.push_back(std::move(change));
  }
  changes.insert(changes.end(), options.changes.begin(), options.changes.end());
  for (const std::string& assignment : options.assignments) {
    const std::size_t equals = assignment.find('=');
    if (equals == 0 || equals == std::string::npos) {
      throw std::runtime_error("--set: expected NAME=VALUE, as in --set decision.false_flips=1, found '" + assignment +
                               "'");
    }
    changes.push_back({assignment.substr(0, equals), assignment.substr(equals + 1), ParameterOrigin::command_line, ""});
  }
  rename_parameters(changes);
  return changes;
}

void set_overrides(const ParameterOptions& options, ParameterRegistry& registry) {
  for (const ParameterChange& change : overrides_of(options)) {
    if (change.origin == ParameterOrigin::command_line) {
      registry.set(change.name, change.value, change.origin);
    } else {
      registry.set_early(change);
    }
  }
}

void add_body_options(CLI::App& parser, std::filesystem::path& body, std::filesystem::path& field) {
  parser.add_option("--body", body, "humanoid: a file, or " + known_bodies() + " (default: nao-v6)")
      ->type_name("FILE")
      ->group(kRobotGroup)
      ->check(check_not_empty);
  parser.add_option("--field", field, "field: a file, or a name in assets/fields (default: scenario's or body's)")
      ->type_name("FILE")
      ->group(kRobotGroup)
      ->check(check_not_empty);
}

void add_scripts_option(CLI::App& parser, std::filesystem::path& scripts, const char* group) {
  parser.add_option("--scripts", scripts, "root folder of the scripts (default: scripts/ of the project)")
      ->type_name("FOLDER")
      ->group(group)
      ->check(check_not_empty);
}

std::filesystem::path scripts_root(const std::filesystem::path& given, Scripts scripts) {
  std::error_code error;
  if (given.empty()) {
    std::filesystem::path used = find_home() / "scripts";
    const std::filesystem::path other = other_home_around(std::filesystem::current_path(error));
    if (!other.empty() && std::getenv("REORIENT_HOME") == nullptr)
      spdlog::warn("the scripts of {} are used, not those of {}; choose with --scripts or REORIENT_HOME", used.string(),
                   (other / "scripts").string());
    return used;
  }
  if (!std::filesystem::is_directory(given, error))
    throw std::runtime_error("--scripts " + given.string() + ": expected a folder of scripts, found none");
  constexpr const char* kFolders[] = {"behaviors", "scenarios", "lib", "tests"};
  const bool has_any = std::any_of(std::begin(kFolders), std::end(kFolders), [&](const char* folder) {
    return std::filesystem::is_directory(given / folder, error);
  });
  if (scripts == Scripts::are_there && !has_any)
    throw std::runtime_error("--scripts " + given.string() +
                             ": expected a folder with behaviors, scenarios, lib or tests, found none of them");
  return given;
}

std::string check_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error == std::errc() && end == text.data() + text.size()) return {};
  return "expected a whole number from 0 to 2^64 - 1, found '" + text + "'";
}

std::string check_not_empty(const std::string& text) {
  return text.empty() ? "expected a value, found an empty one; leave it out for the default" : "";
}

namespace {

bool is_number(const std::string& text, double least, double most) {
  double number = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  return whole && number >= least && number <= most;
}

}  // namespace

std::function<std::string(const std::string&)> check_number(double least, double most) {
  return [least, most](const std::string& text) {
    if (is_number(text, least, most)) return std::string();
    return fmt::format("expected a number from {:g} to {:g}, found '{}'", least, most, text);
  };
}

std::string check_seconds(const std::string& text) {
  return is_number(text, 0.1, 86400.0) ? "" : "expected a number from 0.1 to 86400, found '" + text + "'";
}

std::string check_moment(const std::string& text) {
  return is_number(text, 0.0, 1e9) ? "" : "expected a non-negative number of seconds, found '" + text + "'";
}

}  // namespace reorient
