// SPDX-License-Identifier: MIT
// A colored banner that is hung on the wall of a room, as its model would be if it were learned again.
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
  int color = 2;         ///< bin of the histogram that all of it shows
};

/// The colored bin (neither black nor white) of which the known tiles contain least.
int rarest_color(const BackgroundModel& model);

/// "bright, blue and red above gray", as perception/room/color/color_histogram.h defines the bin.
const char* color_in_words(int bin);

/// Each known tile shows the banner where it covers it. Unknown tiles stay unknown.
SavedModel with_banner(const SavedModel& model, const Banner& banner);

}  // namespace reorient
