// SPDX-License-Identifier: MIT
#include "engine/world/body_claims.h"

#include <algorithm>
#include <bit>
#include <numeric>

namespace reorient {

void BodyClaims::decide(std::span<PartsRequest> requests) {
  claims_.clear();
  order_.resize(requests.size());
  std::iota(order_.begin(), order_.end(), 0u);
  std::sort(order_.begin(), order_.end(), [&](std::size_t left, std::size_t right) {
    const double first = requests[left].priority, second = requests[right].priority;
    return first != second ? first > second : left < right;
  });
  std::array<NameId, kMostBodyParts> holders{};
  for (const std::size_t i : order_) {
    PartsRequest& request = requests[i];
    const NameId machine = request.issuer.machine;
    request.outranked_by = kNoName;
    for (BodyParts rest = request.parts; rest != 0 && request.outranked_by == kNoName; rest &= rest - 1) {
      const NameId holder = holders[static_cast<std::size_t>(std::countr_zero(rest))];
      if (holder != machine) request.outranked_by = holder;
    }
    if (request.outranked_by == kNoName) {
      for (BodyParts rest = request.parts; rest != 0; rest &= rest - 1)
        holders[static_cast<std::size_t>(std::countr_zero(rest))] = machine;
    }
    note(request);
  }
}

void BodyClaims::note(const PartsRequest& request) {
  for (BodyParts rest = request.parts; rest != 0; rest &= rest - 1) {
    const auto part = static_cast<BodyPart>(std::countr_zero(rest));
    const auto known = std::find_if(claims_.begin(), claims_.end(), [&](const PartClaim& claim) {
      return claim.part == part && claim.issuer.machine == request.issuer.machine;
    });
    if (known == claims_.end()) {
      claims_.push_back({part, request.issuer, request.priority, request.outranked_by});
    } else if (request.outranked_by == kNoName && known->outranked_by != kNoName) {
      *known = {part, request.issuer, request.priority, kNoName};
    }
  }
}

NameId BodyClaims::holder(BodyPart part) const {
  const auto found = std::find_if(claims_.begin(), claims_.end(), [&](const PartClaim& claim) {
    return claim.part == part && claim.outranked_by == kNoName;
  });
  return found == claims_.end() ? kNoName : found->issuer.machine;
}

NameId BodyClaims::rival(BodyPart part, NameId machine) const {
  const auto found = std::find_if(claims_.begin(), claims_.end(), [&](const PartClaim& claim) {
    return claim.part == part && claim.issuer.machine == machine;
  });
  return found == claims_.end() ? kNoName : found->outranked_by;
}

void BodyClaims::rename(const NameTable& before, const NameTable& now) {
  for (PartClaim& claim : claims_) {
    claim.issuer = renumbered(claim.issuer, before, now);
    if (claim.outranked_by == kNoName) continue;
    claim.outranked_by = renumbered(claim.outranked_by, before, now);
    if (claim.outranked_by == kNoName) claim.issuer.machine = kNoName;  // else the refused claim would look granted
  }
  std::erase_if(claims_, [](const PartClaim& claim) { return claim.issuer.machine == kNoName; });
}

}  // namespace reorient
