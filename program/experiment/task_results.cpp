// SPDX-License-Identifier: MIT
#include "program/experiment/task_results.h"

#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/parameters/utf8.h"
#include "engine/script/script_texts.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/input_file.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

template <typename Value>
ordered_json as_json(const Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    return static_cast<int>(value);
  } else {
    return value;
  }
}
template <typename Value>
ordered_json as_json(const std::optional<Value>& value) {
  return value ? as_json(*value) : ordered_json();
}

/// Throws nlohmann::json::exception or, if a number is not an enumerator, std::out_of_range.
template <typename Value>
void read_value(const ordered_json& json, Value& value) {
  if constexpr (std::is_enum_v<Value>) {
    const int number = json.get<int>();
    if (number < 0 || number >= enum_count(Value())) throw std::out_of_range("a number out of range");
    value = static_cast<Value>(number);
  } else {
    json.get_to(value);
  }
}
template <typename Value>
void read_value(const ordered_json& json, std::optional<Value>& value) {
  value.reset();
  if (!json.is_null()) read_value(json, value.emplace());
}

ordered_json to_json(const PoseErrors& errors) {
  ordered_json json;
  visit_named_errors([&json](const char* name, const auto& value) { json[name] = as_json(value); }, errors);
  json["recoveries"] = ordered_json::array();
  for (const FallRecovery& recovery : errors.recoveries) {
    ordered_json values;
    visit_recovery([&values](const auto& value) { values.push_back(as_json(value)); }, recovery);
    json["recoveries"].push_back(std::move(values));
  }
  return json;
}

PoseErrors errors_from(const ordered_json& json) {
  PoseErrors errors;
  visit_named_errors([&json](const char* name, auto& value) { read_value(json.at(name), value); }, errors);
  for (const ordered_json& values : json.at("recoveries")) {
    std::size_t i = 0;
    visit_recovery([&](auto& value) { read_value(values.at(i++), value); }, errors.recoveries.emplace_back());
  }
  return errors;
}

ordered_json to_json(const TrialResult& result) {
  ordered_json json;
  visit_named_values([&json](const char* name, const auto& value) { json[name] = as_json(value); }, result);
  json["confidences"] = ordered_json::array();
  for (const ConfidenceSample& sample : result.confidences) {
    ordered_json values;
    visit_values([&values](const auto& value) { values.push_back(as_json(value)); }, sample);
    json["confidences"].push_back(std::move(values));
  }
  json["looks"] = ordered_json::array();
  for (const CompassLook& look : result.looks) {
    ordered_json values;
    visit_scores([&values](double score) { values.push_back(score); }, look);
    json["looks"].push_back(std::move(values));
  }
  json["pose_errors"] = result.pose_errors ? to_json(*result.pose_errors) : ordered_json();
  json["measures"] = ordered_json::array();
  for (const std::optional<double>& value : result.measures) json["measures"].push_back(as_json(value));
  return json;
}

TrialResult result_from(const ordered_json& json) {
  TrialResult result;
  visit_named_values([&json](const char* name, auto& value) { read_value(json.at(name), value); }, result);
  for (const ordered_json& values : json.at("confidences")) {
    std::size_t i = 0;
    visit_values([&](auto& value) { read_value(values.at(i++), value); }, result.confidences.emplace_back());
  }
  for (const ordered_json& values : json.at("looks")) {
    std::size_t i = 0;
    visit_scores([&](double& score) { read_value(values.at(i++), score); }, result.looks.emplace_back());
  }
  if (json.contains("measures")) {  // results of earlier programs have none
    for (const ordered_json& value : json.at("measures")) read_value(value, result.measures.emplace_back());
  }
  if (const ordered_json& errors = json.at("pose_errors"); !errors.is_null()) result.pose_errors = errors_from(errors);
  return result;
}

std::string hexadecimal(std::uint64_t number) { return fmt::format("{:016x}", number); }

/// The values that differ between the origin of a result in a file and the expected one, each with both values.
std::string differences(const Origin& found, const Origin& expected) {
  Origin all = found;
  all.insert(expected.begin(), expected.end());
  const auto value_in = [](const Origin& origin, const std::string& name) {
    const auto value = origin.find(name);
    return value == origin.end() ? "none" : value->second;
  };
  const auto shown = [](const std::string& value) {
    constexpr std::size_t kShown = 40;
    return as_line(value.substr(0, kShown));
  };
  constexpr std::size_t kMost = 3;
  std::string list;
  std::size_t count = 0;
  for (const auto& [name, value] : all) {
    const std::string there = value_in(found, name), here = value_in(expected, name);
    if (there == here || ++count > kMost) continue;
    list += fmt::format("{}{} ({} instead of {})", count > 1 ? ", " : "", as_line(name), shown(there), shown(here));
  }
  return count > kMost ? fmt::format("{} and {} more", list, count - kMost) : list;
}

/// Detects a flipped bit on the disk, after which a number would still look valid.
std::string checksum(const ordered_json& result) { return hexadecimal(content_hash(result.dump())); }

}  // namespace

std::filesystem::path TaskResults::file_of(int task) const { return folder_ / fmt::format("{:06}.json", task); }

void TaskResults::write(int task, const Origin& origin, const TrialResult& result) const {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);  // if that fails, writing reports it
  const ordered_json content = to_json(result);
  const ordered_json json{{"task", task}, {"origin", origin}, {"checksum", checksum(content)}, {"result", content}};
  write_whole_file(file_of(task), json.dump() + '\n');
}

std::optional<TrialResult> TaskResults::read(int task, const Origin& origin) const {
  const std::filesystem::path file = file_of(task);
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  const std::string text = read_named_input(file, "the result of a trial");
  try {
    const ordered_json json = ordered_json::parse(text);
    if (json.at("checksum").get<std::string>() != checksum(json.at("result")))
      throw std::out_of_range("the checksum does not match");
    const auto found_task = json.at("task").get<int>();
    const auto found = json.at("origin").get<Origin>();
    if (found_task != task || found != origin)
      throw std::runtime_error(as_line(
          file.string() + ": expected the result of this trial, found that of another: " +
          (found_task != task ? fmt::format("task {} instead of {}", found_task, task) : differences(found, origin)) +
          "; choose another --out, or remove the folder"));
    return result_from(json.at("result"));
  } catch (const nlohmann::json::exception&) {
  } catch (const std::out_of_range&) {
  }
  throw std::runtime_error(
      file.string() +
      ": expected the result of a task, found other or damaged content; remove the file, and the task runs again");
}

}  // namespace reorient
