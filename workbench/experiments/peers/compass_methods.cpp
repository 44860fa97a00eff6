// SPDX-License-Identifier: MIT
#include "workbench/experiments/peers/compass_methods.h"

#include "workbench/experiments/peers/room_compass.h"

namespace reorient {

std::vector<std::unique_ptr<OrientationCompass>> make_compasses(const CompassParameters& parameters,
                                                                std::uint64_t seed) {
  std::vector<std::unique_ptr<OrientationCompass>> compasses;
  compasses.push_back(std::make_unique<RoomCompass>(parameters.room, RoomScore::evidence, seed));
  compasses.push_back(std::make_unique<RoomCompass>(parameters.room_paper, RoomScore::confidences, seed));
  compasses.push_back(std::make_unique<TransitionCompass>(parameters.transitions, seed));
  compasses.push_back(std::make_unique<HorizonCompass>(parameters.horizon));
  compasses.push_back(std::make_unique<TileRowCompass>(parameters.tile_row));
  compasses.push_back(std::make_unique<TileRowCompass>(parameters.tile_rows));
  compasses.push_back(std::make_unique<DomeCompass>(parameters.dome));
  compasses.push_back(std::make_unique<CornerCompass>(parameters.corners));
  return compasses;
}

}  // namespace reorient
