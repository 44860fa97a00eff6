// SPDX-License-Identifier: MIT
// All compared methods, created from their parameters.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "perception/room/room_awareness.h"
#include "workbench/experiments/peers/corner_compass.h"
#include "workbench/experiments/peers/dome_compass.h"
#include "workbench/experiments/peers/horizon_compass.h"
#include "workbench/experiments/peers/orientation_compass.h"
#include "workbench/experiments/peers/tile_row_compass.h"
#include "workbench/experiments/peers/transition_compass.h"

namespace reorient {

/// Parameters of learning and evaluation for all methods.
struct ComparisonParameters {
  double learn_mirrored = 0.0;
  double mirrored_after = 0.0;
};
template <typename Visit>
void describe(ComparisonParameters& p, Visit&& visit) {
  visit("learn_mirrored", p.learn_mirrored, 0.0, 600.0, "s",
        "time at the start of learning in which the methods learn from the mirrored pose instead of the right one");
  visit("mirrored_after", p.mirrored_after, 0.0, 600.0, "s",
        "time for which a look shows the right pose before one copy of each method is shown the mirrored pose");
}

struct CompassParameters {
  ComparisonParameters comparison;
  RoomParameters room;        ///< of room awareness
  RoomParameters room_paper;  ///< of the published recipe
  TransitionCompassParameters transitions;
  HorizonCompassParameters horizon;
  TileRowCompassParameters tile_row;
  TileRowCompassParameters tile_rows{.rows = 4, .top = 5.5};  ///< on the shipped wall
  DomeCompassParameters dome;
  CornerCompassParameters corners;
};

/// Calls visit(prefix, part) for the comparison and for each peer; room awareness has its own parameters in all
/// programs.
template <typename Visit>
void for_each_peer(CompassParameters& p, Visit&& visit) {
  visit("comparison", p.comparison);
  visit("transition_compass", p.transitions);
  visit("horizon_compass", p.horizon);
  visit("tile_row_compass", p.tile_row);
  visit("tile_rows_compass", p.tile_rows);
  visit("dome_compass", p.dome);
  visit("corner_compass", p.corners);
}

/// In the order of kCompassMethods (compass_look.h).
std::vector<std::unique_ptr<OrientationCompass>> make_compasses(const CompassParameters& parameters,
                                                                std::uint64_t seed);

}  // namespace reorient
