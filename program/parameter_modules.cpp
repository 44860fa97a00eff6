// SPDX-License-Identifier: MIT
#include "program/parameter_modules.h"

#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

#include <spdlog/spdlog.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/nearest_name.h"
#include "program/former_names.h"
#include "program/robots.h"

namespace reorient {
namespace {

constexpr std::size_t kMostWarnings = 10;
constexpr std::size_t kLongestName = 200;  // characters of a name in a message

void warn_of_unknown_modules(const std::map<std::string, std::string>& sources, const ParameterModules& modules) {
  const std::vector<std::string> known(modules.anywhere.begin(), modules.anywhere.end());
  std::size_t printed = 0;
  for (const auto& [module, source] : sources) {
    if (printed++ == kMostWarnings) break;
    spdlog::warn("{}: unknown module '{}'{}; its values are saved but not used", source, module,
                 did_you_mean(module, known));
  }
  if (sources.size() > kMostWarnings)
    spdlog::warn("and {}", counted(sources.size() - kMostWarnings, "more such table"));
}

}  // namespace

std::string module_of(std::string_view parameter) {
  const std::size_t dot = parameter.rfind('.');
  return std::string(parameter.substr(0, dot == std::string_view::npos ? 0 : dot));
}

std::string module_of_script(std::string_view file) { return std::filesystem::path(file).stem().string(); }

std::set<std::string> all_modules(const ScriptTexts& scripts) {
  std::set<std::string> modules;
  for (const std::string& file : scripts.files()) modules.insert(module_of_script(file));
  for (const std::string& robot : robot_names()) {
    for (const Parameter& parameter : robot_parameters(robot, {})) modules.insert(module_of(parameter.name));
  }
  return modules;
}

std::vector<ParameterChange> kept_for_others(const std::vector<ParameterChange>& overrides,
                                             const ParameterModules& modules) {
  std::set<std::string> names, loaded = modules.loaded;
  for (const Parameter& parameter : modules.parameters) {
    names.insert(parameter.name);
    loaded.insert(module_of(parameter.name));
  }
  std::map<std::string, ParameterChange> kept;         // the last value of a name counts
  std::map<std::string, std::string> unknown_modules;  // module, and the place that first names it
  for (const ParameterChange& change : overrides) {
    if (names.contains(change.name) || warn_of_former_name(change)) continue;
    const std::string module = module_of(change.name);
    if (change.origin != ParameterOrigin::file || module.empty() || loaded.contains(module)) {
      const bool may_be_loaded = !loaded.contains(module) && modules.anywhere.contains(module);
      const std::string hint =
          may_be_loaded ? "; this run does not load '" + module.substr(0, kLongestName) + "' (--with loads a behavior)"
                        : did_you_mean(change.name, std::vector<std::string>(names.begin(), names.end()));
      const char* const where = hint.empty() ? "; 'reorient params' lists all" : "";
      std::string text = change.source;
      if (text.empty()) text.append("the ").append(to_string(change.origin));
      text.append(": unknown parameter '").append(change.name, 0, kLongestName).append("'").append(hint).append(where);
      throw std::runtime_error(text);
    }
    if (!modules.anywhere.contains(module)) unknown_modules.try_emplace(module, change.source);
    kept.insert_or_assign(change.name, change);
  }
  warn_of_unknown_modules(unknown_modules, modules);
  std::vector<ParameterChange> all;
  all.reserve(kept.size());
  for (auto& [name, change] : kept) all.push_back(std::move(change));
  return all;
}

}  // namespace reorient
