// Every method that is compared, made from its parameters.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "perception/room/room_awareness.h"
#include "workbench/experiments/peers/dome_compass.h"
#include "workbench/experiments/peers/horizon_compass.h"
#include "workbench/experiments/peers/orientation_compass.h"
#include "workbench/experiments/peers/tile_row_compass.h"
#include "workbench/experiments/peers/transition_compass.h"

namespace reorient {

struct CompassParameters {
  RoomParameters room;        ///< of room awareness
  RoomParameters room_paper;  ///< of the recipe as it was published
  TransitionCompassParameters transitions;
  HorizonCompassParameters horizon;
  TileRowCompassParameters tile_row;
  TileRowCompassParameters tile_rows{.rows = 4, .top = 5.5};  ///< on the shipped wall
  DomeCompassParameters dome;
};

/// Calls visit(prefix, part) for each peer; room awareness has parameters of its own everywhere.
template <typename Visit>
void for_each_peer(CompassParameters& p, Visit&& visit) {
  visit("transition_compass", p.transitions);
  visit("horizon_compass", p.horizon);
  visit("tile_row_compass", p.tile_row);
  visit("tile_rows_compass", p.tile_rows);
  visit("dome_compass", p.dome);
}

/// In the order of kCompassMethods (compass_look.h).
std::vector<std::unique_ptr<OrientationCompass>> make_compasses(const CompassParameters& parameters,
                                                                std::uint64_t seed);

}  // namespace reorient
