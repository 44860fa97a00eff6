// What a person at a terminal reads of a run while it goes on, without one writing into another's line.
#pragma once

#include <ostream>

#include "program/run/console/live_console.h"
#include "program/run/run_observers.h"
#include "program/run/timeline_printer.h"

namespace reorient {

struct Narration {
  Narration(LiveConsole& console, bool every_transition, std::ostream& out, std::ostream& err)
      : room_for_log([&console] { console.make_room(); }),
        progress(err, [&console] { return console.is_open(); }),
        timeline(out, every_transition, [this, &console] {
          progress.make_room();
          console.begin_line();
        }) {}
  Narration(const Narration&) = delete;
  Narration& operator=(const Narration&) = delete;

  RunLog log;
  RoomForLog room_for_log;
  Progress progress;
  TimelinePrinter timeline;
};

}  // namespace reorient
