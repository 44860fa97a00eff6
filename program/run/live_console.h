// Commands that a person types while the robot runs: to tune parameters and to see how the behaviours are doing.
#pragma once

#include <functional>
#include <iosfwd>
#include <string>
#include <string_view>
#include <vector>

#include "workbench/run/observer.h"
#include "workbench/run/run_loop.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {

/// Reads lines from a file descriptor without ever blocking. An empty line opens the prompt, so that the progress line
/// leaves the terminal to the typing; the next empty one closes it. What is set enters the next frame; what became of
/// it, and how everybody is doing, is read from that frame's record.
class LiveConsole : public InputSource, public Observer {
 public:
  /// `scenario` may be nullptr; `parameters`: all that there are.
  LiveConsole(int descriptor, std::ostream& out, ScenarioHost* scenario,
              std::function<std::vector<Parameter>()> parameters);

  /// Takes what was typed since the last call.
  void add_to(FrameInputs& inputs) override;
  void observe(const FrameRecord& frame, const StageRecord& stage) override;
  Topics wanted() const override { return {Topic::costs}; }

  bool is_open() const { return open_; }
  bool wants_to_quit() const { return quit_; }

 private:
  bool has_input() const;
  void take_line(std::string_view line, FrameInputs& inputs);
  /// What to tell at once, possibly several lines. A mistake in the line is told, not thrown.
  std::string obey(std::string_view line, const std::vector<std::string>& words, FrameInputs& inputs);
  void set(const std::string& name, const std::string& value, FrameInputs& inputs);

  int descriptor_;
  std::ostream& out_;
  ScenarioHost* scenario_;
  std::function<std::vector<Parameter>()> parameters_;
  std::string typed_;      ///< the line so far
  bool too_long_ = false;  ///< the rest of an endless line is dropped
  bool open_ = false;
  bool quit_ = false;
  bool ended_ = false;              ///< nobody can type there any more: no terminal
  bool wants_states_ = false;       ///< in the next record
  std::vector<std::string> asked_;  ///< parameters whose fate the next record tells
};

}  // namespace reorient
