// SPDX-License-Identifier: MIT
// Options that several subcommands have.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/parameters/parameter_registry.h"

namespace CLI {
class App;
}

namespace reorient {

// Groups of a help page whose options are added by several functions.
inline constexpr const char* kPlainGroup = "Options";  ///< of CLI11, if none is set
inline constexpr const char* kRobotGroup = "Robot and room";
inline constexpr const char* kParameterGroup = "Scripts and parameters";
inline constexpr const char* kOutputGroup = "Output";
inline constexpr const char* kFootageGroup = "Footage";

/// Overrides of parameters, in the order in which they are applied.
struct ParameterOptions {
  std::vector<std::filesystem::path> files;  ///< TOML
  std::vector<ParameterChange> changes{};    ///< of an experiment
  std::vector<std::string> assignments;      ///< NAME=VALUE
};
void add_parameter_options(CLI::App& parser, ParameterOptions& options);
/// Throws std::runtime_error with one line if a file cannot be read or an assignment is invalid.
std::vector<ParameterChange> overrides_of(const ParameterOptions& options);
/// For a program without scripts: ignores parameters of scripts in files. Throws std::runtime_error with one line if an
/// assignment names no parameter of the engine.
void set_overrides(const ParameterOptions& options, ParameterRegistry& registry);
/// The paths of the files, including assets given by name. Throws the same.
std::vector<std::filesystem::path> parameter_files_of(const ParameterOptions& options);
/// Adds --body and --field.
void add_body_options(CLI::App& parser, std::filesystem::path& body, std::filesystem::path& field);
void add_scripts_option(CLI::App& parser, std::filesystem::path& scripts, const char* group = kParameterGroup);
/// Whether the folder must contain scripts, or may still be empty.
enum class Scripts { are_there, may_come };
/// `given`, or scripts/ of the project if empty. Throws std::runtime_error with one line if it is not a root of
/// scripts: a mistyped path must not count as an empty root.
std::filesystem::path scripts_root(const std::filesystem::path& given, Scripts scripts = Scripts::are_there);

// Checks, because CLI11 wraps a negative or too large seed, and accepts NaN in a range. They return an error or
// nothing.
std::string check_seed(const std::string& text);
/// An empty value is probably an unset variable of the shell, not a request for the default.
std::string check_not_empty(const std::string& text);
/// Accepts numbers from `least` to `most`, both included.
std::function<std::string(const std::string&)> check_number(double least, double most);
std::string check_seconds(const std::string& text);
/// A non-negative time in the robot's seconds.
std::string check_moment(const std::string& text);

}  // namespace reorient
