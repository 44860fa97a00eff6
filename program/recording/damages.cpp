// SPDX-License-Identifier: MIT
#include "program/recording/damages.h"

#include <ostream>
#include <vector>

#include <fmt/format.h>

#include "engine/parameters/counted.h"
#include "engine/parameters/utf8.h"
#include "program/safe_output.h"

namespace reorient {

void tell_damages(const Recording& recording, std::ostream& err) {
  for (const std::string& damage : recording.damages()) print_error(err, recording.name() + ": " + damage);
}

std::string text_of(const Recording::Losses& losses) {
  std::vector<std::string> parts;
  if (losses.frames > 0) parts.push_back(counted(losses.frames, "frame") + " lost");
  if (losses.unknown) parts.emplace_back("an unknown number of frames lost");
  if (losses.images > 0) parts.push_back(counted(losses.images, "frame") + " without a recorded image");
  return fmt::format("{}", fmt::join(parts, "; "));
}

}  // namespace reorient
