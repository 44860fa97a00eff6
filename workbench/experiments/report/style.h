// SPDX-License-Identifier: MIT
// How a report looks: on a screen, light or dark, wide or narrow, and on paper.
#pragma once

#include <string_view>

namespace reorient {

/// Cascading style sheet. Colors of series are those of Okabe and Ito (2008), which color-blind people can distinguish;
/// dashes distinguish them without colors.
std::string_view report_style();

}  // namespace reorient
