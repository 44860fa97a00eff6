// SPDX-License-Identifier: MIT
#include "program/experiment/countdown.h"

#include <spdlog/fmt/fmt.h>

namespace reorient {

Countdown::Countdown(std::ostream& err, std::size_t tasks) : line_(err), tasks_(tasks) {}

void Countdown::count() {
  ++done_;
  if (!line_.is_due()) return;
  const std::chrono::duration<double> passed = Clock::now() - start_;
  const double left = passed.count() / static_cast<double>(done_) * static_cast<double>(tasks_ - done_);
  line_.show(fmt::format("{} of {} trials, {:.0f} s, about {:.0f} s left", done_, tasks_, passed.count(), left));
}

}  // namespace reorient
