// SPDX-License-Identifier: MIT
#include "program/recording/recorded_times.h"

#include <cmath>
#include <ostream>
#include <stdexcept>
#include <string>

#include <CLI/CLI.hpp>
#include <spdlog/fmt/fmt.h>

#include "program/options.h"

namespace reorient {
namespace {

void require_begun(const Recording& recording, const char* option, double time) {
  if (time + kReadingError < recording.begin_time())
    throw std::runtime_error(fmt::format("{} {}: expected at least {:.2f}, where the recording begins", option, time,
                                         recording.begin_time()));
}

void require_not_over(const Recording& recording, const char* option, double time) {
  if (time > recording.end_time() + kReadingError)
    throw std::runtime_error(
        fmt::format("{} {}: expected at most {:.2f}, where the recording ends", option, time, recording.end_time()));
}

}  // namespace

void add_time_options(CLI::App& parser, RecordedTimes& times) {
  parser.add_option("--from", times.from, "first time in the robot's seconds (default: the beginning)")
      ->type_name("SECONDS")
      ->check(check_moment);
  parser.add_option("--to", times.to, "last time in the robot's seconds (default: the end)")
      ->type_name("SECONDS")
      ->check(check_moment);
}

void require_recorded(const Recording& recording, const RecordedTimes& times, std::ostream& err) {
  if (times.from > times.to)
    throw std::runtime_error(fmt::format("--from {} --to {}: expected --to at or after --from", times.from, times.to));
  require_not_over(recording, "--from", times.from);
  require_begun(recording, "--to", times.to);
  if (std::isfinite(times.to) && times.to > recording.end_time() + kReadingError)
    err << fmt::format("reorient: --to {}: the recording ends at {:.2f} s\n", times.to, recording.end_time());
}

void require_recorded(const Recording& recording, double at) {
  require_begun(recording, "--at", at);
  require_not_over(recording, "--at", at);
}

}  // namespace reorient
