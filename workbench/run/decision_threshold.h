// SPDX-License-Identifier: MIT
// The thresholds of the evidence at which the shipped behaviors decide, for views of a run.
#pragma once

#include <vector>

#include "engine/parameters/parameter.h"
#include "engine/record/frame_record.h"

namespace reorient {

/// The threshold of an unconfirmed pose in log-odds, as scripts/lib/decision.lua computes it. 0 if its parameters are
/// missing, because no script uses them.
double unconfirmed_threshold(const std::vector<Parameter>& parameters);
/// The same for a confirmed pose.
double confirmed_threshold(const std::vector<Parameter>& parameters);

/// Follows the threshold during a run. Observers that use it request kTopic.
class DecisionThreshold {
 public:
  static constexpr Topic kTopic = Topic::parameters;

  void observe(const FrameRecord& frame);
  /// Log-odds; 0: unknown.
  double value() const { return value_; }

 private:
  double value_ = 0.0;
  bool is_read_ = false;
};

}  // namespace reorient
