// SPDX-License-Identifier: MIT
#include "program/run/live/run_live_view.h"

#include <ostream>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "program/run/live/live_what_if.h"
#include "workbench/views/live/live_view.h"

namespace reorient {

void DeleteLiveView::operator()(LiveView* live) const { delete live; }

void print_link(const LiveView& live, std::ostream& err) {
  err << "reorient: live view: " << live.link() << '\n' << std::flush;
}

void poll_without_robot(LiveView* live) {
  if (live != nullptr) live->poll_without_frames("no robot is connected");
}

LiveViewPointer start_live_view(const LiveOptions& options, LiveLoad load, const ConsoleSubject& subject,
                                const std::filesystem::path& scripts, LiveConsole& console, std::ostream& err) {
  if (!options.is_on) return nullptr;
  LiveViewPointer live(
      new LiveView(live_view_options(options, load),
                   live::LiveSubject{subject.scenario, subject.parameters, subject.kept_parameters, scripts,
                                     [&console](const Words& words) { return console.ask(words); }, subject.controls,
                                     subject.engine, make_what_if(options, load)}));
  print_link(*live, err);
  return live;
}

void end_live_view(LiveView* live, const std::string& user, std::ostream& out) {
  if (live == nullptr) return;
  live->stop("the run has ended" + (user.empty() ? "" : ", by " + user));
  const LiveView::Counts counts = live->counts();
  out << fmt::format(
      "live view: {}; not shown: {} because the processor was busy, {}, {} and {} because a "
      "viewer was slow\n",
      counted(counts.viewers, "viewer"), counted(counts.dropped_frames, "frame"),
      counted(counts.left_out.frames, "frame"), counted(counts.left_out.images, "image"),
      counted(counts.dropped_messages, "message"));
}

}  // namespace reorient
