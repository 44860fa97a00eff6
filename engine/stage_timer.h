// SPDX-License-Identifier: MIT
// How long each stage of a frame takes, where somebody wants to know.
#pragma once

#include <chrono>

#include "engine/record/frame_record.h"

namespace reorient {

/// Adds the time until its end to a stage, where somebody wants to know.
class StageTimer {
 public:
  StageTimer(FrameRecord& record, Stage stage) : record_(record), stage_(stage) {
    if (record_.filled.has(Topic::costs)) begin_ = std::chrono::steady_clock::now();
  }
  ~StageTimer() {
    if (!record_.filled.has(Topic::costs)) return;
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin_;
    record_.costs.seconds[static_cast<std::size_t>(stage_)] = took.count();
  }
  StageTimer(const StageTimer&) = delete;
  StageTimer& operator=(const StageTimer&) = delete;

 private:
  FrameRecord& record_;
  Stage stage_;
  std::chrono::steady_clock::time_point begin_;
};

}  // namespace reorient
