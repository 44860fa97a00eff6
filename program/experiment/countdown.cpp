// SPDX-License-Identifier: MIT
#include "program/experiment/countdown.h"

#include <ostream>
#include <utility>

#include <spdlog/fmt/fmt.h>
#include <unistd.h>

#include "program/safe_output.h"

namespace reorient {

Countdown::Countdown(std::ostream& err, std::size_t tasks)
    : err_(err), tasks_(tasks), start_(Clock::now()), is_terminal_(isatty(STDERR_FILENO) == 1) {}

void Countdown::count() {
  ++done_;
  const std::chrono::duration<double> passed = Clock::now() - start_;
  if (!is_terminal_ && passed.count() < next_) return;
  next_ = passed.count() + kPause;
  const double left = passed.count() / static_cast<double>(done_) * static_cast<double>(tasks_ - done_);
  if (is_terminal_) clear_terminal_line(err_);
  err_ << fmt::format("{} of {} trials, {:.0f} s, about {:.0f} s left", done_, tasks_, passed.count(), left)
       << (is_terminal_ ? "" : "\n") << std::flush;
  is_shown_ = is_terminal_;
}

void Countdown::clear() {
  if (std::exchange(is_shown_, false)) clear_terminal_line(err_);
}

}  // namespace reorient
