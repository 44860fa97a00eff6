// SPDX-License-Identifier: MIT
// Pairs the images of two cameras, which are exposed at different times and may be lost, into frames of the engine.
#pragma once

#include <optional>
#include <utility>

#include "robots/robot.h"

namespace reorient {

/// An image of the upper camera makes a frame, together with the newest image of the lower camera since the previous
/// frame. A lower image that has waited for longer than `patience` makes a frame alone, because the upper camera
/// delivers no images then. The caller must store the pixels until the frame is processed.
class CameraPairing {
 public:
  static constexpr double kPatience = 0.05;  // s

  explicit CameraPairing(double patience = kPatience) : patience_(patience) {}

  void put_upper(CameraFrame frame) { upper_ = std::move(frame); }
  /// `now`: arrival time, s, on the clock of is_due(); later than the exposure.
  void put_lower(CameraFrame frame, double now) {
    if (!waiting_since_) waiting_since_ = now;
    lower_ = std::move(frame);
  }

  /// Call these if the pixels are no longer valid. The waiting time counts from the first lower image, also if a newer
  /// one replaces it.
  void drop_upper() { upper_.reset(); }
  void drop_lower() { lower_.reset(); }

  bool is_due(double now) const { return upper_ || (lower_ && now - *waiting_since_ >= patience_); }

  /// Moves the images to the observation and sets its time to that of the newest image.
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
  std::optional<double> waiting_since_;  ///< s, arrival time of the first lower image since the previous frame
};

}  // namespace reorient
