// SPDX-License-Identifier: MIT
// The what-if of the live view: the latest frames of the run, replayed with other parameters and scripts.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>

#include "program/run/live/live_options.h"
#include "workbench/recording/recent_frames.h"
#include "workbench/recording/what_if.h"
#include "workbench/views/live/what_ifs.h"

namespace reorient {

class LiveWhatIf : public live::WhatIf {
 public:
  /// `most_bytes`: of the memory for frames.
  explicit LiveWhatIf(std::size_t most_bytes) : frames_({.most_bytes = most_bytes}) {}

  Observer& memory() override { return frames_; }
  std::string answer(const std::string& payload, const std::function<bool()>& stop) override;

 private:
  RecentFrames frames_;
};

/// nullptr: the run keeps no frames.
std::shared_ptr<live::WhatIf> make_what_if(const LiveOptions& options, LiveLoad load);

/// The request of the service what_if. `end`: s, the time of the last frame. Throws live::BadClientMessage.
WhatIfQuestion read_what_if(const std::string& payload, double end);
/// Its response. `seconds`: the time that the answer took.
std::string what_if_json(const WhatIfAnswer& answer, double seconds);

}  // namespace reorient
