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
  void put_lower(CameraFrame frame) {
    if (!lower_) waiting_since_ = frame.time;
    lower_ = std::move(frame);
  }

  /// Its pixels are gone.
  void drop_upper() { upper_.reset(); }
  void drop_lower() { lower_.reset(); }

  /// `now`: s, on the cameras' clock.
  bool is_due(double now) const { return upper_ || (lower_ && now - waiting_since_ >= patience_); }

  /// Moves the images over; the observation's time becomes that of the newest one.
  void take(Observation& observation) {
    observation.upper = std::exchange(upper_, std::nullopt);
    observation.lower = std::exchange(lower_, std::nullopt);
    if (observation.upper) observation.time = observation.upper->time;
    if (observation.lower && (!observation.upper || observation.lower->time > observation.time))
      observation.time = observation.lower->time;
  }

 private:
  double patience_;
  std::optional<CameraFrame> upper_;
  std::optional<CameraFrame> lower_;
  double waiting_since_ = 0.0;  ///< s, exposure of the first lower image since the frame before
};

}  // namespace reorient
