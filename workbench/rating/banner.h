// SPDX-License-Identifier: MIT
// Adds a colored banner to the model of a room, as if the room were learned again with it.
#pragma once

#include "perception/room/background_model.h"
#include "perception/room/saved_model.h"
#include "perception/room/wall/wall.h"

namespace reorient {

struct Banner {
  double azimuth = 0.0;  ///< rad, of its middle, seen from the field's center
  double width = 2.0;    ///< m, along the virtual wall
  double foot = 1.0;     ///< m above the ground
  double height = 1.5;   ///< m
  int color = 2;         ///< bin of the histogram that contains its color
};

/// The colored bin (neither black nor white) that is rarest in the known tiles.
int rarest_color(const BackgroundModel& model);

/// "bright, blue and red above gray", as perception/room/color/color_histogram.h defines the bin.
const char* color_in_words(int bin);

/// Known tiles contain the banner where it covers them. Unknown tiles stay unknown.
SavedModel with_banner(const SavedModel& model, const Banner& banner);

}  // namespace reorient
