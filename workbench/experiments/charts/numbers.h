// SPDX-License-Identifier: MIT
// Numbers as text for readers, independent of the locale.
#pragma once

#include <optional>
#include <string>

#include "workbench/experiments/statistics/interval.h"

namespace reorient {

/// With this number of decimal digits; a dash for a number that is not finite.
std::string fixed(double value, int digits);

/// The same; a dash for an unknown number.
std::string fixed(const std::optional<double>& value, int digits);

/// A difference: "+1.2", or with a true minus sign.
std::string with_sign(double value, int digits);

/// "[1.2, 3.4]".
std::string fixed(const Interval& interval, int digits);

/// "30 %" of 0.3.
std::string percent(double share);

/// "0.013", or "< 0.001".
std::string p_value(double p);

}  // namespace reorient
