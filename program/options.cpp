#include "program/options.h"

#include <charconv>

#include "workbench/files/home.h"

namespace reorient {

void add_parameter_options(CLI::App& parser, ParameterOptions& options) {
  parser.add_option("--set", options.assignments, "NAME=VALUE: override a parameter; may be given again")
      ->allow_extra_args(false);
  parser.add_option("--params", options.files, "TOML file with overrides; may be given again")->allow_extra_args(false);
}

void add_scripts_option(CLI::App& parser, std::filesystem::path& scripts) {
  parser.add_option("--scripts", scripts, "root of the scripts (default: scripts/ of the project)");
}

std::filesystem::path scripts_root(const std::filesystem::path& told) {
  return told.empty() ? find_home() / "scripts" : told;
}

std::string check_seed(const std::string& text) {
  std::uint64_t seed = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
  if (error == std::errc() && end == text.data() + text.size()) return {};
  return "'" + text + "' is not a whole number from 0 to 2^64 - 1";
}

std::string check_seconds(const std::string& text) {
  constexpr double kLeast = 0.1, kMost = 86400.0;
  double seconds = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seconds);
  const bool whole = error == std::errc() && end == text.data() + text.size();
  if (whole && seconds >= kLeast && seconds <= kMost) return {};
  return "'" + text + "' is not a number from 0.1 to 86400";
}

}  // namespace reorient
