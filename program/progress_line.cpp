// SPDX-License-Identifier: MIT
#include "program/progress_line.h"

#include <ostream>
#include <utility>

#include <unistd.h>

#include "engine/parameters/utf8.h"
#include "program/program_output.h"

namespace reorient {
namespace {

constexpr std::chrono::milliseconds kPauseOfLog{10'000};

}  // namespace

ProgressLine::ProgressLine(std::ostream& err, std::chrono::milliseconds pause)
    : err_(err), is_terminal_(isatty(STDERR_FILENO) == 1), pause_(is_terminal_ ? pause : kPauseOfLog) {
  restart();
}

void ProgressLine::restart() { next_ = Clock::now() + pause_; }

void ProgressLine::show(std::string_view text) {
  restart();
  show_status(err_, is_terminal_, as_line(text));
  is_shown_ = is_terminal_;
}

void ProgressLine::clear() {
  if (std::exchange(is_shown_, false)) clear_terminal_line(err_);
}

}  // namespace reorient
