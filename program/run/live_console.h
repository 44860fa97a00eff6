// Commands that a person types while the robot runs: to tune parameters and to see how the behaviours are doing.
#pragma once

#include <iosfwd>
#include <string>
#include <string_view>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/script_host.h"

namespace reorient {

/// Does what one line says and returns what to tell, possibly several lines. A mistake in the line is told, not thrown.
std::string obey_line(std::string_view line, ParameterRegistry& parameters, const ScriptHost& scripts);

/// Reads lines from a file descriptor without ever blocking. An empty line opens the prompt, so that the progress line
/// leaves the terminal to the typing; the next empty one closes it.
class LiveConsole {
 public:
  explicit LiveConsole(int descriptor);

  /// Takes what was typed since the last call.
  void poll(ParameterRegistry& parameters, const ScriptHost& scripts, std::ostream& out);

  bool is_open() const { return open_; }
  bool wants_to_quit() const { return quit_; }

 private:
  bool has_input() const;
  void take_line(std::string_view line, ParameterRegistry& parameters, const ScriptHost& scripts, std::ostream& out);

  int descriptor_;
  std::string typed_;      ///< the line so far
  bool too_long_ = false;  ///< the rest of an endless line is dropped
  bool open_ = false;
  bool quit_ = false;
  bool ended_ = false;  ///< nobody types there any more
};

}  // namespace reorient
