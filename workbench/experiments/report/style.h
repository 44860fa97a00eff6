// SPDX-License-Identifier: MIT
// The style of a report: on light, dark, wide and narrow screens, and on paper.
#pragma once

#include <string_view>

namespace reorient {

/// Cascading style sheet. Colors of series are those of Okabe and Ito (2008), which color-blind people can distinguish;
/// dashes distinguish them without colors.
std::string_view report_style();

}  // namespace reorient
