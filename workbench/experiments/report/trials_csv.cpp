#include "workbench/experiments/report/trials_csv.h"

#include <array>
#include <charconv>
#include <string_view>

#include "engine/parameters/utf8.h"
#include "engine/world/commands.h"

namespace reorient {
namespace {

/// The shortest text that is this number again.
std::string shortest(double value) {
  std::array<char, 32> text{};
  return {text.data(), std::to_chars(text.data(), text.data() + text.size(), value).ptr};
}
std::string shortest(const std::optional<double>& value) { return value ? shortest(*value) : ""; }

std::string yes_or_no(bool yes) { return yes ? "true" : "false"; }

std::string field(std::string_view text) {
  std::string clean = as_line(text);
  if (clean.find_first_of(",\"") == std::string::npos) return clean;
  std::string quoted = "\"";
  for (const char letter : clean) quoted += letter == '"' ? std::string("\"\"") : std::string(1, letter);
  return quoted + '"';
}

void add_line(std::string& text, const std::vector<std::string>& fields) {
  for (std::size_t i = 0; i < fields.size(); ++i) text.append(i == 0 ? "" : ",").append(field(fields[i]));
  text += "\r\n";
}

}  // namespace

std::string trials_as_csv(const Report& report) {
  std::vector<std::string> line;
  for (const Axis& axis : report.experiment.axes) line.push_back(axis.name);
  for (const char* name : {"task",         "seed",          "started",        "disturbed",       "failed",
                           "measured_s",   "right_after_s", "mended_after_s", "mended_by",       "usable_after_s",
                           "kidnapped",    "flips",         "purges",         "resets",          "false_flips",
                           "false_purges", "right_s",       "wrong_s",        "uninformative_s", "ended_uninformative"})
    line.emplace_back(name);
  std::string text;
  add_line(text, line);
  int task = 0;
  for (const CellResults& cell : report.cells) {
    for (const TrialResult& trial : cell.trials) {
      line = cell.choices;
      for (std::string value : {std::to_string(++task),
                                std::to_string(trial.seed),
                                yes_or_no(trial.started),
                                yes_or_no(trial.disturbed()),
                                yes_or_no(trial.failed()),
                                shortest(trial.seconds),
                                shortest(trial.right_after),
                                shortest(trial.mended_after),
                                std::string(trial.mended_by ? to_string(*trial.mended_by) : ""),
                                shortest(trial.usable_after),
                                yes_or_no(trial.kidnapped),
                                std::to_string(trial.flips),
                                std::to_string(trial.purges),
                                std::to_string(trial.resets),
                                std::to_string(trial.false_flips),
                                std::to_string(trial.false_purges),
                                shortest(trial.right_seconds),
                                shortest(trial.wrong_seconds),
                                shortest(trial.uninformative_seconds),
                                yes_or_no(trial.ended_uninformative)})
        line.push_back(std::move(value));
      add_line(text, line);
    }
  }
  return text;
}

}  // namespace reorient
