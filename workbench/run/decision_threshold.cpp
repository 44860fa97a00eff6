// SPDX-License-Identifier: MIT
#include "workbench/run/decision_threshold.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>
#include <variant>

#include "geometry/pinned_math.h"

namespace reorient {
namespace {

std::optional<double> number_of(const std::vector<Parameter>& parameters, std::string_view name) {
  const auto found =
      std::find_if(parameters.begin(), parameters.end(), [&](const auto& one) { return one.name == name; });
  if (found == parameters.end() || !std::holds_alternative<double>(found->value)) return std::nullopt;
  return std::get<double>(found->value);
}

/// `chances`: the parameter with the number of chances per hour for a wrong decision.
double threshold_of(const std::vector<Parameter>& parameters, std::string_view chances) {
  const std::optional<double> number = number_of(parameters, chances);
  const std::optional<double> false_flips = number_of(parameters, "decision.false_flips");
  const std::optional<double> least = number_of(parameters, "decision.least");
  if (!number || !false_flips || !least) return 0.0;
  const double threshold = std::max(*least, pinned::log(*number / *false_flips));
  return std::isfinite(threshold) ? threshold : 0.0;
}

}  // namespace

double unconfirmed_threshold(const std::vector<Parameter>& parameters) {
  return threshold_of(parameters, "decision.disturbances");
}

double confirmed_threshold(const std::vector<Parameter>& parameters) {
  return threshold_of(parameters, "decision.looks");
}

void DecisionThreshold::observe(const FrameRecord& frame) {
  if (!frame.filled.has(kTopic)) return;
  if (is_read_ && frame.parameter_changes.empty() && frame.reloads.empty()) return;
  value_ = unconfirmed_threshold(frame.parameters);
  is_read_ = true;
}

}  // namespace reorient
