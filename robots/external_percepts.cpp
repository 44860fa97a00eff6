// SPDX-License-Identifier: MIT
#include "robots/external_percepts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

namespace reorient {
namespace {

constexpr double kFarthest = 100.0, kFarthestPixel = 1e4, kLargest = 10.0;  // m, pixels, m

bool is_in(double value, double least, double most) { return value >= least && value <= most; }  // false for NaN

bool is_box(const ExternalPercept& percept) {
  return percept.type == PerceptType::robot || percept.type == PerceptType::person;
}

/// How many of the numbers in `at` the type uses.
std::size_t numbers_of(const ExternalPercept& percept) {
  const bool is_on_ground = percept.space == PerceptSpace::ground;
  if (percept.type == PerceptType::line || is_box(percept)) return 4;
  if (percept.type == PerceptType::goal_post) return is_on_ground ? 2 : 4;
  if (percept.type == PerceptType::ball) return is_on_ground ? 2 : 3;
  return 2;
}

std::string mistake_in_shape(const ExternalPercept& percept) {
  const std::array<double, 4>& at = percept.at;
  if (percept.space == PerceptSpace::ground) {
    if (is_box(percept) && !(is_in(at[2], 0.0, kLargest) && is_in(at[3], 0.0, kLargest)))
      return "width, height: expected 0 to 10 m";
    return "";
  }
  if (is_box(percept) && !(at[0] <= at[2] && at[1] <= at[3])) return "at: expected left <= right and top <= bottom";
  if (percept.type == PerceptType::ball && !(at[2] > 0.0)) return "radius: expected more than 0 pixels";
  if (percept.type == PerceptType::goal_post && !(at[3] < at[1])) return "at: expected the top above the base";
  return "";
}

std::string mistake_in_numbers(const ExternalPercept& percept) {
  if (!is_in(percept.confidence, 0.0, 1.0))
    return "confidence: expected 0 to 1, found " + std::to_string(percept.confidence);
  const double most = percept.space == PerceptSpace::ground ? kFarthest : kFarthestPixel;
  for (const double number : std::span(percept.at).first(numbers_of(percept))) {
    if (!is_in(number, -most, most))
      return std::string("at: expected ") +
             (percept.space == PerceptSpace::ground ? "-100 to 100 m" : "-10000 to 10000 pixels") + ", found " +
             std::to_string(number);
  }
  if (percept.direction && !is_in(*percept.direction, -kLargest, kLargest))
    return "direction: expected -10 to 10 rad, found " + std::to_string(*percept.direction);
  if (percept.type == PerceptType::line_point && !percept.direction) return "direction: missing";
  if (!percept.covariance) return "";
  const auto [xx, xy, yy] = *percept.covariance;
  constexpr double kMost = 1e6;
  if (!(xx > 0.0 && xx <= kMost && yy > 0.0 && yy <= kMost && xy * xy <= xx * yy))
    return "covariance: expected a positive definite matrix of at most 1e6";
  return "";
}

}  // namespace

std::string_view to_string(PerceptType type) {
  constexpr std::array<std::string_view, 11> kNames{
      "line",         "line point",    "goal post", "L intersection", "T intersection", "X intersection",
      "penalty mark", "center circle", "ball",      "robot",          "person"};
  return kNames.at(static_cast<std::size_t>(type));
}

std::string mistake_in(const ExternalPercept& percept) {
  std::string mistake = mistake_in_numbers(percept);
  if (mistake.empty()) mistake = mistake_in_shape(percept);
  return mistake.empty() ? "" : std::string(to_string(percept.type)) + ": " + mistake;
}

}  // namespace reorient
