// SPDX-License-Identifier: MIT
#include "perception/field/carpet/carpet_color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>

#include <Eigen/Cholesky>

#include "geometry/bytes.h"

namespace reorient {
namespace {

constexpr int kSampleColumns = 48;
constexpr int kSampleRows = 36;
constexpr std::size_t kFewestSamples = 40;
constexpr double kFewestFraction = 0.1;      // fraction of the samples that must have one color
constexpr double kFractionOfAnyColor = 0.6;  // fraction of them that must be near a color other than green
constexpr double kFractionOfAnother = 0.3;   // fraction above which another color can replace a known one
constexpr double kNear = 4.0;                // m

/// Whether any carpet can have this chroma under a good white balance: from yellowish to bluish green.
bool is_greenish(double b, double r) {
  constexpr double kLeast = 5.0;
  return r < 0.0 && -r >= 0.3 * std::abs(b) && b <= 3.0 - 0.3 * r && b * b + r * r >= kLeast * kLeast;
}

}  // namespace

CarpetColor::CarpetColor(const FieldFeatureParameters& parameters) : parameters_(parameters) {
  samples_.reserve(static_cast<std::size_t>(kSampleColumns) * kSampleRows);
}

CarpetColor::Terms CarpetColor::terms_at(double u, double v) {
  Terms terms;
  terms << 1.0, u, v, u * u, u * v, v * v;
  return terms;
}

void CarpetColor::observe(const ImageView& image, const GroundProjection& view) {
  width_ = image.width;
  height_ = image.height;
  columns_per_pixel_ = per_pixel(kColumns, width_);
  rows_per_pixel_ = per_pixel(kRows, height_);
  collect(image, view);
  learn();
  if (known_) prepare_parts();
}

/// Fits the color to the samples.
void CarpetColor::learn() {
  constexpr int kSteps = 4;  // from one color to the whole carpet
  if (samples_.size() < kFewestSamples) return;
  const auto fraction_of = [this](int count) {
    return static_cast<double>(count) / static_cast<double>(samples_.size());
  };
  Learned seen = learned_;
  const bool is_same_carpet = known_ && is_same_carpet_as(seen);
  if (!is_same_carpet) {
    const auto dominant = find_dominant();
    if (!dominant || (known_ && fraction_of(dominant->count) < kFractionOfAnother)) return;
    other_color_images_ = std::min(other_color_images_ + 1, parameters_.carpet_patience);
    seen = {};
    seen.blue[0] = dominant->b;
    seen.red[0] = dominant->r;
    Fit fitted;
    for (int step = 0; step < kSteps; ++step) {
      fitted = fit(seen);
      if (fitted.near == 0) return;
    }
    const bool is_green = is_greenish(fitted.chroma.x(), fitted.chroma.y());
    if (!is_green &&
        (other_color_images_ < parameters_.carpet_patience || fraction_of(fitted.near) < kFractionOfAnyColor))
      return;
    white_known_ = false;
  }
  other_color_images_ = 0;
  mix(seen, is_same_carpet ? parameters_.carpet_memory : 0.0);
  known_ = true;
}

/// Whether enough carpet is in view and the samples are carpet. An area of similar color beside the carpet would shift
/// the learned color step by step. Fits `seen`.
bool CarpetColor::is_same_carpet_as(Learned& seen) const {
  constexpr double kMostStep = 0.25, kLeastStep = 3.0;  // of the saturation; of chroma
  const Fit fitted = fit(seen);
  if (static_cast<double>(fitted.near) < kFewestFraction * static_cast<double>(samples_.size())) return false;
  const Eigen::Vector2d known = learned_.chroma_at(fitted.place);
  if (is_greenish(known.x(), known.y()) && !is_greenish(fitted.chroma.x(), fitted.chroma.y())) return false;
  return (fitted.chroma - known).norm() <= std::max(kLeastStep, kMostStep * known.norm());
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
      samples_.push_back({luma, pair[1] - 128, pair[3] - 128, std::abs(luma - (below[0] + below[2]) / 2),
                          2.0 * x / image.width - 1.0, 2.0 * y / image.height - 1.0});
    }
  }
}

