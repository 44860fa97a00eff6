#include "program/run/live_console.h"

#include <algorithm>
#include <array>
#include <cerrno>
#include <ostream>
#include <sstream>
#include <vector>

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
    "  params [PART]    parameters whose name contains PART, with value, range and origin\n"
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

std::string parameters_text(const ParameterRegistry& parameters, const std::string& part) {
  std::string text;
  for (const Parameter& parameter : parameters.list()) {
    if (parameter.name.find(part) == std::string::npos) continue;
    text += fmt::format("  {} = {}  ({}; {}) {}\n", parameter.name, to_text(parameter.value), range_text(parameter),
                        to_string(parameter.origin), parameter.description);
  }
  return text.empty() ? "  no parameter has '" + part + "' in its name\n" : text;
}

std::string states_text(const ScriptHost& scripts) {
  std::string text;
  for (const MachineStatus& machine : scripts.machines()) {
    text += fmt::format("  {:<22} {:<24} for {:6.1f} s  {:5.1f} us, {:4} KiB{}\n", machine.name, machine.state,
                        machine.time_in_state, machine.microseconds, machine.memory / 1024,
                        machine.stopped ? "  stopped: " + machine.last_error : "");
  }
  return text;
}

}  // namespace

std::string obey_line(std::string_view line, ParameterRegistry& parameters, const ScriptHost& scripts) {
  const std::vector<std::string> words = words_of(line);
  if (words.empty()) return {};
  try {
    if (words[0] == "set" && words.size() == 3) {
      parameters.set(words[1], words[2], ParameterOrigin::live);
      return "  " + words[1] + " = " + to_text(parameters.value(words[1])) + "\n";
    }
    if (words[0] == "set") return "  write: set NAME VALUE\n";
    if (words[0] == "params" && words.size() <= 2)
      return parameters_text(parameters, words.size() == 2 ? words[1] : "");
    if (words[0] == "states" && words.size() == 1) return states_text(scripts);
    if (words[0] == "save" && words.size() == 2) {
      save_parameters(parameters, words[1]);
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

LiveConsole::LiveConsole(int descriptor) : descriptor_(descriptor) {}

/// Reading the terminal of another process group would stop this one: a run in the background must not.
bool LiveConsole::has_input() const {
  if (isatty(descriptor_) == 1 && tcgetpgrp(descriptor_) != getpgrp()) return false;
  pollfd waiting{descriptor_, POLLIN, 0};
  return ::poll(&waiting, 1, 0) == 1 && (waiting.revents & (POLLIN | POLLHUP)) != 0;
}

void LiveConsole::poll(ParameterRegistry& parameters, const ScriptHost& scripts, std::ostream& out) {
  // One read a frame: whatever pours in, the robot goes on.
  if (ended_ || quit_ || !has_input()) return;
  std::array<char, 4096> buffer;
  const ssize_t count = read(descriptor_, buffer.data(), buffer.size());
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
      out << "  that line is too long\n";
    } else {
      take_line(typed_, parameters, scripts, out);
    }
    typed_.clear();
    too_long_ = false;
  }
  out.flush();
}

void LiveConsole::take_line(std::string_view line, ParameterRegistry& parameters, const ScriptHost& scripts,
                            std::ostream& out) {
  const std::vector<std::string> words = words_of(line);
  if (words.empty()) {
    open_ = !open_;
    out << (open_ ? "> " : "\n");
    return;
  }
  if (words.front() == "quit") {
    quit_ = true;
    return;
  }
  out << obey_line(line, parameters, scripts);
  if (open_) out << "> ";
}

}  // namespace reorient
