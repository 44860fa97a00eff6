#include "perception/room/distinctiveness.h"

namespace reorient {

double distinctiveness(const BackgroundModel& model, const ComparedModel& compared, const Wall& wall) {
  double sum = 0.0;
  int pairs = 0;
  for (int tile = 0; tile < wall.tiles(); ++tile) {
    const int reflected = wall.reflected(tile);
    if (reflected < tile || !compared.trusted(tile) || !compared.trusted(reflected)) continue;
    sum += distance(Distance::hellinger, model[tile].mean, model[reflected].mean);
    ++pairs;
  }
  return pairs > 0 ? sum / pairs : 0.0;
}

}  // namespace reorient