/// The densest chroma among the samples. Green counts twice, since most carpets are green.
std::optional<CarpetColor::Dominant> CarpetColor::find_dominant() const {
  constexpr std::size_t kBins = 32;  // 4 steps of chroma each
  constexpr int kRange = 64;
  std::array<std::array<int, kBins>, kBins> histogram{};
  const auto bin = [](int chroma) {
    return static_cast<std::size_t>(std::clamp((chroma + kRange) / 4, 1, static_cast<int>(kBins) - 2));
  };
  for (const Sample& sample : samples_) ++histogram[bin(sample.b)][bin(sample.r)];
  const auto middle = [](std::size_t index) { return 4.0 * static_cast<double>(index) - kRange + 1.5; };

  Dominant best;
  int most = 0;
  for (std::size_t i = 1; i + 1 < kBins; ++i) {
    for (std::size_t j = 1; j + 1 < kBins; ++j) {
      int count = 0;
      for (std::size_t k = i - 1; k <= i + 1; ++k) count += histogram[k][j - 1] + histogram[k][j] + histogram[k][j + 1];
      const int weighted = is_greenish(middle(i), middle(j)) ? 2 * count : count;
      if (weighted <= most) continue;
      most = weighted;
      best = {middle(i), middle(j), count};
    }
  }
  const bool is_enough = static_cast<std::size_t>(best.count) >= kFewestSamples &&
                         best.count >= kFewestFraction * static_cast<double>(samples_.size());
  return is_enough ? std::optional(best) : std::nullopt;
}

/// Least squares over the samples near the color. The samples are selected again after each step, so the fit gradually
/// includes corners of another tint. A small constant is added to the squares of all terms except the mean, to
/// stabilize fits with few samples. If no samples are near, there are too few and the color is unchanged.
CarpetColor::Fit CarpetColor::fit(Learned& color) const {
  constexpr double kStiffness = 0.02, kLeastRadius = 6.0, kRadius = 0.6;  // of the carpet's saturation
  Eigen::Matrix<double, 6, 6> squares = Eigen::Matrix<double, 6, 6>::Zero();
  Terms blue = Terms::Zero(), red = Terms::Zero();
  double luma = 0.0, difference = 0.0, deviation = 0.0;
  int near = 0;
  for (const Sample& sample : samples_) {
    const Terms terms = terms_at(sample.u, sample.v);
    const double b = color.blue.dot(terms), r = color.red.dot(terms);
    const double off = (sample.b - b) * (sample.b - b) + (sample.r - r) * (sample.r - r);
    if (off > std::max(kLeastRadius * kLeastRadius, kRadius * kRadius * (b * b + r * r))) continue;
    squares.noalias() += terms * terms.transpose();
    blue += sample.b * terms;
    red += sample.r * terms;
    luma += sample.y;
    difference += std::min(sample.difference, 30);  // limited, since the edges of lines are not noise
    deviation += off;
    ++near;
  }
  if (near < static_cast<int>(kFewestSamples)) return {};
  Fit fitted{near, squares.col(0) / near, Eigen::Vector2d(blue[0], red[0]) / near};
  for (int i = 1; i < 6; ++i) squares(i, i) += kStiffness * near;
  const auto solver = squares.ldlt();
  color.blue = solver.solve(blue);
  color.red = solver.solve(red);
  color.luma = luma / near;
  color.noise = difference / near;
  color.deviation = std::sqrt(0.5 * deviation / near);
  return fitted;
}

void CarpetColor::mix(const Learned& seen, double kept) {
  const auto into = [kept](auto& old, const auto& value) { old = kept * old + (1.0 - kept) * value; };
  into(learned_.blue, seen.blue);
  into(learned_.red, seen.red);
  into(learned_.luma, seen.luma);
  into(learned_.noise, seen.noise);
  into(learned_.deviation, seen.deviation);
}

void CarpetColor::observe_white(const Eigen::Vector3d& less_carpet) {
  const double kept = white_known_ ? parameters_.carpet_memory : 0.0;
  white_less_carpet_ = kept * white_less_carpet_ + (1.0 - kept) * less_carpet;
  white_known_ = true;
}

