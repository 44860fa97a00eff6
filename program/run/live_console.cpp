#include "program/run/live_console.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <ostream>
#include <sstream>
#include <utility>

#include <poll.h>
#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include "engine/parameters/nearest_name.h"
#include "workbench/files/parameter_file.h"

namespace reorient {
namespace {

constexpr std::size_t kLongestLine = 1000;

constexpr const char* kHelp =
    "  set NAME VALUE   change a parameter, as in: set orientation.lead 0.3\n"
    "  params [FILTER]  parameters whose name contains FILTER, with value, range and origin\n"
    "  states           every behaviour with its state and what it costs\n"
    "  save FILE        write what differs from the defaults, to be loaded with --params FILE\n"
    "  quit             end the run\n"
    "  (an empty line)  back to the progress line\n";

std::vector<std::string> words_of(std::string_view line) {
  std::istringstream in{std::string(line)};
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

std::string parameters_text(const std::vector<Parameter>& parameters, const std::string& filter) {
  std::string text;
  for (const Parameter& parameter : parameters) {
    if (parameter.name.find(filter) == std::string::npos) continue;
    text += fmt::format("  {} = {}  ({}; {}) {}\n", parameter.name, to_text(parameter.value), range_text(parameter),
                        to_string(parameter.origin), parameter.description);
  }
  return text.empty() ? "  no parameter has '" + filter + "' in its name\n" : text;
}

std::string state_text(const std::string& name, const std::string& state, double since, bool stopped) {
  return fmt::format("  {:<22} {:<24} for {:6.1f} s{}", name, state, since, stopped ? "  stopped after errors" : "");
}

std::string states_text(const FrameRecord& frame, const StageRecord& stage) {
  std::string text;
  const double now = frame.world.time;
  for (std::size_t i = 0; i < frame.machines.size(); ++i) {
    const MachineStatus& status = frame.machines[i];
    text += state_text(frame.name(status.machine), frame.name(status.state), now - status.entered_at, status.stopped);
    if (i < frame.costs.machines.size()) {
      const MachineCost& cost = frame.costs.machines[i];
      text += fmt::format("  {:5.1f} us, {:4} KiB", cost.microseconds, cost.memory / 1024);
    }
    text += "\n";
  }
  for (const MachineStatus& status : stage.scenario.machines) {
    text += state_text(stage.scenario.name(status.machine), stage.scenario.name(status.state), now - status.entered_at,
                       status.stopped) +
            "\n";
  }
  return text;
}

}  // namespace

LiveConsole::LiveConsole(int descriptor, std::ostream& out, ScenarioHost* scenario,
                         std::function<std::vector<Parameter>()> parameters)
    : descriptor_(descriptor), out_(out), scenario_(scenario), parameters_(std::move(parameters)) {}

/// Reading the terminal of another process group would stop this one: a run in the background must not.
bool LiveConsole::has_input() const {
  if (isatty(descriptor_) == 1 && tcgetpgrp(descriptor_) != getpgrp()) return false;
  pollfd waiting{descriptor_, POLLIN, 0};
  return ::poll(&waiting, 1, 0) == 1 && (waiting.revents & (POLLIN | POLLHUP)) != 0;
}

void LiveConsole::add_to(FrameInputs& inputs) {
  // One read a frame: whatever pours in, the robot goes on.
  if (ended_ || quit_ || !has_input()) return;
  std::array<char, 4096> buffer;
  const ssize_t count = read(descriptor_, buffer.data(), buffer.size());
  if (count == 0 && isatty(descriptor_) == 1) {  // Ctrl-D
    if (std::exchange(open_, false)) out_ << std::endl;
    return;
  }
  if (count <= 0) {
    ended_ = count == 0 || (errno != EAGAIN && errno != EINTR);
    return;
  }
  for (const char letter : std::string_view(buffer.data(), static_cast<std::size_t>(count))) {
    if (letter != '\n') {
      if (typed_.size() < kLongestLine) {
        typed_ += letter;
      } else {
        too_long_ = true;
      }
      continue;
    }
    if (too_long_) {
      out_ << "  that line is too long\n";
    } else {
      take_line(typed_, inputs);
    }
    typed_.clear();
    too_long_ = false;
  }
  out_.flush();
}

void LiveConsole::take_line(std::string_view line, FrameInputs& inputs) {
  const std::vector<std::string> words = words_of(line);
  if (words.empty()) {
    open_ = !open_;
    out_ << (open_ ? "> " : "\n");
    return;
  }
  if (words.front() == "quit") {
    quit_ = true;
    return;
  }
  out_ << obey(line, words, inputs);
  const bool answer_follows = wants_states_ || !asked_.empty();
  if (open_ && !answer_follows) out_ << "> ";
}

std::string LiveConsole::obey(std::string_view line, const std::vector<std::string>& words, FrameInputs& inputs) {
  try {
    if (words[0] == "set" && words.size() == 3) {
      set(words[1], words[2], inputs);
      return {};
    }
    if (words[0] == "set") return "  write: set NAME VALUE\n";
    if (words[0] == "params" && words.size() <= 2)
      return parameters_text(parameters_(), words.size() == 2 ? words[1] : "");
    if (words[0] == "states" && words.size() == 1) {
      wants_states_ = true;
      return {};
    }
    if (words[0] == "save" && words.size() == 2) {
      save_parameters(parameters_(), {}, words[1]);
      return "  written; --params " + words[1] + " loads it\n";
    }
    if (words[0] == "save") return "  write: save FILE\n";
    if (words[0] == "help") return kHelp;
  } catch (const std::exception& error) {
    return std::string("  ") + error.what() + "\n";
  }
  const std::vector<std::string> known{"set", "params", "states", "save", "quit", "help"};
  return "  there is no command '" + std::string(line) + "'" + did_you_mean(words[0], known) + "; help lists them\n";
}

/// A library's parameter may belong to behaviours and to the scenario: both get it.
void LiveConsole::set(const std::string& name, const std::string& value, FrameInputs& inputs) {
  const ParameterChange change{name, value, ParameterOrigin::live, ""};
  std::vector<std::string> names;
  for (const Parameter& parameter : parameters_()) names.push_back(parameter.name);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    throw std::runtime_error("there is no parameter '" + name + "'" + did_you_mean(name, names));
  }
  if (scenario_ != nullptr) {
    if (const std::optional<ParameterOutcome> outcome = scenario_->change(change)) {
      out_ << "  " << (outcome->refusal.empty() ? name + " = " + outcome->value : outcome->refusal) << "\n";
      inputs.parameter_changes.push_back(change);  // told once; the engine may not even have it
      return;
    }
  }
  asked_.push_back(name);
  inputs.parameter_changes.push_back(change);
}

void LiveConsole::observe(const FrameRecord& frame, const StageRecord& stage) {
  if (asked_.empty() && !wants_states_) return;
  for (const std::string& name : asked_) {
    for (const ParameterOutcome& outcome : frame.parameter_changes) {
      if (outcome.name != name) continue;
      const bool is_fixed = outcome.value.empty();
      out_ << "  "
           << (is_fixed                  ? name + " is fixed while the robot runs; give it with --set"
               : outcome.refusal.empty() ? name + " = " + outcome.value
                                         : outcome.refusal)
           << "\n";
      break;
    }
  }
  asked_.clear();
  if (wants_states_) out_ << states_text(frame, stage);
  wants_states_ = false;
  if (open_) out_ << "> ";
  out_.flush();
}

}  // namespace reorient
