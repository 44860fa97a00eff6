// SPDX-License-Identifier: MIT
// What the colors and marks of a picture mean.
#pragma once

#include <functional>
#include <span>
#include <string>

#include "engine/world/commands.h"
#include "workbench/views/pictures/canvas/canvas.h"

namespace reorient::pictures {

struct LegendEntry {
  std::function<void(Canvas&, const Pixel& center)> symbol;  ///< at most 36 x 20 pixels
  std::string meaning;
};

/// One entry below the other; returns the y below the last one.
double draw_legend_column(Canvas& canvas, const Pixel& top_left, std::span<const LegendEntry> entries,
                          double size = 19.0);

/// Entries from left to right, in as many lines as `box` needs; what does not fit into its height is left out.
void draw_legend_rows(Canvas& canvas, const Box& box, std::span<const LegendEntry> entries, double size = 19.0);

/// "flip", "purge" or "reset".
std::string short_name(Reorientation reorientation);

/// Symbols that several pictures share.
LegendEntry line_entry(Color color, double thickness, std::string meaning);
LegendEntry patch_entry(Color color, std::string meaning);
LegendEntry dot_entry(Color color, double radius, std::string meaning);

}  // namespace reorient::pictures
