// SPDX-License-Identifier: MIT
// The timeline, line by line during the run.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <map>
#include <string>

#include "workbench/run/timeline.h"

namespace reorient {

/// Prints a line for each event. Repeated events, such as those of a scanning head, are printed once and then counted,
/// because they would hide other events. A granted flip, purge or reset is always printed.
class TimelinePrinter : public Observer {
 public:
  /// `make_room`: called before a line is printed if other text is in the terminal's last line; may be
  /// empty.
  TimelinePrinter(std::ostream& out, bool every_event, std::function<void()> make_room = {});

  void observe(const FrameRecord& frame, const SceneTruth& scene) override;
  void finish(const FrameRecord& last, const SceneTruth& scene) override;

  static constexpr double kRepeats = 10.0;  ///< s after which the same event is printed again
  static constexpr std::size_t kMostRemembered =
      10'000;  ///< events; with all of them recent, new ones are counted only

 private:
  bool is_news(const TimelineEvent& event);

  std::ostream& out_;
  bool every_event_;
  std::function<void()> make_room_;
  bool has_header_ = false;
  double tidied_ = 0.0;                            ///< s, when old events were removed
  std::map<std::string, double> last_;             ///< s; last time of each stored event
  std::map<std::string, std::uint64_t> repeated_;  ///< by machine: events that were not printed
};

/// "flip_pose granted (the opposite pose won)", "watching > correcting (the opposite pose won)"
std::string to_text(const TimelineEvent& event);

}  // namespace reorient
