// SPDX-License-Identifier: MIT
#include "program/run/console/live_console.h"

#include <ostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include <unistd.h>

#include "program/run/console/name_pattern.h"

namespace reorient {
namespace {

Words words_of(const std::string& line) {
  std::istringstream in(line);
  Words words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

constexpr std::size_t kMostLateReplies = 100;

/// Number of changes that wait for the next frame.
std::size_t changes_in(const FrameInputs& inputs, const RunControls* controls) {
  return inputs.parameter_changes.size() + inputs.script_edits.size() + inputs.external.notes.size() +
         (controls != nullptr ? controls->waiting() : 0);
}

std::string mistake(const std::exception& error) { return "  " + printable(error.what()) + "\n"; }

}  // namespace

LiveConsole::LiveConsole(int descriptor, std::ostream& out, ConsoleSubject subject,
                         std::optional<std::filesystem::path> history)
    : descriptor_(descriptor),
      out_(out),
      table_(std::move(subject)),
      history_(std::move(history)),
      lines_(descriptor) {}

Topics LiveConsole::wanted() const { return reply_ ? Topics{Topic::conditions, Topic::costs} : Topics(); }

void LiveConsole::add_to(FrameInputs& inputs) {
  if (reply_ || wants_to_quit()) return;
  try {
    if (const std::optional<std::string> line = next_line()) take_line(*line, inputs);
  } catch (const std::runtime_error& error) {
    reply_ = at_once(mistake(error));
  }
}

void LiveConsole::add_while_paused(FrameInputs& inputs, const FrameRecord& last, const SceneTruth& scene) {
  if (wants_to_quit()) return;
  const std::size_t before = changes_in(inputs, table_.controls());
  add_to(inputs);
  if (!reply_) return print("");
  if (table_.controls()->pace().permits_frame()) return;  // a frame follows, which answers it
  std::string text;
  if (changes_in(inputs, table_.controls()) > before) {
    text = "  the run is paused; this takes effect with the next frame\n";
    if (late_.size() < kMostLateReplies) late_.push_back(std::move(reply_));
    reply_ = {};
  } else {
    text = reply(last, scene);
    if (reply_) return;  // it is busy
  }
  print(text);
}

Reply LiveConsole::ask(const Words& words) {
  FrameInputs unchanged;
  return table_.obey(words, unchanged);
}

void LiveConsole::poll_without_robot() {
  if (wants_to_quit()) return;
  const std::optional<std::string> line = next_line();
  const Words words = line ? words_of(*line) : Words();
  if (words.empty()) return;
  if (words == Words{"quit"}) {
    FrameInputs none;
    table_.obey(words, none);
  } else {
    out_ << "  expected quit, found '" << printable(*line) << "'; other commands need a connected client\n"
         << std::flush;
  }
}

std::optional<std::string> LiveConsole::next_line() {
  Typed typed = open_ && editor_ ? editor_->poll() : lines_.poll();
  if (typed.closed && open_) {
    out_ << "\n";
    close();
  }
  return std::move(typed.line);
}

void LiveConsole::take_line(const std::string& line, FrameInputs& inputs) {
  // A terminal echoes typed input; print other input here, so that the output is the same.
  if (std::exchange(is_prompted_, false) && isatty(descriptor_) != 1) out_ << printable(line) << "\n";
  const Words words = words_of(line);
  if (!words.empty()) {
    reply_ = table_.obey(words, inputs);
  } else if (!open_) {
    open();
  } else {
    close();
  }
}

void LiveConsole::open() {
  open_ = true;
  if (editor_ || !LineEditor::is_possible(descriptor_)) return;
  editor_.emplace(
      descriptor_, out_, [this](const Words& before) { return table_.candidates(before); }, history_);
}

void LiveConsole::close() {
  open_ = false;
  is_prompted_ = false;
  if (editor_) editor_->close();
  out_.flush();
}

void LiveConsole::make_room() {
  if (open_ && editor_) editor_->hide();
}

void LiveConsole::begin_line() {
  make_room();
  if (std::exchange(is_prompted_, false)) out_ << "\n";
}

std::string LiveConsole::reply(const FrameRecord& frame, const SceneTruth& scene) {
  if (!reply_) return {};
  try {
    const std::optional<std::string> answer = reply_(frame, scene);
    if (!answer) return {};
    reply_ = {};
    return *answer;
  } catch (const std::runtime_error& error) {
    reply_ = {};
    return mistake(error);
  }
}

/// The answers that are ready, of commands that were typed during a pause.
std::string LiveConsole::late_replies(const FrameRecord& frame, const SceneTruth& scene) {
  std::string text;
  for (Reply& late : std::exchange(late_, {})) {
    try {
      if (const std::optional<std::string> answer = late(frame, scene)) {
        text += *answer;
      } else {
        late_.push_back(std::move(late));
      }
    } catch (const std::runtime_error& error) {
      text += mistake(error);
    }
  }
  return text;
}

void LiveConsole::observe(const FrameRecord& frame, const SceneTruth& scene) {
  std::string text = late_.empty() ? std::string() : late_replies(frame, scene);
  text += reply(frame, scene);
  print(text + table_.observe(frame, scene));
}

/// Prints whole lines, then the prompt if the next command can be read.
void LiveConsole::print(const std::string& text) {
  if (!text.empty()) {
    begin_line();
    out_ << text << std::flush;
  }
  if (!open_ || reply_ || wants_to_quit()) return;
  if (editor_) {
    editor_->show();
  } else if (!std::exchange(is_prompted_, true)) {
    out_ << "> " << std::flush;
  }
}

void LiveConsole::finish(const FrameRecord& /*last*/, const SceneTruth& /*scene*/) {
  if (!editor_) return;
  make_room();
  close();
  editor_->save_history();
}

}  // namespace reorient
