#include "program/experiment/outputs/trials_json.h"

#include <nlohmann/json.hpp>

#include "engine/parameters/utf8.h"
#include "engine/world/commands.h"
#include "engine/world/room_status.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

template <typename Value>
ordered_json value_or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

ordered_json confidences_as_json(const std::vector<ConfidenceSample>& samples) {
  ordered_json json;
  for (const char* name : {"time_s", "current", "opposite", "status", "correct"}) json[name] = ordered_json::array();
  for (const ConfidenceSample& sample : samples) {
    json["time_s"].push_back(sample.time);
    json["current"].push_back(sample.current);
    json["opposite"].push_back(sample.opposite);
    json["status"].push_back(to_string(sample.status));
    json["correct"].push_back(sample.correct);
  }
  return json;
}

void add_measurements(ordered_json& json, const TrialResult& trial) {
  json["seed"] = trial.seed;
  json["started"] = trial.started;
  json["disturbed"] = trial.disturbed();
  json["failed"] = trial.failed();
  json["measured_s"] = trial.seconds;
  json["right_after_s"] = value_or_null(trial.right_after);
  json["mended_after_s"] = value_or_null(trial.mended_after);
  json["mended_by"] = trial.mended_by ? ordered_json(to_string(*trial.mended_by)) : ordered_json();
  json["usable_after_s"] = value_or_null(trial.usable_after);
  json["kidnapped"] = trial.kidnapped;
  json["flips"] = trial.flips;
  json["purges"] = trial.purges;
  json["resets"] = trial.resets;
  json["false_flips"] = trial.false_flips;
  json["false_purges"] = trial.false_purges;
  json["right_s"] = trial.right_seconds;
  json["wrong_s"] = trial.wrong_seconds;
  json["uninformative_s"] = trial.uninformative_seconds;
  json["ended_uninformative"] = trial.ended_uninformative;
  json["confidences"] = confidences_as_json(trial.confidences);
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
      add_measurements(json, trial);
      text.append(text.empty() ? "[\n" : ",\n").append(json.dump());
    }
  }
  return (text.empty() ? "[" : text + "\n") + "]\n";
}

}  // namespace reorient
