// SPDX-License-Identifier: MIT
#include "program/look/line_stripes.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "perception/field/field_features.h"

namespace reorient {
namespace {

constexpr double kProfileStep = 0.5;    // pixels
constexpr double kLeastContrast = 8.0;  // luma

/// Light across a stripe.
struct StripeProfile {
  double contrast = 0.0;  ///< brightest value above the carpet on both sides
  double light = 0.0;     ///< sum of the light above the carpet, in pixels times light
  double own_width() const { return light / contrast; }
};

std::optional<double> luma_at(const ImageView& image, const Eigen::Vector2d& where) {
  const int x = static_cast<int>(std::floor(where.x())), y = static_cast<int>(std::floor(where.y()));
  if (x < 0 || y < 0 || x + 1 >= image.width || y + 1 >= image.height) return std::nullopt;
  const double u = where.x() - x, v = where.y() - y;
  return (1.0 - v) * ((1.0 - u) * image.luma(x, y) + u * image.luma(x + 1, y)) +
         v * ((1.0 - u) * image.luma(x, y + 1) + u * image.luma(x + 1, y + 1));
}

/// A lens blurs light before the sensor codes it with a gamma, so bright stripes look wider in coded values. Uses the
/// gamma of sRGB, as nearly all cameras do.
double light_of(double luma) { return 255.0 * std::pow(luma / 255.0, 2.2); }

/// One side of a stripe: distance from the brightest point at which luma is halfway to the carpet's.
struct StripeSide {
  double half = 0.0;    ///< pixels
  double carpet = 0.0;  ///< light
};

std::optional<StripeSide> side_of(const ImageView& image, const Eigen::Vector2d& brightest,
                                  const Eigen::Vector2d& outwards, double peak) {
  const double farthest = image.width / 6.0;
  double reach = 3.0;
  while (reach < farthest) {
    double darkest = peak;
    for (double s = 0.0; s <= reach; s += kProfileStep) {
      const auto luma = luma_at(image, brightest + s * outwards);
      if (!luma) return std::nullopt;
      darkest = std::min(darkest, *luma);
    }
    const double level = 0.5 * (peak + darkest);
    double half = 0.0;
    while (luma_at(image, brightest + half * outwards).value_or(0.0) > level) half += kProfileStep;
    if (peak - darkest >= kLeastContrast && reach >= 2.0 * half + 3.0) {
      double sum = 0.0;
      int count = 0;
      for (double s = half + 1.5; s <= half + 1.5 + std::max(2.0, half); s += kProfileStep, ++count) {
        const auto luma = luma_at(image, brightest + s * outwards);
        if (!luma) return std::nullopt;
        sum += light_of(*luma);
      }
      return StripeSide{half, sum / count};
    }
    reach *= 1.5;
  }
  return std::nullopt;
}

std::optional<StripeProfile> profile_of(const ImageView& image, const Eigen::Vector2d& center,
                                        const Eigen::Vector2d& across) {
  constexpr double kSearch = 2.0, kMargin = 2.0;  // pixels
  double peak = -1.0, at = 0.0;
  for (double s = -kSearch; s <= kSearch; s += kProfileStep) {
    const auto luma = luma_at(image, center + s * across);
    if (!luma || *luma <= peak) continue;
    peak = *luma;
    at = s;
  }
  const Eigen::Vector2d brightest = center + at * across;
  const auto left = side_of(image, brightest, -across, peak), right = side_of(image, brightest, across, peak);
  if (!left || !right) return std::nullopt;
  StripeProfile profile;
  profile.contrast = light_of(peak) - 0.5 * (left->carpet + right->carpet);
  if (profile.contrast <= 0.0 || std::abs(left->carpet - right->carpet) > profile.contrast) return std::nullopt;
  const double from = -left->half - kMargin, to = right->half + kMargin;
  for (double s = from; s <= to; s += kProfileStep) {
    const double share = (s - from) / (to - from);
    const double carpet = (1.0 - share) * left->carpet + share * right->carpet;
    const auto luma = luma_at(image, brightest + s * across);
    if (luma) profile.light += kProfileStep * (light_of(*luma) - carpet);
  }
  if (profile.light <= 0.0) return std::nullopt;
  return profile;
}

double quantile_of(std::vector<double> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

/// The contrast of white against the carpet, and from which width on a stripe shows all of it.
struct WhiteContrast {
  double light = 0.0;
  double wide = 0.0;      ///< pixels
  bool is_known = false;  ///< false: no stripe is wide

  bool shows_all(const StripeProfile& profile) const {
    constexpr double kShadow = 0.5;
    return profile.own_width() >= wide && profile.contrast >= kShadow * light;
  }
};

/// Blur spreads a thin stripe to a width that no stripe in the image is below, and lowers its contrast. So a stripe is
/// wide only if it is clearly wider than the thinnest ones, and not much fainter than the clearest ones.
WhiteContrast white_contrast(const std::vector<StripeProfile>& profiles) {
  constexpr double kLeastWide = 4.0;  // pixels
  constexpr double kAboveBlur = 1.6;  // a Gaussian blur then takes 5 % of the contrast
  constexpr std::size_t kFewest = 5;
  std::vector<double> contrasts, widths, of_wide;
  for (const StripeProfile& profile : profiles) {
    contrasts.push_back(profile.contrast);
    widths.push_back(profile.own_width());
  }
  WhiteContrast white{quantile_of(contrasts, 0.9), std::max(kLeastWide, kAboveBlur * quantile_of(widths, 0.1)), false};
  for (const StripeProfile& profile : profiles)
    if (white.shows_all(profile)) of_wide.push_back(profile.contrast);
  white.is_known = of_wide.size() >= kFewest;
  if (white.is_known) white.light = quantile_of(of_wide, 0.5);
  return white;
}

/// Its projection into the image; nothing if the camera cannot project the line.
std::optional<Eigen::Vector2d> tangent_of(const LinePoint& point, const CameraModel& camera,
                                          const Isometry3& camera_from_robot) {
  constexpr double kReach = 0.03;  // m
  const Eigen::Vector2d along = kReach * Eigen::Vector2d(-std::sin(point.normal), std::cos(point.normal));
  const auto pixel = [&](const Eigen::Vector2d& place) {
    return camera.project(camera_from_robot * Eigen::Vector3d(place.x(), place.y(), 0.0));
  };
  const auto one = pixel(point.position - along), other = pixel(point.position + along);
  if (!one || !other || (*other - *one).norm() < 1e-6) return std::nullopt;
  return (*other - *one).normalized();
}

}  // namespace

LineStripes find_line_stripes(const ImageView& image, const CameraModel& camera, std::span<const Isometry3> attitudes,
                              const FieldFeatureParameters& parameters, const FieldDimensions& field) {
  constexpr double kCell = 2.0;  // pixels; closer points count as one
  std::set<std::pair<long, long>> known;
  std::vector<LineStripe> stripes;
  std::vector<StripeProfile> profiles;
  FieldPercept percept;
  for (const Isometry3& attitude : attitudes) {
    FieldFeatures features(parameters, field);
    features.find(image, camera, attitude, percept);
    const Isometry3 camera_from_robot = attitude.inverse();
    for (const LinePoint& point : percept.line_points) {
      const Eigen::Vector2d pixel = point.pixel.cast<double>();
      const auto tangent = tangent_of(point, camera, camera_from_robot);
      if (!tangent) continue;
      const auto profile = profile_of(image, pixel, {-tangent->y(), tangent->x()});
      if (!profile) continue;
      if (!known.emplace(std::lround(pixel.x() / kCell), std::lround(pixel.y() / kCell)).second) continue;
      stripes.push_back({pixel, *tangent, 0.0});
      profiles.push_back(*profile);
    }
  }
  if (stripes.empty()) return {};
  const WhiteContrast white = white_contrast(profiles);
  for (std::size_t i = 0; i < stripes.size(); ++i) {
    const StripeProfile& profile = profiles[i];
    stripes[i].width =
        white.shows_all(profile) ? profile.own_width() : profile.light / std::max(profile.contrast, white.light);
  }
  return {std::move(stripes), white.is_known};
}

}  // namespace reorient
