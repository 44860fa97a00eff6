// SPDX-License-Identifier: MIT
// Which behavior moves which part of the body in a frame. Parts have the order of body_parts() (robots/application.h).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/world/commands.h"
#include "engine/world/names.h"
#include "geometry/const_or.h"
#include "robots/application.h"

namespace reorient {

using BodyPart = std::uint8_t;
inline constexpr BodyPart kHead = 0, kLegs = 1;

/// Some of the parts, one bit each.
using BodyParts = std::uint64_t;
static_assert(kMostBodyParts == 64);
constexpr BodyParts only(BodyPart part) { return BodyParts{1} << part; }

/// What a behavior wants to move in a frame: it gets all of these parts or none.
struct PartsRequest {
  BodyParts parts = 0;
  Issuer issuer;
  double priority = 0.0;          ///< the greater wins; at a tie the first
  NameId outranked_by = kNoName;  ///< the result: the machine that has one of the parts; nothing: it is granted
};

/// The result for one part and one behavior that requested it.
struct PartClaim {
  BodyPart part = kHead;
  Issuer issuer;
  double priority = 0.0;
  NameId outranked_by = kNoName;  ///< the machine that won; nothing: this one has the part
};
template <typename Visit, ConstOr<PartClaim> T>
void fields(Visit&& visit, T& claim) {
  visit(claim.part, claim.issuer, claim.priority, claim.outranked_by);
}

class BodyClaims {
 public:
  /// Grants or refuses each request. Requests of one behavior never refuse each other.
  void decide(std::span<PartsRequest> requests);

  /// Of the last decide(), by priority: at most one for each part and machine.
  std::span<const PartClaim> last() const { return claims_; }
  /// The machine that has the part; kNoName: none.
  NameId holder(BodyPart part) const;
  /// The machine that won a part that this one requested; kNoName: it has the part, or did not request it.
  NameId rival(BodyPart part, NameId machine) const;

  /// Maps machines, states and reasons to new numbers of names.
  void rename(const NameTable& before, const NameTable& now);

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.claims_);
  }

 private:
  void note(const PartsRequest& request);

  std::vector<PartClaim> claims_;
  std::vector<std::size_t> order_;
};

}  // namespace reorient
