// The room's light as the camera shows it, so that thresholds can follow exposure and white balance (findings 1).
#pragma once

#include "geometry/image.h"
#include "perception/room/color_histogram.h"

namespace reorient {

struct LightParameters {
  double time_constant = 20.0;
  double darkest = 15.0;
  double brightest = 245.0;
  double fresh_after = 2.0;
};
template <typename Visit>
void describe(LightParameters& p, Visit&& visit) {
  visit("time_constant", p.time_constant, 0.0, 600.0, "s", "over how long the means of the wall's pixels run");
  visit("darkest", p.darkest, 0.0, 254.0, "", "pixels whose luma is not above this are left out of the means");
  visit("brightest", p.brightest, 1.0, 255.0, "", "pixels whose luma is not below this are left out of the means");
  visit("fresh_after", p.fresh_after, 0.0, 60.0, "s",
        "time without any wall in view after which the means start afresh");
}

/// Sums over some pixels of the wall.
struct LightSums {
  double luma = 0.0;
  double cb = 0.0;
  double cr = 0.0;
  int pixels = 0;

  LightSums& operator+=(const LightSums& other);
  Light mean() const;  ///< neutral where there are no pixels
};

/// Every eighth pixel of one row, columns left...right - 1, that is neither too dark nor too bright.
LightSums sum_light(const ImageView& image, int row, int left, int right, const LightParameters& parameters);

/// The running mean: a true mean at first, an exponential filter once it is time_constant old.
class LightAdaptation {
 public:
  /// One frame's sums over the wall. `step`: s since the frame before.
  void observe(const LightSums& frame, double step, const LightParameters& parameters);
  void restart();
  const Light& light() const { return light_; }

 private:
  Light light_;
  double age_ = 0.0;     ///< s of frames in the mean
  double unseen_ = 0.0;  ///< s since wall was last in view
};

}  // namespace reorient
