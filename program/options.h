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

// Groups of a help page that have options from several places.
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
/// Throws std::runtime_error with one line where a file cannot be read or an assignment is none.
std::vector<ParameterChange> overrides_of(const ParameterOptions& options);
/// Of a program without scripts: parameters of scripts may stand in files, and are left out. Throws std::runtime_error
/// with one line where an assignment names no parameter of the engine.
void set_overrides(const ParameterOptions& options, ParameterRegistry& registry);
/// The files themselves, those that are named as assets, too. Throws the same.
std::vector<std::filesystem::path> parameter_files_of(const ParameterOptions& options);
/// Which humanoid, and on which field.
void add_body_options(CLI::App& parser, std::filesystem::path& body, std::filesystem::path& field);
void add_scripts_option(CLI::App& parser, std::filesystem::path& scripts, const char* group = kParameterGroup);
/// Whether a folder may be named that will only get its scripts.
enum class Scripts { are_there, may_come };
/// `told`, or scripts/ of the project where nothing was told. Throws std::runtime_error with one line where it is no
/// root of scripts: what is mistyped must not count as one that is empty.
std::filesystem::path scripts_root(const std::filesystem::path& told, Scripts scripts = Scripts::are_there);

// CLI11 by itself takes a negative or too large number for a seed and wraps it round, and lets NaN through a range.
// These return what is wrong, or nothing.
std::string check_seed(const std::string& text);
/// An empty word is rather a variable of the shell without a value than a wish for the default.
std::string check_not_empty(const std::string& text);
/// Of numbers from `least` to `most`, both included.
std::function<std::string(const std::string&)> check_number(double least, double most);
std::string check_seconds(const std::string& text);
/// A time of a robot that has been on for a while.
std::string check_moment(const std::string& text);

}  // namespace reorient