double CarpetColor::tint_at(const Eigen::Vector2i& pixel, const Ycbcr& seen) const {
  if (!white_known_) return Eigen::Vector2d(seen.cb - 128, seen.cr - 128).norm() / std::max<int>(seen.y, 1);
  const Terms terms = terms_at(2.0 * pixel.x() / width_ - 1.0, 2.0 * pixel.y() / height_ - 1.0);
  const Eigen::Vector2d carpet = learned_.chroma_at(terms);
  const Eigen::Vector2d white = carpet + white_less_carpet(carpet), chroma(seen.cb - 128, seen.cr - 128);
  const double of_light = (chroma - seen.y * light_of(white)).norm();
  return std::min((chroma - white).norm(), of_light) / std::max<int>(seen.y, 1);
}

/// Checks values after reading.
void CarpetColor::check() const {
  constexpr double kMostChroma = 1000.0;  // limit of a term, since terms may cancel each other
  constexpr double kMostLuma = 255.0;
  const auto sound = [](double value, double most) { return value >= 0.0 && value <= most; };
  const auto is_chroma = [&](const auto& terms) { return (terms.array().abs() <= kMostChroma).all(); };
  check_bytes(sound(learned_.luma, kMostLuma) && sound(learned_.noise, kMostLuma) &&
                  sound(learned_.deviation, kMostLuma) && other_color_images_ >= 0 &&
                  other_color_images_ <= kMostCarpetPatience && is_chroma(learned_.blue) && is_chroma(learned_.red) &&
                  is_chroma(white_less_carpet_),
              "carpet color: a value is outside of the possible range");
}

void CarpetColor::prepare_parts() {
  for (int j = 0; j < kRows; ++j) {
    for (int i = 0; i < kColumns; ++i) {
      const double u = 2.0 * (i + 0.5) / kColumns - 1.0, v = 2.0 * (j + 0.5) / kRows - 1.0;
      const Terms terms = terms_at(u, v);
      parts_[static_cast<std::size_t>(j * kColumns + i)] = part_for(learned_.chroma_at(terms));
    }
  }
}

/// If the carpet differs from colorless surfaces by hardly more than noise, the cone would end within the noise. The
/// apex is then moved back. `no_color`: a colorless surface as bright as the carpet. `light`: its change with luma.
ChromaCone CarpetColor::cone_for(const Eigen::Vector2d& carpet, const Eigen::Vector2d& no_color,
                                 const Eigen::Vector2d& light) const {
  constexpr double kUnit = 256.0;
  constexpr double kLeastSaturation = 6.0, kDeviations = 4.0;
  const auto whole = [](double value) { return static_cast<int>(std::lround(value)); };
  const Eigen::Vector2d color = carpet - no_color;
  const double own = color.norm();
  const double saturation = std::max({own, kLeastSaturation, kDeviations * learned_.deviation});
  // Without a color, any direction is possible.
  const Eigen::Vector2d hue = own > 1.0 ? Eigen::Vector2d(color / own) : Eigen::Vector2d(-0.6, -0.8);
  const Eigen::Vector2d apex = carpet - saturation * hue - learned_.luma * light;
  ChromaCone cone;
  cone.apex_b = whole(kUnit * apex.x());
  cone.apex_r = whole(kUnit * apex.y());
  cone.light_b = whole(kUnit * light.x());
  cone.light_r = whole(kUnit * light.y());
  cone.hue_b = whole(kUnit * hue.x());
  cone.hue_r = whole(kUnit * hue.y());
  cone.least_along = whole(kUnit * std::max(3.0, parameters_.carpet_saturation * saturation));
  cone.most_along = whole(kUnit * (2.2 * saturation + 5.0));
  cone.spread = whole(kUnit * (2.0 + 0.12 * saturation));
  return cone;
}

/// The change of chroma of colorless surfaces with luma, for a tint of the light.
Eigen::Vector2d CarpetColor::light_of(const Eigen::Vector2d& white) const {
  return white / std::max(1.0, learned_.luma + white_less_carpet_.x());
}

CarpetPart CarpetColor::part_for(const Eigen::Vector2d& carpet) const {
  const Eigen::Vector2d white = carpet + white_less_carpet(carpet);
  const Eigen::Vector2d light = light_of(white);
  CarpetPart part;
  part.added = cone_for(carpet, white, Eigen::Vector2d::Zero());
  part.of_light = cone_for(carpet, learned_.luma * light, light);
  part.brightest = static_cast<int>(std::lround(2.0 * learned_.luma + 20.0));
  part.darkest = static_cast<int>(std::lround(0.9 * learned_.luma));
  return part;
}

}  // namespace reorient
