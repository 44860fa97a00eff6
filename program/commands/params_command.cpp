// `reorient params`: every tunable number with its value and who set it.
#include <memory>
#include <ostream>
#include <stdexcept>

#include <spdlog/fmt/fmt.h>

#include "engine/script/script_host.h"
#include "program/program.h"
#include "program/subcommand.h"
#include "program/tuning.h"
#include "workbench/files/parameter_file.h"

namespace reorient {
namespace {

struct ParamsOptions {
  std::string part;
  std::filesystem::path scripts;
  ParameterOptions overrides;
  bool changed = false;
  std::filesystem::path save;
};

void list(const std::vector<Parameter>& parameters, std::ostream& out) {
  std::size_t name_width = 0, value_width = 0;
  for (const Parameter& parameter : parameters) {
    name_width = std::max(name_width, parameter.name.size());
    value_width = std::max(value_width, to_text(parameter.value).size());
  }
  for (const Parameter& parameter : parameters) {
    out << fmt::format("{:<{}}  {:>{}}  {:<12}  {}: {}\n", parameter.name, name_width, to_text(parameter.value),
                       value_width, to_string(parameter.origin), range_text(parameter), parameter.description);
  }
}

int params(const ParamsOptions& options, std::ostream& out) {
  const std::filesystem::path root = scripts_root(options.scripts);
  Tuning tuning;
  tuning.override_by(options.overrides);
  ScriptHost host(root, tuning.registry);
  for (const std::string& file : scripts_in(root, "behaviors")) host.load_behavior((root / file).string());
  for (const std::string& file : scripts_in(root, "scenarios")) host.load_scenario((root / file).string());
  tuning.require_all_claimed();
  std::vector<Parameter> wanted = tuning.registry.list();
  std::erase_if(wanted, [&](const Parameter& parameter) {
    return parameter.name.find(options.part) == std::string::npos ||
           (options.changed && parameter.origin == ParameterOrigin::default_value);
  });
  if (wanted.empty() && !options.changed)
    throw std::runtime_error("no parameter has '" + options.part + "' in its name; reorient params lists all");
  list(wanted, out);
  if (!options.save.empty()) save_parameters(tuning.registry, options.save);
  return kSuccess;
}

}  // namespace

Subcommand add_params(CLI::App& program) {
  const auto options = std::make_shared<ParamsOptions>();
  CLI::App* const parser =
      program.add_subcommand("params", "list all parameters: value, origin, range, meaning")->fallthrough();
  parser->add_option("part", options->part, "only those with this in their names, as in: orientation.");
  parser->add_flag("--changed", options->changed, "only those that differ from their defaults");
  add_parameter_options(*parser, options->overrides);
  parser->add_option("--save-params", options->save, "write the overrides into this file, for --params");
  add_scripts_option(*parser, options->scripts);
  return {parser, [options](std::ostream& out, std::ostream&) { return params(*options, out); }};
}

}  // namespace reorient
