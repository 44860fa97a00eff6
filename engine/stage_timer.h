// SPDX-License-Identifier: MIT
// Measures the time of each stage of a frame if requested.
#pragma once

#include <chrono>

#include "engine/record/frame_record.h"

namespace reorient {

/// Adds the time of its lifetime to a stage if requested.
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
