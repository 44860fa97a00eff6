// SPDX-License-Identifier: MIT
// The pace of frames: when each frame is due on the wall clock, and whether the run is paused.
#pragma once

#include <chrono>
#include <optional>

namespace reorient {

class RunPace {
 public:
  using Clock = std::chrono::steady_clock;

  static constexpr double kSlowest = 0.05;   ///< multiple of real time
  static constexpr double kFastest = 20.0;   ///< the same
  static constexpr int kMostFrames = 1'000;  ///< single frames of one request

  /// After the next frame, or at once between two frames.
  void pause() {
    is_paused_ = true;
    frames_ = 0;
  }
  void resume();
  /// Runs this many frames of a paused run; a run that is not paused is paused after them.
  void take_frames(int count);
  /// Real time is 1.
  void set_speed(double speed);

  bool is_paused() const { return is_paused_; }
  double speed() const { return speed_; }
  /// Whether the next frame may run.
  bool permits_frame() const { return !is_paused_ || frames_ > 0; }
  /// Call after each frame.
  void count_frame();

  /// `time` (s of the robot) is now.
  void begin(double time);
  /// The moment at which this time of the robot is due. The first call after a change of the pace begins with it.
  Clock::time_point due(double time);

 private:
  bool is_paused_ = false;
  int frames_ = 0;  ///< that a paused run still runs
  double speed_ = 1.0;
  double time_ = 0.0;                      ///< s
  std::optional<Clock::time_point> when_;  ///< the moment of time_; nothing: the pace has changed
};

}  // namespace reorient
