// SPDX-License-Identifier: MIT
// Durations of frames in wall-clock time. They affect neither decisions nor the digest.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "workbench/run/observer.h"

namespace reorient {

/// Quantiles over frames, in s; all zero without frames.
struct TimeQuantiles {
  double median = 0.0;
  double percentile_99 = 0.0;  ///< 99 of 100 frames took at most this time
  double longest = 0.0;
};

/// Times counted in classes that are 1 % wide, so that a run of any length takes the same memory.
class TimeHistogram {
 public:
  void add(double seconds);
  /// Median and percentile are accurate to 1 %, the longest is exact.
  TimeQuantiles quantiles() const;

 private:
  static constexpr double kShortest = 1e-6;  // s
  static constexpr std::size_t kClasses = 2000;

  double rank(double share) const;

  std::array<std::uint64_t, kClasses> counts_{};
  std::uint64_t count_ = 0;
  double longest_ = 0.0;
};

/// Durations of a run's frames, with and without the robot's part (a simulated robot renders). Both include the
/// observers: log, recorder, live view.
class FrameTimes : public Observer {
 public:
  void observe(const FrameRecord& /*frame*/, const SceneTruth& scene) override {
    whole_.add(scene.observing + scene.stepping + scene.showing);
    own_.add(scene.stepping + scene.showing);
  }

  TimeQuantiles whole() const { return whole_.quantiles(); }
  TimeQuantiles without_observing() const { return own_.quantiles(); }

 private:
  TimeHistogram whole_;
  TimeHistogram own_;
};

}  // namespace reorient
