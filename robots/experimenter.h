// The person beside the field, who can do to a robot what it cannot do itself. Scenarios play that person.
#pragma once

#include "geometry/pose2.h"

namespace reorient {

class Experimenter {
 public:
  virtual ~Experimenter() = default;
  virtual void pick_up() = 0;                     ///< the robot hangs in the air until it is put down
  virtual void put_down(const Pose2& where) = 0;  ///< upright, standing
  virtual void push_over() = 0;                   ///< the robot falls
  virtual void penalize(bool penalized) = 0;
  virtual void set_exposure_compensation(
      double stops) = 0;  ///< the hall's light against the camera's exposure, in powers of two
};

}  // namespace reorient
