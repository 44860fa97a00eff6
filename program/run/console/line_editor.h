// SPDX-License-Identifier: MIT
// A line that is edited at a terminal while the run goes on: libedit, fed key by key.
#pragma once

#include <filesystem>
#include <functional>
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
  /// What the next word may be, behind these.
  using Candidates = std::function<Words(const Words& before)>;

  /// Reads `descriptor` and writes to the standard output, which are one terminal. The locale must be one of UTF-8.
  /// `history`: file with the lines of earlier runs; nothing: no history.
  LineEditor(int descriptor, Candidates candidates, std::optional<std::filesystem::path> history);
  ~LineEditor();
  LineEditor(const LineEditor&) = delete;
  LineEditor& operator=(const LineEditor&) = delete;

  /// Whether lines can be edited there at all.
  static bool is_possible(int descriptor);

  /// Takes what was typed since the last call, up to the end of a line. Never blocks.
  Typed poll();

  /// The prompt with what is typed so far; a new line where the last one was ended.
  void show();
  /// Leaves its place on the screen to others, until it is shown again.
  void hide();
  /// The terminal as it was before; what is typed so far is forgotten.
  void close();

  /// Adds what was typed to the file. Throws nothing: what goes wrong is told in the log.
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
  Candidates candidates_;
  std::optional<std::filesystem::path> history_file_;
  Words typed_;  ///< lines of this run
  std::unique_ptr<History, void (*)(History*)> history_;
  std::unique_ptr<EditLine, void (*)(EditLine*)> editor_;
  std::optional<TerminalGuard> guard_;  ///< while the terminal is ours
  Line line_ = Line::none;
  KeyQueue keys_;
  int late_ = 0;         ///< for how many calls the rest of a key has not come
  std::string key_;      ///< what libedit has not yet read of the key that it is told now
  std::string listing_;  ///< names to be shown above the line
  int columns_ = 80;
};

}  // namespace reorient
