// SPDX-License-Identifier: MIT
#include "program/run/timeline_printer.h"

#include <optional>
#include <ostream>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "program/program_output.h"
#include "workbench/run/run_controls.h"

namespace reorient {

namespace {

/// What matters: reorientations, what was refused, and notes. Nothing: no color.
std::optional<Color> color_of(const TimelineEvent& event) {
  if (event.reorients) return Color::green;
  if (!event.command.empty() && event.verdict != to_string(Verdict::granted)) return Color::yellow;
  if (event.state.starts_with("note: ") || event.machine == "game") return Color::cyan;
  return std::nullopt;
}

}  // namespace

std::string to_text(const TimelineEvent& event) {
  const std::string what = event.command.empty() ? event.state : event.command + " " + event.verdict;
  return event.reason.empty() ? what : what + " (" + event.reason + ")";
}

TimelinePrinter::TimelinePrinter(std::ostream& out, bool every_event, std::function<void()> make_room)
    : out_(out), every_event_(every_event), make_room_(std::move(make_room)) {}

bool TimelinePrinter::is_news(const TimelineEvent& event) {
  const bool is_of_operator =
      (event.machine == "note" || event.machine == kOperatorName || event.machine == kViewerName) &&
      event.state.starts_with("note: ");
  if (every_event_ || is_of_operator) return true;
  if (last_.size() >= kMostRemembered && event.time >= tidied_ + 1.0) {
    std::erase_if(last_, [&](const auto& each) { return event.time - each.second >= kRepeats; });
    tidied_ = event.time;
  }
  const std::string key = event.machine + '\n' + to_text(event);
  const auto found = last_.find(key);
  if (found == last_.end() && last_.size() >= kMostRemembered) return false;
  const bool is_recent = found != last_.end() && event.time - found->second < kRepeats;
  last_[key] = event.time;
  return !is_recent;
}

void TimelinePrinter::observe(const FrameRecord& frame, const SceneTruth& scene) {
  bool printed = false;
  for (const TimelineEvent& event : timeline_events(frame, scene)) {
    if (!is_news(event) && !event.reorients) {
      const bool has_room = repeated_.contains(event.machine) || repeated_.size() < CommandHistory::kMostMachines;
      ++repeated_[has_room ? event.machine : "(others)"];
      continue;
    }
    if (!std::exchange(printed, true) && make_room_) make_room_();
    if (!std::exchange(has_header_, true)) out_ << "    time  behavior              what it did (why)\n";
    const std::string line =
        fmt::format("{:>6.2f} s  {:<20}  {}", event.time, as_line(event.machine), as_line(to_text(event)));
    if (const std::optional<Color> color = color_of(event); color)
      print_colored(out_, *color, line);
    else
      out_ << line;
    out_ << '\n';
  }
  if (printed) out_.flush();
}

void TimelinePrinter::finish(const FrameRecord& /*last*/, const SceneTruth& /*scene*/) {
  if (repeated_.empty()) return;
  if (make_room_) make_room_();
  for (const auto& [machine, count] : repeated_) {
    out_ << fmt::format("          {:<20}  {} repeated within {:.0f} s; --every-transition shows them\n",
                        as_line(machine), counted(count, "event"), kRepeats);
  }
}

}  // namespace reorient
