// SPDX-License-Identifier: MIT
// Compares the belief of each frame with the truth.
#pragma once

#include <optional>

#include "workbench/experiments/trial/pose_errors.h"
#include "workbench/experiments/trial/trial_observer.h"
#include "workbench/run/observer.h"

namespace reorient {

/// Starts when the trial's clock starts.
class PoseErrorObserver : public Observer {
 public:
  /// `trial` judges the same run and observes each frame before this one does.
  explicit PoseErrorObserver(const TrialObserver& trial) : trial_(trial) {}

  void observe(const FrameRecord& frame, const SceneTruth& scene) override;

  const PoseErrors& errors() const { return errors_; }

 private:
  /// The start time of a condition that holds without a break.
  struct Since {
    std::optional<double> time;
    void note(bool holds, double now) {
      if (!holds) time.reset();
      if (holds && !time) time = now;
    }
  };

  void watch_recovery(double time);

  const TrialObserver& trial_;
  PoseErrors errors_;
  Since stands_, right_, located_;
  std::optional<double> stood_up_at_;  ///< after a fall
  bool has_fallen_ = false;
  bool was_disturbed_ = false;  ///< fell or was lifted at any time
};

}  // namespace reorient
