// SPDX-License-Identifier: MIT
#include "program/run/console/line_editor.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <cwchar>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string_view>
#include <utility>

#include <spdlog/spdlog.h>
#include <unistd.h>

#include "engine/parameters/utf8.h"
#include "program/program_output.h"
#include "program/run/console/history_file.h"

namespace reorient {
namespace {

constexpr const char* kPrompt = "> ";
constexpr int kPromptWidth = 2;
constexpr const char* kControlD = "\x04";

struct Binding {
  const char* keys;
  const char* command;  ///< of libedit
};

/// The sequences that terminals send for other keys than letters. Unknown sequences are dropped, because libedit would
/// insert their last characters. Commands of libedit that wait for another key are replaced or removed, because
/// nothing may block here.
constexpr Binding kBindings[] = {
    {"\x1B[A", "ed-prev-history"},      {"\x1BOA", "ed-prev-history"},       {"\x1B[B", "ed-next-history"},
    {"\x1BOB", "ed-next-history"},      {"\x1B[C", "ed-next-char"},          {"\x1BOC", "ed-next-char"},
    {"\x1B[D", "ed-prev-char"},         {"\x1BOD", "ed-prev-char"},          {"\x1B[H", "ed-move-to-beg"},
    {"\x1BOH", "ed-move-to-beg"},       {"\x1B[1~", "ed-move-to-beg"},       {"\x1B[7~", "ed-move-to-beg"},
    {"\x1B[F", "ed-move-to-end"},       {"\x1BOF", "ed-move-to-end"},        {"\x1B[4~", "ed-move-to-end"},
    {"\x1B[8~", "ed-move-to-end"},      {"\x1B[3~", "ed-delete-next-char"},  {"\x1B[1;5C", "em-next-word"},
    {"\x1B[1;5D", "ed-prev-word"},      {"\033f", "em-next-word"},           {"\033b", "ed-prev-word"},
    {"\033d", "em-delete-next-word"},   {"\x1B\x7F", "ed-delete-prev-word"}, {"\t", "reorient-complete"},
    {"\x12", "ed-search-prev-history"}, {"\x13", "ed-search-next-history"},  {"\x16", "ed-unassigned"},
    {"\x17", "ed-delete-prev-word"},    {"\x18", "ed-unassigned"},
};

std::set<std::string, std::less<>> bound_keys() {
  std::set<std::string, std::less<>> all;
  for (const Binding& binding : kBindings) all.insert(binding.keys);
  return all;
}

std::size_t line_length(EditLine* editor) {
  const LineInfoW& line = *el_wline(editor);
  return static_cast<std::size_t>(line.lastchar - line.buffer);
}

/// Height in rows of the terminal.
int rows_above_cursor(EditLine* editor, int columns) {
  const LineInfoW& line = *el_wline(editor);
  int width = kPromptWidth;
  for (const wchar_t* letter = line.buffer; letter != line.cursor; ++letter) {
    const int shown = ::wcwidth(*letter);
    width += shown < 0 ? 2 : shown;  // ^A
  }
  return width / columns;
}

/// A file that passes on to a stream what is written to it.
std::FILE* file_of(std::ostream& out) {
  constexpr cookie_io_functions_t kFunctions{nullptr,
                                             [](void* cookie, const char* text, std::size_t size) {
                                               print_control(*static_cast<std::ostream*>(cookie), {text, size});
                                               return static_cast<ssize_t>(size);
                                             },
                                             nullptr, nullptr};
  return fopencookie(&out, "w", kFunctions);
}

std::string common_beginning(const Words& words) {
  std::string common = words.front();
  for (const std::string& word : words) {
    const auto [end, other] = std::mismatch(common.begin(), common.end(), word.begin(), word.end());
    common.erase(end, common.end());
  }
  return common;
}

}  // namespace

bool LineEditor::is_possible(int descriptor) {
  // libedit allocates memory for each place on the terminal, so it must not see a size that no terminal has.
  const char* const terminal = std::getenv("TERM");
  const bool is_able = terminal != nullptr && *terminal != '\0' && std::string_view(terminal) != "dumb";
  return is_able && isatty(descriptor) == 1 && isatty(STDOUT_FILENO) == 1 && terminal_columns(descriptor) &&
         terminal_columns(STDOUT_FILENO);
}

LineEditor::LineEditor(int descriptor, std::ostream& out, Candidates candidates,
                       std::optional<std::filesystem::path> history)
    : descriptor_(descriptor),
      out_(out),
      out_file_(file_of(out), std::fclose),
      candidates_(std::move(candidates)),
      history_file_(std::move(history)),
      history_(history_init(), history_end),
      editor_(nullptr, el_end),
      keys_(bound_keys()) {
  if (out_file_)
    editor_.reset(el_init_fd("reorient", stdin, out_file_.get(), stderr, descriptor, STDOUT_FILENO, STDERR_FILENO));
  if (!editor_ || !history_) throw std::runtime_error("line editing is not possible on this terminal");
  HistEvent event;
  ::history(history_.get(), &event, H_SETSIZE, static_cast<int>(kMostHistory));
  ::history(history_.get(), &event, H_SETUNIQUE, 1);
  el_set(editor_.get(), EL_CLIENTDATA, this);
  el_set(editor_.get(), EL_EDITOR, "emacs");
  el_set(editor_.get(), EL_SIGNAL, 0);  // Interruption and TerminalGuard handle signals
  el_set(
      editor_.get(), EL_PROMPT, +[](EditLine*) { return const_cast<char*>(kPrompt); });
  el_set(editor_.get(), EL_HIST, ::history, history_.get());
  el_wset(editor_.get(), EL_GETCFN, &LineEditor::next_letter);
  // With narrow strings libedit would allocate wide strings and never free them.
  el_wset(editor_.get(), EL_ADDFN, L"reorient-complete", L"complete the word", &LineEditor::complete_word);
  for (const Binding& binding : kBindings) el_set(editor_.get(), EL_BIND, binding.keys, binding.command, nullptr);
  load_history();
}

LineEditor::~LineEditor() {
  close();
  // A process in the background must not set the terminal.
  if (!is_in_foreground(descriptor_)) static_cast<void>(editor_.release());
}

void LineEditor::load_history() {
  if (!history_file_) return;
  try {
    HistEvent event;
    for (const std::string& line : read_history(*history_file_))
      ::history(history_.get(), &event, H_ENTER, line.c_str());
  } catch (const std::exception& error) {
    spdlog::warn("the prompt keeps no history: {}", error.what());
    history_file_.reset();
  }
}

void LineEditor::save_history() {
  if (!history_file_ || typed_.empty()) return;
  try {
    append_history(*history_file_, typed_);
  } catch (const std::exception& error) {
    spdlog::warn("the prompt keeps no history: {}", error.what());
  }
  typed_.clear();
}

void LineEditor::remember(const std::string& line) {
  if (line.find_first_not_of(' ') == std::string::npos) return;
  HistEvent event;
  ::history(history_.get(), &event, H_ENTER, line.c_str());
  if (typed_.size() == kMostHistory) typed_.erase(typed_.begin());
  typed_.push_back(line);
}

LineEditor& LineEditor::of(EditLine* editor) {
  void* self = nullptr;
  el_get(editor, EL_CLIENTDATA, &self);
  return *static_cast<LineEditor*>(self);
}

/// Returns 0 without a key, which libedit treats as the end of the input.
int LineEditor::next_letter(EditLine* editor, wchar_t* letter) {
  std::string& key = of(editor).key_;
  std::mbstate_t state{};
  const std::size_t length = std::mbrtowc(letter, key.data(), key.size(), &state);
  if (key.empty() || length > key.size()) return 0;
  key.erase(0, std::max<std::size_t>(1, length));
  return 1;
}

Typed LineEditor::poll() {
  Typed typed;
  if (line_ == Line::none || !is_in_foreground(descriptor_)) return typed;
  if (TerminalGuard::came_back()) el_set(editor_.get(), EL_REFRESH);
  follow_size();
  if (keys_.empty() || late_ > 0) read_keys();
  while (!typed.line && !typed.closed) {
    const std::optional<std::string> key = keys_.next();
    if (!key) break;
    take_key(*key, typed);
  }
  return typed;
}

void LineEditor::read_keys() {
  if (has_input(descriptor_)) {
    std::array<char, 1024> buffer;
    const ssize_t count = read(descriptor_, buffer.data(), buffer.size());
    if (count > 0) keys_.add({buffer.data(), static_cast<std::size_t>(count)});
    late_ = 1;
  } else if (++late_ > 3) {  // frames; the bytes of one key arrive together
    keys_.drop_begun();
  }
  if (keys_.empty()) late_ = 0;
}

void LineEditor::take_key(const std::string& key, Typed& typed) {
  if (key == kControlD && line_length(editor_.get()) == 0) {
    typed.closed = true;
    return;
  }
  const bool is_text = static_cast<unsigned char>(key.front()) >= ' ' && key != "\x7F";
  if (is_text && line_length(editor_.get()) >= kLongestLine) return;
  key_ = key;
  int count = 0;
  const wchar_t* const letters = el_wgets(editor_.get(), &count);
  std::fflush(out_file_.get());
  key_.clear();
  if (letters != nullptr && count > 0 && letters[count - 1] == L'\n') {
    const LineInfo& line = *el_line(editor_.get());
    typed.line.emplace(line.buffer, line.lastchar - 1);
    remember(*typed.line);
    line_ = Line::none;
  }
  if (listing_.empty()) return;
  hide();
  out_ << std::exchange(listing_, {}) << std::flush;
  show();
}

unsigned char LineEditor::complete_word(EditLine* editor, int /*key*/) { return of(editor).complete(); }

unsigned char LineEditor::complete() {
  const LineInfo& line = *el_line(editor_.get());
  const std::string text(line.buffer, line.cursor);
  const std::size_t begin = text.find_last_of(' ') + 1;  // of npos: 0
  const std::string word = text.substr(begin);
  std::istringstream in(text.substr(0, begin));
  Words before, fitting;
  for (std::string one; in >> one;) before.push_back(one);
  try {
    fitting = candidates_(before);
  } catch (const std::exception&) {  // for example if the folder of scripts was removed
  }
  std::erase_if(fitting, [&](const std::string& name) { return !name.starts_with(word); });
  if (fitting.empty()) return CC_ERROR;
  std::string rest = common_beginning(fitting).substr(word.size());
  while (!is_utf8(rest)) rest.pop_back();  // if names differ within a letter
  if (fitting.size() == 1) rest += ' ';
  if (rest.empty()) {
    list(fitting);
    return CC_NORM;
  }
  return el_insertstr(editor_.get(), rest.c_str()) == 0 ? CC_REFRESH : CC_ERROR;
}

void LineEditor::list(const Words& names) {
  constexpr std::size_t kMost = 100;
  const std::size_t shown = std::min(names.size(), kMost);
  std::size_t width = 0;
  for (std::size_t i = 0; i < shown; ++i) width = std::max(width, names[i].size() + 2);
  const std::size_t in_a_row = std::max<std::size_t>(1, static_cast<std::size_t>(columns_) / width);
  for (std::size_t i = 0; i < shown; ++i) {
    const bool ends_row = (i + 1) % in_a_row == 0 || i + 1 == shown;
    const std::string name = as_line(names[i]);
    listing_ += ends_row ? name + "\n" : name + std::string(width - names[i].size(), ' ');
  }
  if (shown < names.size()) listing_ += "and " + std::to_string(names.size() - shown) + " more\n";
}

void LineEditor::follow_size() {
  const std::optional<int> columns = terminal_columns(descriptor_);
  if (!columns || *columns == std::exchange(columns_, *columns)) return;
  el_resize(editor_.get());
  if (line_ != Line::shown) return;
  hide();
  show();
}

void LineEditor::show() {
  if (line_ == Line::shown || !is_in_foreground(descriptor_)) return;
  if (!guard_) guard_.emplace(descriptor_);
  if (line_ == Line::hidden) {
    el_set(editor_.get(), EL_REFRESH);
  } else {
    columns_ = terminal_columns(descriptor_).value_or(columns_);
    el_set(editor_.get(), EL_UNBUFFERED, 0);
    el_set(editor_.get(), EL_UNBUFFERED, 1);  // begins a line, and shows the prompt
    TerminalGuard::remember_own_modes();
  }
  std::fflush(out_file_.get());
  line_ = Line::shown;
}

void LineEditor::hide() {
  if (line_ != Line::shown) return;
  std::string text = "\r";
  for (int row = rows_above_cursor(editor_.get(), columns_); row > 0; --row) text += "\x1B[A";
  std::fflush(out_file_.get());
  print_control(out_, text + "\x1B[J");
  line_ = Line::hidden;
}

void LineEditor::close() {
  keys_.drop_begun();
  line_ = Line::none;
  if (!guard_) return;
  if (is_in_foreground(descriptor_)) el_set(editor_.get(), EL_UNBUFFERED, 0);
  guard_.reset();
}

}  // namespace reorient
