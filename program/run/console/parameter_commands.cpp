// SPDX-License-Identifier: MIT
#include "program/run/console/parameter_commands.h"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/nearest_name.h"
#include "program/background_writing.h"
#include "program/run/console/name_pattern.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/parameter_file.h"

namespace reorient {
namespace {

Words names_of(const std::vector<Parameter>& parameters) {
  Words names;
  for (const Parameter& parameter : parameters) names.push_back(parameter.name);
  return names;
}

const Parameter& named(const std::vector<Parameter>& parameters, const std::string& name) {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const auto& one) { return one.name == name; });
  if (found == parameters.end())
    throw std::runtime_error("unknown parameter '" + name + "'" + did_you_mean(name, names_of(parameters)));
  return *found;
}

std::string outcome_text(const ParameterOutcome& outcome) {
  return outcome.refusal.empty() ? outcome.name + " = " + outcome.value : outcome.refusal;
}

}  // namespace

ParameterCommands::ParameterCommands(ScenarioHost* scenario, std::function<std::vector<Parameter>()> parameters,
                                     std::function<std::vector<ParameterChange>()> kept_parameters)
    : scenario_(scenario), parameters_(std::move(parameters)), kept_parameters_(std::move(kept_parameters)) {}

Reply ParameterCommands::set(const std::string& name, const std::string& value, FrameInputs& inputs) {
  const std::vector<Parameter> all = parameters_();
  const Parameter& parameter = named(all, name);
  const std::uint64_t number = before_.add(change_back_to(parameter, inputs));
  return change({name, value, ParameterOrigin::live, ""}, inputs, [this, number] { before_.remove(number); });
}

Reply ParameterCommands::undo(FrameInputs& inputs) {
  const std::optional<ParameterChange> back = before_.take_last();
  return back ? change(*back, inputs, [] {}) : at_once("  no change to undo\n");
}

Reply ParameterCommands::change(const ParameterChange& wanted, FrameInputs& inputs, std::function<void()> refused) {
  return [requested = request_change(wanted, scenario_, inputs), refused = std::move(refused)](const FrameRecord& frame,
                                                                                               const SceneTruth&) {
    const ParameterOutcome outcome = outcome_of_change(requested, frame);
    if (!outcome.refusal.empty()) refused();
    return "  " + printable(outcome_text(outcome)) + "\n";
  };
}

Reply ParameterCommands::list(const std::string& pattern) const {
  return [this, pattern](const FrameRecord&, const SceneTruth&) {
    const std::vector<Parameter> all = parameters_();
    std::string text;
    for (const std::size_t i : pick(pattern, names_of(all), "parameter"))
      text += fmt::format("  {} = {}  ({}; {}) {}\n", all[i].name, to_text(all[i].value), range_text(all[i]),
                          to_string(all[i].origin), all[i].description);
    return text;
  };
}

Reply ParameterCommands::differences() const {
  return [this](const FrameRecord&, const SceneTruth&) -> std::string {
    std::string text;
    for (const Parameter& parameter : parameters_()) {
      if (parameter.value == parameter.default_value) continue;
      text += fmt::format("  {} = {}  (default {}; {})\n", parameter.name, to_text(parameter.value),
                          to_text(parameter.default_value), to_string(parameter.origin));
    }
    return text.empty() ? "  all parameters have their defaults\n" : text;
  };
}

Reply ParameterCommands::save(const std::string& file) const {
  return [this, file, writing = std::shared_ptr<BackgroundWriting>()](
             const FrameRecord&, const SceneTruth&) mutable -> std::optional<std::string> {
    if (!writing) {
      writing = std::make_shared<BackgroundWriting>();
      writing->start([file, parameters = parameters_(),
                      kept = kept_parameters_ ? kept_parameters_() : std::vector<ParameterChange>()] {
        require_writable_file(file, "save");
        save_parameters(parameters, kept, file);
      });
    }
    if (writing->is_busy()) return std::nullopt;
    if (const std::string mistake = writing->mistake(); !mistake.empty()) throw std::runtime_error(mistake);
    return "  written; --params " + printable(file) + " loads it\n";
  };
}

Words ParameterCommands::names() const { return names_of(parameters_()); }

Words ParameterCommands::values(const std::string& name) const {
  for (const Parameter& parameter : parameters_()) {
    if (parameter.name != name) continue;
    if (parameter.kind == ParameterKind::choice) return parameter.choices;
    if (parameter.kind == ParameterKind::boolean) return {"false", "true"};
    return {to_text(parameter.value)};
  }
  return {};
}

}  // namespace reorient
