// SPDX-License-Identifier: MIT
// Random observations of a room of which only the model is known.
#pragma once

#include <vector>

#include "geometry/random.h"
#include "perception/room/background_model.h"
#include "perception/room/wall/wall.h"

namespace reorient {

/// One histogram for each tile of the wall, which a robot observes in every frame: the deviation of a tile from the
/// model persists from frame to frame, so the histograms are constant during a trial.
using Looks = std::vector<ColorHistogram>;

/// Draws them: the model's mean, plus its standard deviation times `scale` times a normal number in each bin. A tile
/// that is not known for `trusted_after` seconds has the colors of a random known tile of its row. The same amount of
/// random numbers is used for any contents of the model, so that two models can be compared with the same ones.
Looks draw_looks(const BackgroundModel& model, const Wall& wall, double trusted_after, double scale, Random random);

/// The scale with which observations differ from the known tiles of the model by `misfit` on average (Hellinger
/// distance, 0 to 1). The nearest possible one, because bins without variance never differ.
double scale_for_misfit(const BackgroundModel& model, const Wall& wall, double trusted_after, double misfit);

}  // namespace reorient
