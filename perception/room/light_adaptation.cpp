#include "perception/room/light_adaptation.h"

#include <algorithm>

namespace reorient {

LightSums& LightSums::operator+=(const LightSums& other) {
  luma += other.luma;
  cb += other.cb;
  cr += other.cr;
  pixels += other.pixels;
  return *this;
}

Light LightSums::mean() const {
  if (pixels == 0) return {};
  return {luma / pixels, cb / pixels, cr / pixels};
}

LightSums sum_light(const ImageView& image, int row, int left, int right, const LightParameters& parameters) {
  LightSums sums;
  const std::uint8_t* pixels = image.row(row);
  int luma = 0;
  int cb = 0;
  int cr = 0;
  for (int x = left & ~1; x < right; x += 8) {
    const std::uint8_t* pair = pixels + 2 * x;
    if (pair[0] <= parameters.darkest || pair[0] >= parameters.brightest) continue;
    luma += pair[0];
    cb += pair[1];
    cr += pair[3];
    ++sums.pixels;
  }
  sums.luma = luma;
  sums.cb = cb;
  sums.cr = cr;
  return sums;
}

void LightAdaptation::observe(const LightSums& frame, double step, const LightParameters& parameters) {
  constexpr int kFewest = 50;  // pixels; fewer say nothing about the room
  if (frame.pixels < kFewest) {
    unseen_ += step;
    return;
  }
  if (unseen_ > parameters.fresh_after) age_ = 0.0;
  unseen_ = 0.0;
  const double memory = std::min(age_, parameters.time_constant);
  const double share = memory > 0.0 ? step / (memory + step) : 1.0;
  const Light seen = frame.mean();
  light_.luma += share * (seen.luma - light_.luma);
  light_.cb += share * (seen.cb - light_.cb);
  light_.cr += share * (seen.cr - light_.cr);
  age_ += std::max(step, 1e-3);
}

void LightAdaptation::restart() { *this = {}; }

}  // namespace reorient
