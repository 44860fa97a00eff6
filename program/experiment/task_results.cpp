#include "program/experiment/task_results.h"

#include <stdexcept>

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "engine/script/script_texts.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

using nlohmann::ordered_json;

template <typename Value>
ordered_json or_null(const std::optional<Value>& value) {
  return value ? ordered_json(*value) : ordered_json();
}

template <typename Value>
std::optional<Value> optional_at(const ordered_json& json, const char* key) {
  const ordered_json& value = json.at(key);
  return value.is_null() ? std::nullopt : std::optional(value.get<Value>());
}

/// An enumeration from its number. Throws std::out_of_range.
template <typename Enum>
Enum enum_at(const ordered_json& json) {
  const int number = json.get<int>();
  if (number < 0 || number >= enum_count(Enum())) throw std::out_of_range("a number that names nothing");
  return static_cast<Enum>(number);
}

ordered_json to_json(const TrialResult& result) {
  ordered_json json{
      {"seed", result.seed},
      {"started", result.started},
      {"seconds", result.seconds},
      {"correct_at_start", result.correct_at_start},
      {"right_after", or_null(result.right_after)},
      {"mended_after", or_null(result.mended_after)},
      {"mended_by", nullptr},
      {"flips", result.flips},
      {"purges", result.purges},
      {"resets", result.resets},
      {"false_flips", result.false_flips},
      {"false_purges", result.false_purges},
      {"right_seconds", result.right_seconds},
      {"wrong_seconds", result.wrong_seconds},
      {"uninformative_seconds", result.uninformative_seconds},
      {"ended_uninformative", result.ended_uninformative},
      {"confidences", ordered_json::array()},
  };
  if (result.mended_by) json["mended_by"] = static_cast<int>(*result.mended_by);
  for (const ConfidenceSample& sample : result.confidences)
    json["confidences"].push_back(
        {sample.time, sample.current, sample.opposite, static_cast<int>(sample.status), sample.correct});
  return json;
}

TrialResult result_from(const ordered_json& json) {
  TrialResult result;
  json.at("seed").get_to(result.seed);
  json.at("started").get_to(result.started);
  json.at("seconds").get_to(result.seconds);
  json.at("correct_at_start").get_to(result.correct_at_start);
  result.right_after = optional_at<double>(json, "right_after");
  result.mended_after = optional_at<double>(json, "mended_after");
  if (!json.at("mended_by").is_null()) result.mended_by = enum_at<Reorientation>(json.at("mended_by"));
  json.at("flips").get_to(result.flips);
  json.at("purges").get_to(result.purges);
  json.at("resets").get_to(result.resets);
  json.at("false_flips").get_to(result.false_flips);
  json.at("false_purges").get_to(result.false_purges);
  json.at("right_seconds").get_to(result.right_seconds);
  json.at("wrong_seconds").get_to(result.wrong_seconds);
  json.at("uninformative_seconds").get_to(result.uninformative_seconds);
  json.at("ended_uninformative").get_to(result.ended_uninformative);
  for (const ordered_json& sample : json.at("confidences"))
    result.confidences.push_back({sample.at(0).get<double>(), sample.at(1).get<double>(), sample.at(2).get<double>(),
                                  enum_at<RoomStatus>(sample.at(3)), sample.at(4).get<bool>()});
  return result;
}

std::string hexadecimal(std::uint64_t number) { return fmt::format("{:016x}", number); }

/// A bit that fell over on a disk leaves a number that looks like any other.
std::string checksum(const ordered_json& result) { return hexadecimal(content_hash(result.dump())); }

}  // namespace

std::filesystem::path TaskResults::file_of(int task) const { return folder_ / fmt::format("{:06}.json", task); }

void TaskResults::write(int task, std::uint64_t origin, const TrialResult& result) const {
  std::error_code error;
  std::filesystem::create_directories(folder_, error);  // where that fails, writing tells
  const ordered_json content = to_json(result);
  const ordered_json json{
      {"task", task}, {"origin", hexadecimal(origin)}, {"checksum", checksum(content)}, {"result", content}};
  write_whole_file(file_of(task), json.dump() + '\n');
}

std::optional<TrialResult> TaskResults::read(int task, std::uint64_t origin) const {
  const std::filesystem::path file = file_of(task);
  std::error_code error;
  if (!std::filesystem::exists(file, error)) return std::nullopt;
  const std::optional<std::string> text = read_whole_file(file);
  if (!text) throw std::runtime_error(file.string() + ": it cannot be read; check its permissions");
  try {
    const ordered_json json = ordered_json::parse(*text);
    if (json.at("checksum").get<std::string>() != checksum(json.at("result")))
      throw std::out_of_range("the numbers are not those that were written");
    if (json.at("task").get<int>() != task || json.at("origin").get<std::string>() != hexadecimal(origin))
      throw std::runtime_error(file.string() +
                               ": the result of another trial (other scripts, files, parameters or options, or "
                               "another program); choose another --out, or remove the folder");
    return result_from(json.at("result"));
  } catch (const nlohmann::json::exception&) {
  } catch (const std::out_of_range&) {
  }
  throw std::runtime_error(file.string() + ": this is no task's result; remove the file, and the task runs again");
}

}  // namespace reorient
