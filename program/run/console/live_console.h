// SPDX-License-Identifier: MIT
// The prompt of a run: commands that the user types, or a program writes, while the robot continues.
#pragma once

#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

#include "program/run/console/command_table.h"
#include "program/run/console/line_editor.h"
#include "program/run/console/line_reader.h"
#include "workbench/run/observer.h"
#include "workbench/run/run_loop.h"

namespace reorient {

/// Executes at most one command per frame, without waiting. An empty line opens the prompt and hides the progress line;
/// the next empty line closes it. The changes of a command enter the next frame. Its answer is read from that frame's
/// record, before the next command is read. While the run is paused, a command that needs no frame is answered at once.
class LiveConsole : public InputSource, public Observer {
 public:
  /// Reads `descriptor`, answers on `out`. `history`: the file of lines from earlier runs, for a terminal.
  LiveConsole(int descriptor, std::ostream& out, ConsoleSubject subject,
              std::optional<std::filesystem::path> history = {});

  void add_to(FrameInputs& inputs) override;
  void add_while_paused(FrameInputs& inputs, const FrameRecord& last, const SceneTruth& scene) override;
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;
  void finish(const FrameRecord& last, const SceneTruth& scene) override;
  Topics wanted() const override;

  /// Executes a command that changes nothing, for another part of the program. Throws std::runtime_error with one line.
  Reply ask(const Words& words);

  /// Call instead of add_to() and observe() while no robot is connected: executes only `quit`.
  void poll_without_robot();

  bool is_open() const { return open_; }
  bool wants_to_quit() const { return table_.wants_to_quit(); }
  /// Call before another part of the program writes to the terminal.
  void make_room();
  /// Call before another part of the program writes a line to the same output.
  void begin_line();

 private:
  std::optional<std::string> next_line();
  void take_line(const std::string& line, FrameInputs& inputs);
  void open();
  void close();
  std::string reply(const FrameRecord& frame, const SceneTruth& scene);
  std::string late_replies(const FrameRecord& frame, const SceneTruth& scene);
  void print(const std::string& text);

  int descriptor_;
  std::ostream& out_;
  CommandTable table_;
  std::optional<std::filesystem::path> history_;
  LineReader lines_;
  std::optional<LineEditor> editor_;  ///< created when the prompt is first opened at a terminal
  Reply reply_;                       ///< the pending answer; empty: none
  std::vector<Reply> late_;           ///< answers to commands of a pause that wait for the next frame
  bool open_ = false;
  bool is_prompted_ = false;  ///< the prompt is the last text on `out`, without a line editor
};

}  // namespace reorient
