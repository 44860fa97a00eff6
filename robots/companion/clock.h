// SPDX-License-Identifier: MIT
// A client's time and odometry as the engine sees them: both continue when the client restarts. A client's clock
// starts at any value, and its odometry starts at zero with each process.
#pragma once

#include <cstdint>
#include <optional>

#include "geometry/pose2.h"

namespace reorient {

class ClientClock {
 public:
  /// Converts a frame's time (s) and odometry from the client's to the engine's. `client`: differs after a restart of
  /// the client's process; `silence`: s on the server's clock since the previous frame. Returns nothing if the time is
  /// not later than that of the previous frame. After a second of such frames, the clock counts as set back, and time
  /// continues.
  struct Moment {
    double time = 0.0;
    Pose2 odometry;
  };
  std::optional<Moment> advance(std::uint64_t client, double time, const Pose2& odometry, double silence);

  /// Converts a time on the client's clock to the engine's time; valid after the first frame.
  double to_engine(double time) const { return time + offset_; }
  /// The engine's odometry of the last frame.
  const Pose2& odometry() const { return last_odometry_; }
  /// Whether the last frame was the first one of a restarted client.
  bool restarted() const { return restarted_; }

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.known_, self.client_, self.offset_, self.last_time_, self.before_, self.last_odometry_);
  }

 private:
  void go_on_at(double time, double gap);

  bool known_ = false;
  std::uint64_t client_ = 0;
  double offset_ = 0.0;     // s, engine's time minus client's time
  double last_time_ = 0.0;  // s, engine's time
  Pose2 before_;            // the engine's odometry is this times the client's
  Pose2 last_odometry_;     // the engine's
  double backwards_ = 0.0;  // s on the server's clock for which the client's clock was behind its last time
  bool restarted_ = false;
};

}  // namespace reorient
