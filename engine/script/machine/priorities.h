// SPDX-License-Identifier: MIT
// The priorities of a behavior: one for all that it requests, and others for parts of the body.
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "engine/world/body_claims.h"
#include "geometry/const_or.h"

namespace reorient {

struct PartPriority {
  BodyPart part = kHead;
  double priority = 0.0;
};
template <typename Visit, ConstOr<PartPriority> T>
void fields(Visit&& visit, T& one) {
  visit(one.part, one.priority);
}

/// `priority = 35`, or `priority = { 35, head = 50 }`.
struct Priorities {
  double all = 0.0;
  std::vector<PartPriority> parts;  ///< those that differ

  /// For a request that moves several parts: the smallest of theirs.
  double of(BodyParts some) const {
    double smallest = std::numeric_limits<double>::infinity();
    for (const PartPriority& one : parts) {
      if ((some & only(one.part)) == 0) continue;
      smallest = std::min(smallest, one.priority);
      some &= ~only(one.part);
    }
    const bool is_rest = some != 0 || smallest == std::numeric_limits<double>::infinity();
    return is_rest ? std::min(smallest, all) : smallest;
  }
};
template <typename Visit, ConstOr<Priorities> T>
void fields(Visit&& visit, T& priorities) {
  visit(priorities.all, priorities.parts);
}

}  // namespace reorient
