// SPDX-License-Identifier: MIT
// The model of a room, from a panorama, a saved model or a recording.
#pragma once

#include <functional>
#include <string>

#include "perception/room/saved_model.h"
#include "program/run/run_options.h"

namespace reorient {

/// How the simulator learns a panorama.
struct Learning {
  double seconds = 60.0;  ///< of the robot's time
  bool stands_still =
      false;  ///< beside the field and turns its head; otherwise the robot walks between the penalty marks
};

struct LearnedRoom {
  std::string from;  ///< for the user: "panorama hall.hdr, learned by the simulator"
  SavedModel model;
};

/// `source`: "hall" (the built-in one) or a panorama file, which the simulator learns as in the
/// scenario `trial`; a file that `run --model` wrote; or a recording, whose last state is used.
/// `simulation`: body, field, scripts, parameters and seed. `stop` is called after each frame. Throws
/// std::runtime_error with one line.
LearnedRoom learned_room(const std::string& source, const Learning& learning, SimulationOptions simulation,
                         const std::function<bool()>& stop);

}  // namespace reorient
