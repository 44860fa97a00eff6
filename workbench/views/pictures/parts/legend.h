// SPDX-License-Identifier: MIT
// Legends of the colors and marks of a picture.
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

/// Draws the entries in a column; returns the y below the last one.
double draw_legend_column(Canvas& canvas, const Pixel& top_left, std::span<const LegendEntry> entries,
                          double size = 19.0);

/// Draws the entries from left to right, in several lines if needed. Entries that do not fit into `box` are omitted.
void draw_legend_rows(Canvas& canvas, const Box& box, std::span<const LegendEntry> entries, double size = 19.0);

/// The text "flip", "purge" or "reset".
std::string short_name(Reorientation reorientation);

/// Symbols that several pictures share.
LegendEntry line_entry(Color color, double thickness, std::string meaning);
LegendEntry patch_entry(Color color, std::string meaning);
LegendEntry dot_entry(Color color, double radius, std::string meaning);

}  // namespace reorient::pictures
