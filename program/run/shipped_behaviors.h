// Which of the shipped behaviours a robot can make use of, where no scenario says which run.
#pragma once

#include <string>
#include <vector>

namespace reorient {

/// Of what behaviours ask for, what the robot carries out.
struct Abilities {
  bool head = true;
  bool walk = true;
  bool get_up = true;
};

std::vector<std::string> behaviors_for(const Abilities& abilities);

}  // namespace reorient
