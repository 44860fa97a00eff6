// SPDX-License-Identifier: MIT
#include "perception/room/color/color_histogram.h"

#include <algorithm>
#include <cmath>

namespace reorient {
namespace {

std::uint8_t to_byte(double value) { return static_cast<std::uint8_t>(std::clamp(value, 0.0, 255.0)); }

}  // namespace

bool is_sound(const Light& light) {
  const auto is_level = [](double value) { return value >= 0.0 && value <= 255.0; };
  return is_level(light.luma) && is_level(light.cb) && is_level(light.cr);
}

RelativeLight relative(const Light& place, const Light& room) {
  return {room.luma > 0.0 ? place.luma / room.luma : 1.0, place.cb - room.cb, place.cr - room.cr};
}

ColorThresholds color_thresholds(const ColorParameters& parameters, const Light& light) {
  const double gain = light.luma / Light{}.luma;
  const double dark = std::min(parameters.dark_below, parameters.bright_above);
  ColorThresholds thresholds;
  thresholds.medium = to_byte(std::ceil(dark * gain));
  thresholds.bright = to_byte(std::ceil(parameters.bright_above * gain));
  thresholds.white = to_byte(std::ceil(0.5 * (dark + parameters.bright_above) * gain));
  thresholds.cb_neutral = to_byte(std::ceil(light.cb));
  thresholds.cr_neutral = to_byte(std::ceil(light.cr));
  thresholds.cb_gray_first = to_byte(std::floor(light.cb - parameters.gray_within) + 1.0);
  thresholds.cb_gray_last = to_byte(std::ceil(light.cb + parameters.gray_within) - 1.0);
  thresholds.cr_gray_first = to_byte(std::floor(light.cr - parameters.gray_within) + 1.0);
  thresholds.cr_gray_last = to_byte(std::ceil(light.cr + parameters.gray_within) - 1.0);
  return thresholds;
}

int color_bin(const Ycbcr& pixel, const ColorThresholds& t) {
  const bool gray = pixel.cb >= t.cb_gray_first && pixel.cb <= t.cb_gray_last && pixel.cr >= t.cr_gray_first &&
                    pixel.cr <= t.cr_gray_last;
  if (gray) return pixel.y >= t.white ? 1 : 0;
  const int slice = (pixel.y >= t.medium ? 1 : 0) + (pixel.y >= t.bright ? 1 : 0);
  const int quadrant = (pixel.cb >= t.cb_neutral ? 1 : 0) + (pixel.cr >= t.cr_neutral ? 2 : 0);
  return 2 + 4 * slice + quadrant;
}

ColorHistogram normalized(const ColorCounts& counts) {
  std::uint64_t sum = 0;
  for (const std::uint32_t count : counts) sum += count;
  ColorHistogram histogram{};
  if (sum == 0) return histogram;
  for (std::size_t bin = 0; bin < counts.size(); ++bin) {
    histogram[bin] = static_cast<float>(static_cast<double>(counts[bin]) / static_cast<double>(sum));
  }
  return histogram;
}

ColorHistogram blurred(const ColorHistogram& histogram, double fraction) {
  const auto value = [&](int slice, int quadrant) {
    if (slice < 0) return histogram[0];
    if (slice > 2) return histogram[1];
    return histogram[static_cast<std::size_t>(2 + 4 * slice + quadrant)];
  };
  const float given = static_cast<float>(fraction);
  const float kept = 1.0f - 4.0f * given;
  ColorHistogram result{};
  result[0] = kept * histogram[0];
  result[1] = kept * histogram[1];
  for (int quadrant = 0; quadrant < 4; ++quadrant) {
    result[0] += given * value(0, quadrant);
    result[1] += given * value(2, quadrant);
    for (int slice = 0; slice < 3; ++slice) {
      result[static_cast<std::size_t>(2 + 4 * slice + quadrant)] =
          kept * value(slice, quadrant) + given * (value(slice - 1, quadrant) + value(slice + 1, quadrant) +
                                                   value(slice, quadrant ^ 1) + value(slice, quadrant ^ 2));
    }
  }
  return result;
}

}  // namespace reorient
