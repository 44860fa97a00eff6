// SPDX-License-Identifier: MIT
#include "workbench/views/live/services.h"

#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/parameters/parameter.h"
#include "engine/parameters/utf8.h"
#include "robots/robot.h"
#include "workbench/files/parameter_file.h"
#include "workbench/script_tools/graph/machine_json.h"
#include "workbench/views/live/protocol/client_json.h"

namespace reorient::live {
namespace {

using ServiceJson = nlohmann::ordered_json;

std::string dumped(const ServiceJson& json) { return json.dump(-1, ' ', false, ServiceJson::error_handler_t::replace); }

ServiceJson value_json(const ParameterValue& value) {
  ServiceJson json;
  std::visit([&](const auto& one) { json = one; }, value);
  return json;
}

ServiceJson whole_parameter(const Parameter& parameter) {
  ServiceJson json{{"name", parameter.name},
                   {"value", value_json(parameter.value)},
                   {"default", value_json(parameter.default_value)}};
  if (parameter.kind == ParameterKind::real || parameter.kind == ParameterKind::integer) {
    json["min"] = parameter.minimum;
    json["max"] = parameter.maximum;
  }
  if (parameter.kind == ParameterKind::choice) json["choices"] = parameter.choices;
  constexpr const char* kKinds[] = {"real", "integer", "boolean", "choice"};
  static_assert(std::size(kKinds) == enum_count(ParameterKind()));
  json["type"] = kKinds[static_cast<std::size_t>(parameter.kind)];
  json["unit"] = parameter.unit;
  json["description"] = parameter.description;
  json["origin"] = to_string(parameter.origin);
  return json;
}

ServiceJson changes_json(const FrameAnswer& answer) {
  ServiceJson parameters = ServiceJson::array(), refused = ServiceJson::array();
  for (const ParameterOutcome& outcome : answer.outcomes) {
    if (!outcome.refusal.empty()) refused.push_back({{"name", outcome.name}, {"reason", as_line(outcome.refusal)}});
    for (const Parameter& parameter : *answer.parameters) {
      if (parameter.name == outcome.name)
        parameters.push_back({{"name", parameter.name}, {"value", value_json(parameter.value)}});
    }
  }
  return {{"parameters", std::move(parameters)}, {"refused", std::move(refused)}};
}

ServiceJson reloads_json(const FrameAnswer& answer) {
  ServiceJson scripts = ServiceJson::array();
  for (const ReloadRecord& reload : answer.reloads) {
    scripts.push_back({{"script", reload.script},
                       {"accepted", reload.accepted},
                       {"problem", reload.accepted ? "" : as_line(reload.fault.text())}});
  }
  return {{"scripts", std::move(scripts)}};
}

/// A schema with the types of an example's members.
ServiceJson schema_of_example(const ServiceJson& example) {
  if (example.is_object()) {
    ServiceJson properties = ServiceJson::object();
    for (const auto& [name, value] : example.items()) properties[name] = schema_of_example(value);
    return {{"type", "object"}, {"properties", std::move(properties)}};
  }
  if (example.is_array()) {
    ServiceJson items = example.empty() ? ServiceJson::object() : schema_of_example(example.front());
    return {{"type", "array"}, {"items", std::move(items)}};
  }
  if (example.is_string()) return {{"type", "string"}};
  if (example.is_boolean()) return {{"type", "boolean"}};
  return {{"type", "number"}};
}

std::string schema_text_of(std::string_view example) { return schema_of_example(ServiceJson::parse(example)).dump(); }

/// A viewer may be on another computer, so it cannot choose the folder, nor replace another file than one of
/// parameters.
std::string saved_file(const ClientObject& request, const std::string& service) {
  std::string file = request.text("file");
  const bool is_plain =
      file.size() > 5 && file.size() <= 100 && file.ends_with(".toml") && file.front() != '.' &&
      file.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.") == std::string::npos;
  if (!is_plain)
    throw BadClientMessage(service +
                           ": file: expected a name of letters and digits that ends in .toml, without a folder, "
                           "found '" +
                           as_line(file.substr(0, 100)) + "'");
  return file;
}

std::string note_text(const ClientObject& request) {
  std::string text = request.text("text");
  if (text.empty() || text.size() > kLongestNote)
    throw BadClientMessage("note: text: expected 1 to " + std::to_string(kLongestNote) + " bytes, found " +
                           std::to_string(text.size()));
  return text;
}

/// A word of a command, which the thread of the frames compares with many names.
std::string short_word(std::string word) {
  constexpr std::size_t kLongest = 100;
  if (word.size() > kLongest)
    throw BadClientMessage("expected a name of at most " + std::to_string(kLongest) + " bytes, found " +
                           std::to_string(word.size()));
  return word;
}

ActAsOperator operator_task(const ClientObject& request) {
  const OperatorRequestValues values{.x = request.optional_real("x"),
                                     .y = request.optional_real("y"),
                                     .degrees = request.optional_real("degrees"),
                                     .stops = request.optional_real("stops"),
                                     .penalized = request.optional_boolean("penalized")};
  try {
    return {operator_request(request.text("action"), values)};
  } catch (const BadClientMessage&) {
    throw;
  } catch (const std::runtime_error& error) {
    throw BadClientMessage("operator: " + std::string(error.what()));
  }
}

ChangePace pace_task(const ClientObject& request) {
  using Change = ChangePace::Change;
  const std::string action = request.text("action");
  if (action == "pause") return {.change = Change::pause};
  if (action == "resume") return {.change = Change::resume};
  if (action == "frame") {
    const double frames = request.optional_real("frames").value_or(1.0);
    if (!(frames >= 1.0 && frames <= RunPace::kMostFrames && frames == std::floor(frames)))
      throw BadClientMessage("pace: frames: expected a whole number from 1 to " + std::to_string(RunPace::kMostFrames) +
                             ", found " + to_text(frames));
    return {.change = Change::frame, .frames = static_cast<int>(frames)};
  }
  if (action == "speed") {
    const std::optional<double> factor = request.optional_real("factor");
    if (!factor) throw BadClientMessage("pace: factor: expected a number, found none");
    return {.change = Change::speed, .speed = *factor};
  }
  throw BadClientMessage("pace: action: expected pause, resume, frame or speed, found '" +
                         as_line(action.substr(0, 40)) + "'");
}

ServiceJson run_json(const FrameAnswer& answer) {
  return {{"operator", answer.run.has_operator},
          {"pace", answer.run.sets_pace},
          {"paused", answer.run.is_paused},
          {"speed", answer.run.speed},
          {"time", answer.time}};
}

}  // namespace

std::string advertise_live_services() {
  std::vector<std::string> schemas;
  schemas.reserve(2 * kServices.size());  // the texts must not move
  std::vector<ServiceInfo> all;
  for (const ServiceRow& row : kServices) {
    const std::string& request = schemas.emplace_back(schema_text_of(row.request));
    const std::string& response = schemas.emplace_back(schema_text_of(row.response));
    all.push_back({id_of(row.service), row.name, request, response});
  }
  return advertise_services(all);
}

const ServiceRow* find_service(std::uint32_t id) {
  return id == 0 || id > kServices.size() ? nullptr : &kServices[id - 1];
}

FrameTask read_service_request(const ServiceRow& row, const std::string& payload, AnswerAddress& to) {
  const ClientObject request(std::string(row.name), payload.empty() ? "{}" : payload);
  switch (row.service) {
    case Service::set_parameters:
      return ChangeParameters{read_parameter_texts(payload)};
    case Service::undo:
      return UndoChange{};
    case Service::note:
      return AddNote{note_text(request)};
    case Service::diff:
      return AskPrompt{{"diff"}};
    case Service::states:
      return AskPrompt{{"states"}};
    case Service::why:
      return AskPrompt{{"why", short_word(request.text("machine"))}};
    case Service::machine:
      return DescribeMachine{short_word(request.text("machine"))};
    case Service::world: {
      const std::string pattern = short_word(request.text_or_empty("pattern"));
      return pattern.empty() ? AskPrompt{{"world"}} : AskPrompt{{"world", pattern}};
    }
    case Service::run_state:
      return ShowRun{};
    case Service::operate:
      return operator_task(request);
    case Service::pace:
      return pace_task(request);
    case Service::save:
      to.file = saved_file(request, "save");
      return ListParameters{};
    default:
      return ListParameters{};
  }
}

std::string file_parameters(const std::string& payload) {
  const std::string file = saved_file(ClientObject("file_parameters", payload), "file_parameters");
  ServiceJson all = ServiceJson::array();
  for (const ParameterChange& change : read_parameters(file))
    all.push_back({{"name", as_utf8(change.name)}, {"value", as_utf8(change.value)}});
  return dumped({{"file", file}, {"parameters", std::move(all)}});
}

std::string service_answer(const ServiceRow& row, const FrameAnswer& answer) {
  switch (row.service) {
    case Service::parameter_list: {
      ServiceJson all = ServiceJson::array();
      for (const Parameter& parameter : *answer.parameters) all.push_back(whole_parameter(parameter));
      return dumped({{"parameters", std::move(all)}});
    }
    case Service::set_parameters:
    case Service::undo:
      return dumped(changes_json(answer));
    case Service::note:
    case Service::operate:
      return dumped({{"time", answer.time}});
    case Service::run_state:
    case Service::pace:
      return dumped(run_json(answer));
    case Service::save:
      return dumped({{"file", answer.to.file}, {"backup", answer.backup}});
    case Service::reload:
      return dumped(reloads_json(answer));
    case Service::machine:
      return "{\"time\":" + dumped(answer.time) +
             ",\"machine\":" + machine_json(answer.machine->definition, answer.machine->texts) + "}";
    default:
      return dumped({{"text", as_utf8(answer.text)}});
  }
}

}  // namespace reorient::live
