// SPDX-License-Identifier: MIT
// A line editor for a terminal during the run: libedit, fed key by key.
#pragma once

#include <cstdio>
#include <filesystem>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <histedit.h>

#include "program/run/console/command.h"
#include "program/run/console/key_queue.h"
#include "program/run/console/line_reader.h"
#include "program/terminal_guard.h"

namespace reorient {

class LineEditor {
 public:
  /// Completions for the next word after these.
  using Candidates = std::function<Words(const Words& before)>;

  /// Reads `descriptor` and writes to `out`, the standard output, which are one terminal. The locale must be one of
  /// UTF-8. `history`: file with the lines of earlier runs; nothing: no history.
  LineEditor(int descriptor, std::ostream& out, Candidates candidates, std::optional<std::filesystem::path> history);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// Whether lines can be edited on this terminal.
  static bool is_possible(int descriptor);

  /// Reads the input since the last call, up to the end of a line. Never blocks.
  Typed poll();

  /// Shows the prompt with the text typed so far; a new line if the last one was ended.
  void show();
  /// Clears its line on the screen, until it is shown again.
  void hide();
  /// Restores the terminal; the text typed so far is discarded.
  void close();

  /// Adds the typed lines to the file. Does not throw: errors go to the log.
  void save_history();

 private:
  enum class Line { none, shown, hidden };

  static LineEditor& of(EditLine* editor);
  static int next_letter(EditLine* editor, wchar_t* letter);
  static unsigned char complete_word(EditLine* editor, int key);

  void load_history();
  void remember(const std::string& line);
  void read_keys();
  void take_key(const std::string& key, Typed& typed);
  unsigned char complete();
  void list(const Words& names);
  void follow_size();

  int descriptor_;
  std::ostream& out_;
  std::unique_ptr<std::FILE, int (*)(std::FILE*)> out_file_;  ///< libedit's way to `out_`
  Candidates candidates_;
  std::optional<std::filesystem::path> history_file_;
  Words typed_;  ///< lines of this run
  std::unique_ptr<History, void (*)(History*)> history_;
  std::unique_ptr<EditLine, void (*)(EditLine*)> editor_;
  std::optional<TerminalGuard> guard_;  ///< while the prompt uses the terminal
  Line line_ = Line::none;
  KeyQueue keys_;
  int late_ = 0;         ///< number of calls without the rest of a key
  std::string key_;      ///< the part of the present key that libedit has not read yet
  std::string listing_;  ///< names to show above the line
  int columns_ = 80;
};

}  // namespace reorient
