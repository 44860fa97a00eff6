// SPDX-License-Identifier: MIT
#include "program/look/pitch_search.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/angle.h"
#include "geometry/camera_attitude.h"
#include "perception/field/field_features.h"
#include "perception/field/ground_projection.h"
#include "program/look/line_stripes.h"
#include "workbench/field_images/still_image.h"

namespace reorient {
namespace {

constexpr double kLowest = -20.0, kHighest = 45.0;  // degrees
constexpr double kSearchStep = 0.5;
constexpr double kMostRoll = 8.0, kRollStep = 2.0;  // degrees
constexpr double kUsualRoll = 2.5;                  // degrees, deviation for a walking robot or a hand-held camera
constexpr double kStripeStep = 2.5;                 // between the pitches at which stripes are searched
constexpr std::size_t kMostStripes = 300;
constexpr int kDirections = 30;  // of the field, within 90 degrees

// Standard deviations of the measurements. Each mixture has a fraction of stripes that are not straight lines.
constexpr double kWidthError = 0.15;  // of a line's width
constexpr double kEdgeError = 0.5;    // pixels, of a width
constexpr double kTangentError = 2.5 * kPi / 180.0;
constexpr double kOtherWidths = 0.2, kWidthRange = 4.0;  // fraction; range of the width's logarithm
constexpr double kOtherDirections = 0.3;

double normal_density(double off, double deviation) {
  const double ratio = off / deviation;
  return std::exp(-0.5 * ratio * ratio) / (deviation * std::sqrt(2.0 * kPi));
}

double width_deviation(const LineStripe& stripe) { return std::hypot(kWidthError, kEdgeError / stripe.width); }

/// A stripe on the ground, computed for one pitch.
struct GroundStripe {
  double width = 0.0;      ///< pixels that a field line there would be wide
  double direction = 0.0;  ///< rad on the ground, along the stripe
  double tilt = 1.0;       ///< rotation of the image's tangent in rad for a rotation by 1 rad on the ground
};

std::optional<GroundStripe> on_ground(const GroundProjection& view, const LineStripe& stripe, double line_width) {
  constexpr double kStep = 0.5;  // pixels
  const Eigen::Vector2d across(-stripe.tangent.y(), stripe.tangent.x());
  const auto slope = [&](const Eigen::Vector2d& step) -> std::optional<Eigen::Vector2d> {
    const auto before = view.ground(stripe.pixel - kStep * step), after = view.ground(stripe.pixel + kStep * step);
    if (!before || !after) return std::nullopt;
    return Eigen::Vector2d((*after - *before) / (2.0 * kStep));
  };
  const auto along_slope = slope(stripe.tangent), across_slope = slope(across);
  if (!along_slope || !across_slope) return std::nullopt;
  const double length = along_slope->norm();
  if (!(length > 1e-9)) return std::nullopt;
  const Eigen::Vector2d normal(-along_slope->y() / length, along_slope->x() / length);
  const double meters = std::abs(across_slope->dot(normal));  // across the line, for a pixel
  if (!(meters > 1e-9)) return std::nullopt;
  return GroundStripe{line_width / meters, direction_of(*along_slope), length / meters};
}

/// Likelihood of the stripes and the carpet for one pitch at a time.
class PitchLikelihood {
 public:
  PitchLikelihood(const CameraModel& camera, std::vector<LineStripe> stripes, std::vector<float> boundary,
                  double line_width)
      : camera_(camera), stripes_(std::move(stripes)), boundary_(std::move(boundary)), line_width_(line_width) {}

  /// The log-likelihood, up to a constant.
  double operator()(const Isometry3& robot_from_camera) const {
    const auto view = GroundProjection::look(camera_, robot_from_camera);
    if (!view) return -1e6;
    // Errors of adjacent stripes are correlated: reduce their weight, and the weight of many stripes.
    constexpr double kTogether = 8.0, kMost = 15.0;
    const double weight =
        std::min(1.0 / kTogether, kMost / std::max<double>(1.0, static_cast<double>(stripes_.size())));
    double sum = carpet_below_horizon(*view);
    std::vector<double> directions(kDirections, 0.0);
    for (const LineStripe& stripe : stripes_) {
      const auto ground = on_ground(*view, stripe, line_width_);
      if (!ground) {
        constexpr double kAboveHorizon = 0.1;
        sum += weight * std::log(kAboveHorizon * kOtherWidths / kWidthRange);
        for (double& direction : directions) direction += weight * std::log(kOtherDirections / kPi);
        continue;
      }
      const double off = std::log(stripe.width / ground->width);
      sum += weight *
             std::log((1.0 - kOtherWidths) * normal_density(off, width_deviation(stripe)) + kOtherWidths / kWidthRange);
      for (int i = 0; i < kDirections; ++i)
        directions[static_cast<std::size_t>(i)] += weight * std::log(direction_density(*ground, i));
    }
    const double best = *std::max_element(directions.begin(), directions.end());
    double mean = 0.0;
    for (const double direction : directions) mean += std::exp(direction - best) / kDirections;
    return sum + best + std::log(mean);
  }

