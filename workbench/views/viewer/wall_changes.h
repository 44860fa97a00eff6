// SPDX-License-Identifier: MIT
// Whether the colors of the wall have changed since viewers received them. A message with all tiles is large, and a
// room that is learned changes little.
#pragma once

#include <vector>

#include "engine/record/frame_record.h"
#include "workbench/views/scene/color.h"

namespace reorient {

class WallChanges {
 public:
  /// The smallest difference of a color that is sent, in levels of a byte.
  static constexpr int kVisible = 5;

  /// Whether a tile was learned, or a color differs visibly from the wall for which the result was true last.
  /// `begins`: the result is true.
  bool take(const RoomRecord& room, bool begins);

 private:
  std::vector<scene::Color> sent_;
};

}  // namespace reorient
