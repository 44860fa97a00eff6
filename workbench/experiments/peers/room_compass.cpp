#include "workbench/experiments/peers/room_compass.h"

namespace reorient {

void RoomCompass::learn(const RoomObservation& view) {
  RoomObservation learned = view;
  learned.train = true;
  learned.evaluate = false;
  awareness_.update(learned);
}

double RoomCompass::compare(const RoomObservation& view) {
  RoomObservation compared = view;
  compared.train = false;
  compared.evaluate = true;
  const Confidences& confidences = awareness_.update(compared);
  return score_ == RoomScore::evidence ? confidences.evidence : confidences.opposite - confidences.current;
}

}  // namespace reorient
