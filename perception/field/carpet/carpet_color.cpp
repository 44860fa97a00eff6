#include "perception/field/carpet/carpet_color.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>

#include "geometry/bytes.h"
#include "geometry/pinned_math.h"

namespace reorient {
namespace {

constexpr int kSampleColumns = 48;
constexpr int kSampleRows = 36;
constexpr std::size_t kFewestSamples = 40;
constexpr double kFewestShare = 0.1;     // of the samples must be of one green
constexpr double kShareOfAnother = 0.3;  // before a known colour is given up for another one
constexpr double kNear = 4.0;            // m

/// Could any carpet have this chroma? From yellowish to bluish green, with room for a white balance that is off.
bool is_greenish(double b, double r) {
  constexpr double kLeast = 5.0;
  return r < 0.0 && -r >= 0.3 * std::abs(b) && b <= 3.0 - 0.3 * r && b * b + r * r >= kLeast * kLeast;
}

double radius_around(double b, double r) { return std::max(6.0, 0.6 * pinned::hypot(b, r)); }

}  // namespace

CarpetColor::CarpetColor(const FieldFeatureParameters& parameters) : parameters_(parameters) {
  samples_.reserve(static_cast<std::size_t>(kSampleColumns) * kSampleRows);
}

void CarpetColor::observe(const ImageView& image, const GroundProjection& view) {
  collect(image, view);
  double b = 0.0;
  double r = 0.0;
  if (!find_green(b, r)) return;
  blend(b, r);
  prepare_thresholds();
}

void CarpetColor::collect(const ImageView& image, const GroundProjection& view) {
  samples_.clear();
  const double horizon = std::clamp(view.horizon(0.5 * image.width), 0.0, static_cast<double>(image.height));
  for (int j = 0; j < kSampleRows; ++j) {
    const int y = static_cast<int>(horizon + (j + 0.5) * (image.height - horizon) / kSampleRows);
    if (y + 2 >= image.height) break;
    const auto ground = view.ground({0.5 * image.width, static_cast<double>(y)});
    if (!ground || view.distance(*ground) > kNear) continue;
    for (int i = 0; i < kSampleColumns; ++i) {
      const int x = static_cast<int>((i + 0.5) * image.width / kSampleColumns) & ~1;
      const std::uint8_t* pair = image.row(y) + 2 * x;
      const std::uint8_t* below = image.row(y + 2) + 2 * x;
      const int luma = (pair[0] + pair[2]) / 2;
      samples_.push_back({luma, pair[1] - 128, pair[3] - 128, std::abs(luma - (below[0] + below[2]) / 2)});
    }
  }
}

/// The densest greenish chroma among the samples.
bool CarpetColor::find_green(double& b, double& r) const {
  constexpr std::size_t kBins = 32;  // 4 steps of chroma each
  constexpr int kRange = 64;
  std::array<std::array<int, kBins>, kBins> histogram{};
  const auto bin = [](int chroma) {
    return static_cast<std::size_t>(std::clamp((chroma + kRange) / 4, 1, static_cast<int>(kBins) - 2));
  };
  for (const Sample& sample : samples_) {
    if (is_greenish(sample.b, sample.r)) ++histogram[bin(sample.b)][bin(sample.r)];
  }
  const auto middle = [](std::size_t index) { return 4.0 * static_cast<double>(index) - kRange + 1.5; };

  int most = 0;
  for (std::size_t i = 1; i + 1 < kBins; ++i) {
    for (std::size_t j = 1; j + 1 < kBins; ++j) {
      if (!is_greenish(middle(i), middle(j))) continue;
      int count = 0;
      for (std::size_t k = i - 1; k <= i + 1; ++k) {
        count += histogram[k][j - 1] + histogram[k][j] + histogram[k][j + 1];
      }
      if (count <= most) continue;
      most = count;
      b = middle(i);
      r = middle(j);
    }
  }
  return static_cast<std::size_t>(most) >= kFewestSamples &&
         most >= kFewestShare * static_cast<double>(samples_.size());
}

/// Mean of the samples around (b, r), mixed into what was known.
void CarpetColor::blend(double b, double r) {
  const double radius = radius_around(b, r);
  double count = 0.0, sum_b = 0.0, sum_r = 0.0, sum_y = 0.0, sum_difference = 0.0;
  for (const Sample& sample : samples_) {
    if (!is_greenish(sample.b, sample.r) || pinned::hypot(sample.b - b, sample.r - r) > radius) continue;
    count += 1.0;
    sum_b += sample.b;
    sum_r += sample.r;
    sum_y += sample.y;
    sum_difference += std::min(sample.difference, 30);  // the edges of lines are not noise
  }
  if (count == 0.0) return;
  const double moved = pinned::hypot(sum_b / count - b_, sum_r / count - r_);
  const bool another = known_ && moved > 0.5 * pinned::hypot(b_, r_);
  if (another && count < kShareOfAnother * static_cast<double>(samples_.size())) return;
  const double kept = known_ && !another ? parameters_.carpet_memory : 0.0;
  const auto mix = [&](double& old, double sum) { old = kept * old + (1.0 - kept) * sum / count; };
  mix(b_, sum_b);
  mix(r_, sum_r);
  mix(luma_, sum_y);
  mix(noise_, sum_difference);
  known_ = true;
}

/// After reading.
void CarpetColor::complete() {
  constexpr double kMostChroma = 128.0;
  constexpr double kMostLuma = 255.0;
  check_bytes(std::abs(b_) <= kMostChroma && std::abs(r_) <= kMostChroma && luma_ >= 0.0 && luma_ <= kMostLuma &&
                  noise_ >= 0.0 && noise_ <= kMostLuma,
              "the colour of the carpet is none");
  if (known_) prepare_thresholds();
}

void CarpetColor::prepare_thresholds() {
  constexpr double kUnit = 256.0;
  const double saturation = std::max(pinned::hypot(b_, r_), 1.0);
  const auto whole = [](double value) { return static_cast<int>(std::lround(value)); };
  hue_b_ = whole(kUnit * b_ / saturation);
  hue_r_ = whole(kUnit * r_ / saturation);
  usual_along_ = whole(kUnit * saturation);
  least_along_ = whole(kUnit * std::max(3.0, parameters_.carpet_saturation * saturation));
  most_along_ = whole(kUnit * (2.2 * saturation + 5.0));
  spread_ = whole(kUnit * (2.0 + 0.12 * saturation));
  brightest_ = whole(2.0 * luma_ + 20.0);
  darkest_ = whole(0.9 * luma_);
}

}  // namespace reorient
