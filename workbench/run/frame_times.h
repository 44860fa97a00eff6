// SPDX-License-Identifier: MIT
// How long frames take in wall-clock time. Nothing of it enters a decision or the digest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "workbench/run/observer.h"

namespace reorient {

/// Of some number of frames, in s; all zero where there were none.
struct TimeQuantiles {
  double median = 0.0;
  double percentile_99 = 0.0;  ///< 99 of 100 frames were no longer
  double longest = 0.0;
};

/// Times counted in classes that are 1 % wide, so that a run of any length takes the same memory.
class TimeHistogram {
 public:
  void add(double seconds);
  /// Median and percentile are right within 1 %, the longest exactly.
  TimeQuantiles quantiles() const;

 private:
  static constexpr double kShortest = 1e-6;  // s
  static constexpr std::size_t kClasses = 2000;

  double rank(double share) const;

  std::array<std::uint64_t, kClasses> counts_{};
  std::uint64_t count_ = 0;
  double longest_ = 0.0;
};

/// What a run's frames took: with the robot's part of it (a simulated one renders), and without.
class FrameTimes : public Observer {
 public:
  void observe(const FrameRecord& /*frame*/, const SceneTruth& scene) override {
    whole_.add(scene.observing + scene.stepping);
    own_.add(scene.stepping);
  }

  TimeQuantiles whole() const { return whole_.quantiles(); }
  TimeQuantiles without_observing() const { return own_.quantiles(); }

 private:
  TimeHistogram whole_;
  TimeHistogram own_;
};

}  // namespace reorient
