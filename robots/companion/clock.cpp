// SPDX-License-Identifier: MIT
#include "robots/companion/clock.h"

#include <algorithm>

namespace reorient {
namespace {

constexpr double kStep = 0.001;      // s, smallest time between two frames, used if the true one is unknown
constexpr double kLongest = 3600.0;  // s, largest time between two frames

}  // namespace

/// Sets the offset so that `time` on the client's clock is `gap` seconds after the previous frame.
void ClientClock::go_on_at(double time, double gap) {
  offset_ = (known_ ? last_time_ + std::clamp(gap, kStep, kLongest) : 0.0) - time;
}

std::optional<ClientClock::Moment> ClientClock::advance(std::uint64_t client, double time, const Pose2& odometry,
                                                        double silence) {
  constexpr double kPatience = 1.0;  // s
  restarted_ = !known_ || client != client_;
  if (restarted_) {
    go_on_at(time, silence);
    before_ = last_odometry_ * odometry.inverse();
    client_ = client;
    known_ = true;
  } else if (to_engine(time) <= last_time_) {
    backwards_ += silence;
    if (backwards_ < kPatience) return std::nullopt;
    go_on_at(time, backwards_);
  } else if (to_engine(time) > last_time_ + kLongest) {
    go_on_at(time, silence);
  }
  backwards_ = 0.0;
  last_time_ = to_engine(time);
  last_odometry_ = before_ * odometry;
  return Moment{last_time_, last_odometry_};
}

}  // namespace reorient
