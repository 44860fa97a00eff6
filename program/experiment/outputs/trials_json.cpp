// SPDX-License-Identifier: MIT
#include "program/experiment/outputs/trials_json.h"

#include <nlohmann/json.hpp>

#include "engine/parameters/utf8.h"
#include "engine/world/room_status.h"
#include "workbench/experiments/report/trial_columns.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

template <typename Value>
ordered_json value_or_null(const Value& value) {
  return value;
}
template <typename Value>
ordered_json value_or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

ordered_json confidences_as_json(const std::vector<ConfidenceSample>& samples) {
  ordered_json json;
  for (const char* name : {"time_s", "current", "opposite", "evidence", "status", "correct", "reflected", "threshold"})
    json[name] = ordered_json::array();
  for (const ConfidenceSample& sample : samples) {
    json["time_s"].push_back(sample.time);
    json["current"].push_back(sample.current);
    json["opposite"].push_back(sample.opposite);
    json["evidence"].push_back(sample.evidence);
    json["status"].push_back(to_string(sample.status));
    json["correct"].push_back(sample.correct);
    json["reflected"].push_back(sample.reflected);
    json["threshold"].push_back(sample.threshold);
  }
  return json;
}

ordered_json looks_as_json(const std::vector<CompassLook>& looks) {
  ordered_json json = ordered_json::array();
  for (const CompassLook& look : looks) {
    ordered_json& methods = json.emplace_back();
    for (std::size_t i = 0; i < look.size(); ++i)
      methods[std::string(kCompassMethods[i])] = {{"if_right", look[i].if_right},
                                                  {"if_reflected", look[i].if_reflected},
                                                  {"flips_if_right", look[i].flips_if_right},
                                                  {"flips_if_reflected", look[i].flips_if_reflected}};
  }
  return json;
}

}  // namespace

std::string trials_as_json(const Experiment& experiment, const std::vector<CellResults>& cells) {
  std::string text;
  int task = 0;
  for (const CellResults& cell : cells) {
    for (const TrialResult& trial : cell.trials) {
      ordered_json json{{"choices", ordered_json::object()}, {"task", ++task}};
      for (std::size_t i = 0; i < experiment.axes.size(); ++i)
        json["choices"][as_utf8(experiment.axes[i].name)] = as_utf8(cell.choices[i]);
      visit_columns([&json](const char* name, const auto& value) { json[name] = value_or_null(value); }, trial);
      for (std::size_t i = 0; i < experiment.measures.size() && i < trial.measures.size(); ++i)
        json["measures"][as_utf8(experiment.measures[i].label())] = value_or_null(trial.measures[i]);
      json["confidences"] = confidences_as_json(trial.confidences);
      if (!trial.looks.empty()) json["looks"] = looks_as_json(trial.looks);
      text.append(text.empty() ? "[\n" : ",\n").append(json.dump());
    }
  }
  return (text.empty() ? "[" : text + "\n") + "]\n";
}

}  // namespace reorient
