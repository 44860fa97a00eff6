// SPDX-License-Identifier: MIT
#include "program/recording/damages.h"

#include <ostream>

namespace reorient {

void tell_damages(const Recording& recording, std::ostream& err) {
  for (const std::string& damage : recording.damages()) err << "reorient: left out " << damage << '\n';
}

}  // namespace reorient