  /// Stripes that are as wide as a line, within two deviations.
  int fitting(const Isometry3& robot_from_camera) const {
    const auto view = GroundProjection::look(camera_, robot_from_camera);
    if (!view) return 0;
    return static_cast<int>(std::count_if(stripes_.begin(), stripes_.end(), [&](const LineStripe& stripe) {
      const auto ground = on_ground(*view, stripe, line_width_);
      return ground && std::abs(std::log(stripe.width / ground->width)) < 2.0 * width_deviation(stripe);
    }));
  }

 private:
  /// Log-likelihood of the image's tangent if the field's lines run in the direction `index` and across it.
  static double direction_density(const GroundStripe& stripe, int index) {
    constexpr double kQuarter = 0.5 * kPi;
    const double turn = stripe.direction - (index + 0.5) * kQuarter / kDirections;
    const double off = turn - kQuarter * std::round(turn / kQuarter);
    // The steps between the tried directions add an error.
    const double deviation = std::hypot(kTangentError, 0.3 * kQuarter / kDirections * stripe.tilt);
    return (1.0 - kOtherDirections) * 0.5 * normal_density(off * stripe.tilt, deviation) + kOtherDirections / kPi;
  }

  double carpet_below_horizon(const GroundProjection& view) const {
    constexpr double kWeight = 5.0, kRest = 0.02;
    const double margin = 0.01 * camera_.height;
    int columns = 0, above = 0;
    for (std::size_t i = 0; i < boundary_.size(); ++i) {
      if (boundary_[i] >= static_cast<float>(camera_.height)) continue;
      const double column = (static_cast<double>(i) + 0.5) * camera_.width / static_cast<double>(boundary_.size());
      ++columns;
      above += boundary_[i] < view.horizon(column) - margin ? 1 : 0;
    }
    if (columns == 0) return 0.0;
    return kWeight * std::log(1.0 - static_cast<double>(above) / columns + kRest);
  }

