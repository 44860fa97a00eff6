// SPDX-License-Identifier: MIT
#include "workbench/run/run_pace.h"

#include <algorithm>

namespace reorient {

void RunPace::resume() {
  is_paused_ = false;
  frames_ = 0;
  when_.reset();
}

void RunPace::take_frames(int count) {
  is_paused_ = true;
  frames_ = std::clamp(count, 1, kMostFrames);
  when_.reset();
}

void RunPace::set_speed(double speed) {
  speed_ = std::clamp(speed, kSlowest, kFastest);
  when_.reset();
}

void RunPace::count_frame() {
  if (frames_ > 0) --frames_;
}

void RunPace::begin(double time) {
  time_ = time;
  when_ = Clock::now();
}

RunPace::Clock::time_point RunPace::due(double time) {
  if (!when_) begin(time);
  return *when_ + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>((time - time_) / speed_));
}

}  // namespace reorient
