// SPDX-License-Identifier: MIT
// The live view of a run: it serves what the prompt serves.
#pragma once

#include <filesystem>
#include <iosfwd>
#include <memory>
#include <string>

#include "program/run/console/live_console.h"
#include "program/run/live/live_options.h"

namespace reorient {

class LiveView;

/// Deletes it where it is a complete type.
struct DeleteLiveView {
  void operator()(LiveView* live) const;
};
using LiveViewPointer = std::unique_ptr<LiveView, DeleteLiveView>;

/// Starts the live view, and prints its link to `err`; nullptr without --live. `subject` and `console` must outlive it.
/// `scripts`: the root of the scripts.
/// Throws std::runtime_error with one line.
LiveViewPointer start_live_view(const LiveOptions& options, LiveLoad load, const ConsoleSubject& subject,
                                const std::filesystem::path& scripts, LiveConsole& console, std::ostream& err);

/// Prints the link of the live view.
void print_link(const LiveView& live, std::ostream& err);

/// Its poll_without_frames(), if it is not nullptr.
void poll_without_robot(LiveView* live);

/// Ends the live view, and prints what it did not show. It may be nullptr. Viewers learn who ended the run: `user`, as
/// user_who_ended_run() returns it.
void end_live_view(LiveView* live, const std::string& user, std::ostream& out);

}  // namespace reorient
