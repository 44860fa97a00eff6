// What a person at a terminal reads of a run while it goes on, without one writing into another's line.
#pragma once

#include <ostream>
#include <string>

#include "program/run/console/live_console.h"
#include "program/run/run_observers.h"
#include "program/run/timeline_printer.h"

namespace reorient {

struct Narration {
  Narration(LiveConsole& prompt, bool every_transition, std::ostream& out, std::ostream& errors)
      : console(prompt),
        err(errors),
        room_for_log([this] { console.make_room(); }),
        progress(err, [this] { return console.is_open(); }),
        timeline(out, every_transition, [this] {
          progress.make_room();
          console.begin_line();
        }) {}
  Narration(const Narration&) = delete;
  Narration& operator=(const Narration&) = delete;

  /// One line to the person.
  void tell(const std::string& line) {
    progress.make_room();
    console.make_room();
    err << "reorient: " << line << '\n' << std::flush;
  }

  LiveConsole& console;
  std::ostream& err;
  RunLog log;
  RoomForLog room_for_log;
  Progress progress;
  TimelinePrinter timeline;
};

}  // namespace reorient
