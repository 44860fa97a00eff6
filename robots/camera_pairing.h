// SPDX-License-Identifier: MIT
// From two cameras that are not exposed at the same instant, and may miss frames, to the frames of the engine.
#pragma once

#include <optional>
#include <utility>

#include "robots/robot.h"

namespace reorient {

/// An image of the upper camera makes a frame, together with the newest one of the lower camera since the frame before.
/// A lower image that waits for longer than `patience` makes a frame alone: then the upper camera has nothing to say.
/// Whoever fills it keeps the pixels until the frame is over.
class CameraPairing {
 public:
  static constexpr double kPatience = 0.05;  // s

  explicit CameraPairing(double patience = kPatience) : patience_(patience) {}

  void put_upper(CameraFrame frame) { upper_ = std::move(frame); }
  /// `now`: s, when it came, on the clock of is_due(): on its way from its exposure it has spent some time already.
  void put_lower(CameraFrame frame, double now) {
    if (!waiting_since_) waiting_since_ = now;
    lower_ = std::move(frame);
  }

  /// Its pixels are gone; whoever drops a lower image for a newer one lets that wait no longer.
  void drop_upper() { upper_.reset(); }
  void drop_lower() { lower_.reset(); }

  bool is_due(double now) const { return upper_ || (lower_ && now - *waiting_since_ >= patience_); }

  /// Moves the images over; the observation's time becomes that of the newest one.
  void take(Observation& observation) {
    observation.upper = std::exchange(upper_, std::nullopt);
    observation.lower = std::exchange(lower_, std::nullopt);
    if (observation.upper) observation.time = observation.upper->time;
    if (observation.lower && (!observation.upper || observation.lower->time > observation.time))
      observation.time = observation.lower->time;
    waiting_since_.reset();
  }

 private:
  double patience_;
  std::optional<CameraFrame> upper_;
  std::optional<CameraFrame> lower_;
  std::optional<double> waiting_since_;  ///< s, when the first lower image since the frame before came
};

}  // namespace reorient