  CameraModel camera_;
  std::vector<LineStripe> stripes_;
  std::vector<float> boundary_;
  double line_width_;
};

std::vector<LineStripe> thinned(std::vector<LineStripe> stripes) {
  if (stripes.size() <= kMostStripes) return stripes;
  std::vector<LineStripe> some;
  for (std::size_t i = 0; i < kMostStripes; ++i) some.push_back(stripes[i * stripes.size() / kMostStripes]);
  return some;
}

/// All carpet in the image, independent of the horizon: as if the camera looked far down.
std::vector<float> carpet_boundary(const ImageView& image, const CameraModel& camera, const Isometry3& attitude,
                                   const FieldFeatureParameters& parameters, const FieldDimensions& field) {
  FieldFeatures features(parameters, field);
  FieldPercept percept;
  features.find(image, camera, with_pitch(attitude, from_degrees(kHighest)), percept);
  return percept.boundary;
}

/// A roll relative to the expected one.
struct TriedRoll {
  double degrees = 0.0;
  double prior = 0.0;  ///< logarithm, up to a constant
};

std::vector<TriedRoll> rolls_to_try(bool roll_is_known) {
  if (roll_is_known) return {{0.0, 0.0}};
  std::vector<TriedRoll> rolls;
  for (double roll = -kMostRoll; roll <= kMostRoll; roll += kRollStep)
    rolls.push_back({roll, -0.5 * roll * roll / (kUsualRoll * kUsualRoll)});
  return rolls;
}

/// The probability of the pitches, summed over the rolls.
struct PitchPosterior {
  double pitch = 0.0;      ///< degrees, the mean around the most likely one
  double roll = 0.0;       ///< degrees against the expected one, the same
  double deviation = 0.0;  ///< degrees, of all pitches from the most likely one
  double near = 0.0;       ///< probability within kNear of the most likely one
};

constexpr double kNear = 2.0;  // degrees

PitchPosterior posterior_of(const PitchLikelihood& likelihood, const Isometry3& robot_from_camera,
                            const std::vector<TriedRoll>& rolls) {
  struct Tried {
    double pitch, roll, likelihood;
  };
  std::vector<Tried> all;
  const double expected = roll_of(robot_from_camera);
  for (double pitch = kLowest; pitch <= kHighest; pitch += kSearchStep) {
    for (const TriedRoll& roll : rolls) {
      const Isometry3 attitude =
          with_attitude(robot_from_camera, from_degrees(pitch), expected + from_degrees(roll.degrees));
      all.push_back({pitch, roll.degrees, likelihood(attitude) + roll.prior});
    }
  }
  const Tried best = *std::max_element(all.begin(), all.end(),
                                       [](const Tried& a, const Tried& b) { return a.likelihood < b.likelihood; });
  double sum = 0.0, near = 0.0, pitch = 0.0, roll = 0.0, squares = 0.0;
  for (const Tried& tried : all) {
    const double share = std::exp(tried.likelihood - best.likelihood), off = tried.pitch - best.pitch;
    sum += share;
    squares += share * off * off;
    if (std::abs(off) > kNear) continue;
    near += share;
    pitch += share * tried.pitch;
    roll += share * tried.roll;
  }
  return {pitch / near, roll / near, std::sqrt(squares / sum), near / sum};
}

}  // namespace

PitchEstimate search_pitch(const ImageView& image, const CameraModel& camera, const Isometry3& robot_from_camera,
                           bool roll_is_known, const FieldFeatureParameters& parameters, const FieldDimensions& field) {
  std::vector<Isometry3> attitudes;
  for (double pitch = kLowest; pitch <= kHighest; pitch += kStripeStep)
    attitudes.push_back(with_pitch(robot_from_camera, from_degrees(pitch)));
  const FieldFeatureParameters still = for_still_image(parameters);
  LineStripes found = find_line_stripes(image, camera, attitudes, still, field);
  const std::vector<LineStripe> stripes = thinned(std::move(found.stripes));
  const std::vector<float> boundary = carpet_boundary(image, camera, robot_from_camera, still, field);
  PitchEstimate estimate;
  estimate.stripes = static_cast<int>(stripes.size());
  const PitchLikelihood likelihood(camera, stripes, boundary, field.line_width);
  const PitchPosterior posterior = posterior_of(likelihood, robot_from_camera, rolls_to_try(roll_is_known));

  // An error of all widths of an image does not average out: the camera's gamma may differ from the usual one, and
  // white may be brighter than thin lines show.
  struct Bias {
    double pixels, factor;
  };
  constexpr double kPixels = 0.3, kFactor = 0.7, kThinnest = 0.3;
  std::vector<Bias> biases{{-kPixels, 1.0}, {kPixels, 1.0}};
  if (!found.contrast_is_known) biases.push_back({0.0, kFactor});
  double systematic = 0.0;  // degrees
  for (const Bias& bias : biases) {
    std::vector<LineStripe> others = stripes;
    for (LineStripe& stripe : others) stripe.width = std::max(kThinnest, bias.factor * stripe.width + bias.pixels);
    const PitchLikelihood other(camera, others, boundary, field.line_width);
    const PitchPosterior shifted = posterior_of(other, robot_from_camera, {{posterior.roll, 0.0}});
    systematic = std::max(systematic, std::abs(shifted.pitch - posterior.pitch));
  }
  const double deviation = std::hypot(posterior.deviation, systematic);
  estimate.pitch = from_degrees(posterior.pitch);
  estimate.roll = roll_of(robot_from_camera) + from_degrees(posterior.roll);
  estimate.deviation = from_degrees(deviation);
  estimate.certainty = std::min(posterior.near, std::erf(kNear / (deviation * std::sqrt(2.0))));
  estimate.fitting = likelihood.fitting(with_attitude(robot_from_camera, estimate.pitch, estimate.roll));
  constexpr double kSure = 0.6;
  constexpr int kFewest = 20;
  estimate.known =
      estimate.certainty >= kSure && estimate.fitting >= kFewest && 2 * estimate.fitting >= estimate.stripes;
  return estimate;
}

}  // namespace reorient
