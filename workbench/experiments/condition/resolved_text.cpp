// SPDX-License-Identifier: MIT
#include "workbench/experiments/condition/resolved_text.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <set>
#include <string_view>
#include <utility>

namespace reorient {
namespace {

std::string toml_text(std::string_view text) {
  constexpr std::string_view kDigits = "0123456789ABCDEF";
  std::string in_quotes = "\"";
  for (const char letter : text) {
    const auto byte = static_cast<unsigned char>(letter);
    if (letter == '"' || letter == '\\') {
      in_quotes += std::string("\\") + letter;
    } else if (byte < 0x20 || byte == 0x7f) {
      in_quotes += std::string("\\u00") + kDigits[byte / 16] + kDigits[byte % 16];
    } else {
      in_quotes += letter;
    }
  }
  return in_quotes + "\"";
}

std::string toml_text(const std::vector<std::string>& texts) {
  std::string list;
  for (const std::string& text : texts) list += (list.empty() ? "" : ", ") + toml_text(text);
  return "[" + list + "]";
}

std::string toml_number(double value) { return to_text(ParameterValue(value)); }
const char* toml_yes(bool yes) { return yes ? "true" : "false"; }

/// A key that needs no quotes, otherwise with them.
std::string toml_key(std::string_view name) {
  const bool is_bare = !name.empty() && std::all_of(name.begin(), name.end(), [](char letter) {
    return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') || (letter >= '0' && letter <= '9') ||
           letter == '_' || letter == '-';
  });
  return is_bare ? std::string(name) : toml_text(name);
}

/// A number, true or false as it is, a name in quotes.
std::string toml_value(const std::string& value) {
  double parsed = 0.0;
  const auto [end, error] = std::from_chars(value.data(), value.data() + value.size(), parsed);
  const bool is_number = error == std::errc() && end == value.data() + value.size() && !value.empty() &&
                         value.find_first_not_of("0123456789+-.eE") == std::string::npos;
  return is_number || value == "true" || value == "false" ? value : toml_text(value);
}

/// The settings of a patch by their keys, in the order of the documentation; lists grow.
class Settings {
 public:
  void add(const ConditionPatch& patch) {
    for (const ConditionPatch& first : patch.first) add(first);
    const auto set = [&](const char* key, const auto& value, auto&& text) {
      if (value) values_[key] = text(*value);
    };
    const auto text = [](const std::string& value) { return toml_text(value); };
    const auto join = [](std::vector<std::string>& all, const std::vector<std::string>& more) {
      all.insert(all.end(), more.begin(), more.end());
    };
    set("scenario", patch.scenario, text);
    join(lists_["with"], patch.with);
    join(lists_["without"], patch.without);
    join(lists_["params"], patch.parameter_files);
    for (const ParameterChange& change : patch.parameters) parameters_[change.name] = change.value;
    set("room", patch.room, text);
    set("hall_seed", patch.hall_seed, [](std::uint64_t value) { return std::to_string(value); });
    set("field", patch.field, text);
    set("interface", patch.interface, text);
    set("body", patch.body, text);
    set("cameras", patch.cameras, text);
    set("width", patch.width, [](int value) { return std::to_string(value); });
    set("room_awareness", patch.room_awareness, toml_yes);
    set("seconds", patch.seconds, toml_number);
    set("learned_before", patch.learned_before, toml_number);
    set("compasses", patch.compasses, toml_yes);
    set("pose_errors", patch.pose_errors, toml_yes);
    set("measured_from", patch.measured_from, text);
    set("limit", patch.limit, toml_number);
    set("hold", patch.hold, toml_number);
    set("to_the_end", patch.to_the_end, toml_yes);
    set("symmetric_room", patch.symmetric_room, toml_yes);
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (const auto& [key, list] : lists_) {
      if (!list.empty()) lines.push_back(std::string(key) + " = " + toml_text(list));
    }
    for (const auto& [key, value] : values_) {
      // An empty name, of the built-in hall, cannot be written in a file.
      lines.push_back((value == "\"\"" ? "# " : "") + std::string(key) + " = " + value);
    }
    for (const auto& [name, value] : parameters_) {
      const std::size_t dot = name.find('.');
      lines.push_back("parameters." + toml_key(name.substr(0, dot)) + "." +
                      toml_key(name.substr(std::min(name.size(), dot + 1))) + " = " + toml_value(value));
    }
    return lines;
  }

 private:
  std::map<std::string_view, std::string> values_;
  std::map<std::string_view, std::vector<std::string>> lists_;
  std::map<std::string, std::string> parameters_;
};

void write_settings(std::string& text, const ConditionPatch& patch) {
  for (const std::string& line : settings_of(patch)) text += line + "\n";
}

void write_named(std::string& text, const std::string& name, const std::string& description) {
  text += "name = " + toml_text(name) + "\n";
  if (!description.empty()) text += "description = " + toml_text(description) + "\n";
}

void write_measures(std::string& text, const std::vector<Measure>& measures) {
  if (measures.empty()) return;
  text += "\n[measure]\n";
  for (int i = 0; i < enum_count(MeasureType()); ++i) {
    const auto type = static_cast<MeasureType>(i);
    std::vector<std::string> names;
    for (const Measure& measure : measures) {
      if (measure.type == type) names.push_back(measure.name);
    }
    if (!names.empty()) text.append(to_string(type)).append(" = ").append(toml_text(names)).append("\n");
  }
}

}  // namespace

std::vector<std::string> settings_of(const ConditionPatch& patch) {
  Settings settings;
  settings.add(patch);
  return settings.lines();
}

std::string resolved_text(const Experiment& experiment) {
  std::string text = "title = " + toml_text(experiment.title) + "\n";
  if (!experiment.description.empty()) text += "description = " + toml_text(experiment.description) + "\n";
  text += "trials = " + std::to_string(experiment.trials) + "\n";
  text += std::string("times = ") + (experiment.times == TimeOf::command ? "\"command\"" : "\"belief\"") + "\n";
  text += "\n[condition]\n";
  write_settings(text, experiment.base);
  for (const ConditionPatch& alternate : experiment.alternates) {
    text += "\n[[alternate]]\n";
    write_settings(text, alternate);
  }
  for (const Axis& axis : experiment.axes) {
    text += "\n[[axis]]\n";
    write_named(text, axis.name, axis.description);
    for (const AxisChoice& choice : axis.choices) {
      text += "[[axis.choice]]\n";
      write_named(text, choice.name, choice.description);
      write_settings(text, choice.patch);
    }
  }
  write_measures(text, experiment.measures);
  const std::vector<std::string> overrides = settings_of(experiment.overrides);
  if (!overrides.empty()) text += "\n# The command line overrides all of this:\n";
  for (const std::string& line : overrides) text += (line.starts_with('#') ? "" : "# ") + line + "\n";
  return text;
}

}  // namespace reorient
