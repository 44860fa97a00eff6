// SPDX-License-Identifier: MIT
// `reorient params`: every parameter with its value and origin.
#include <memory>
#include <ostream>
#include <set>
#include <stdexcept>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/nearest_name.h"
#include "engine/parameters/utf8.h"
#include "program/help.h"
#include "program/named_files.h"
#include "program/options.h"
#include "program/parameter_list.h"
#include "program/parameter_modules.h"
#include "program/program.h"
#include "program/subcommand.h"
#include "workbench/files/parameter_file.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

struct ParamsOptions {
  std::string filter;
  std::filesystem::path scripts;
  std::filesystem::path body, field;  ///< as for `reorient run`
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
    out << fmt::format("{:<{}}  {:>{}}  {:<12}  {}\n", as_line(parameter.name), name_width,
                       as_line(to_text(parameter.value)), value_width, to_string(parameter.origin),
                       as_line(range_text(parameter) + ": " + parameter.description));
  }
}

/// Words for suggestions: whole names, and modules such as "orientation.".
std::vector<std::string> names_of(const std::vector<Parameter>& parameters) {
  std::set<std::string> names;
  for (const Parameter& parameter : parameters) {
    names.insert(parameter.name);
    names.insert(parameter.name.substr(0, parameter.name.rfind('.') + 1));
  }
  return {names.begin(), names.end()};
}

/// A text that ends with a dot is a group, such as "camera." of "robot.camera.pitch". Else any part of the name counts.
bool is_listed(const std::string& name, const std::string& filter) {
  return filter.ends_with('.') ? ("." + name).find("." + filter) != std::string::npos
                               : name.find(filter) != std::string::npos;
}

int params(const ParamsOptions& options, std::ostream& out) {
  const std::filesystem::path root = scripts_root(options.scripts);
  require_writable_output(options.save, "--save-params", root);
  const std::vector<ParameterChange> overrides = overrides_of(options.overrides);
  const ScriptTexts texts = read_scripts(root);
  const std::vector<Parameter> all = all_parameters(texts, options.body, options.field, overrides);
  std::set<std::string> loaded;
  for (const char* folder : {"behaviors", "scenarios"}) {
    for (const std::string& file : texts.in_folder(folder)) loaded.insert(module_of_script(file));
  }
  const std::vector<ParameterChange> kept = kept_for_others(overrides, {all, loaded, all_modules(texts)});
  std::vector<Parameter> wanted = all;
  std::erase_if(wanted, [&](const Parameter& parameter) {
    return !is_listed(parameter.name, options.filter) ||
           (options.changed && parameter.origin == ParameterOrigin::default_value);
  });
  if (wanted.empty() && !options.changed)
    throw std::runtime_error("expected a part of a parameter's name, found '" + options.filter + "'" +
                             did_you_mean(options.filter, names_of(all)) + "; 'reorient params' lists all");
  list(wanted, out);
  if (!options.save.empty()) save_parameters(all, kept, options.save);
  return kSuccess;
}

}  // namespace

Subcommand add_params(CLI::App& program) {
  const auto options = std::make_shared<ParamsOptions>();
  CLI::App* const parser =
      program.add_subcommand("params", "list all parameters with value, origin, range and meaning")->fallthrough();
  set_examples(*parser, {{"reorient params", "all parameters"},
                         {"reorient params orientation.", "those of a group"},
                         {"reorient params --params paper --changed", "what a file of parameters changes"}});
  parser
      ->add_option("filter", options->filter,
                   "list only names that contain this text; with a dot at its end, a group, as in: orientation.")
      ->type_name("FILTER");
  parser->add_flag("--changed", options->changed, "list only parameters that differ from their defaults")
      ->group(kOutputGroup);
  add_body_options(*parser, options->body, options->field);
  add_parameter_options(*parser, options->overrides);
  parser->add_option("--save-params", options->save, "write the changed parameters into this file, for --params")
      ->type_name("FILE")
      ->group(kOutputGroup);
  add_scripts_option(*parser, options->scripts);
  return {parser, [options](std::ostream& out, std::ostream&) { return params(*options, out); }};
}

}  // namespace reorient
