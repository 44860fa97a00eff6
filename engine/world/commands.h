// SPDX-License-Identifier: MIT
// Commands from behaviors to the core (the paper's Section 3.1), and the verdicts on them.
#pragma once

#include <string_view>

#include "engine/world/names.h"
#include "geometry/const_or.h"
#include "robots/answer.h"

namespace reorient {

/// "flip_pose", "purge_reflection", "reset_orientation": the names in scripts.
std::string_view to_string(Reorientation reorientation);

/// The process that stops while the state that requested the pause is active.
enum class Pause { training, evaluation };
constexpr int enum_count(Pause) { return 2; }

/// "pause_training", "pause_evaluation".
std::string_view to_string(Pause pause);

/// Origin of a request, and its reason.
struct Issuer {
  NameId machine = 0;
  NameId state = 0;   ///< path, e.g. "watching/doubtful"
  NameId reason = 0;  ///< the `because` of the transition that led there
};
template <typename Visit, ConstOr<Issuer> T>
void fields(Visit&& visit, T& issuer) {
  visit(issuer.machine, issuer.state, issuer.reason);
}
inline Issuer renumbered(const Issuer& issuer, const NameTable& before, const NameTable& now) {
  return {renumbered(issuer.machine, before, now), renumbered(issuer.state, before, now),
          renumbered(issuer.reason, before, now)};
}

struct ReorientationRequest {
  Reorientation reorientation = Reorientation::flip_pose;
  Issuer issuer;
  double priority = 0.0;  ///< of the behavior; the greater wins
};
template <typename Visit, ConstOr<ReorientationRequest> T>
void fields(Visit&& visit, T& request) {
  visit(request.reorientation, request.issuer, request.priority);
}

/// A pause that ends with the state in which it was issued.
struct Lease {
  Pause pause = Pause::training;
  Issuer issuer;
};
template <typename Visit, ConstOr<Lease> T>
void fields(Visit&& visit, T& lease) {
  visit(lease.pause, lease.issuer);
}

enum class Verdict { granted, outranked, too_soon, not_allowed };
constexpr int enum_count(Verdict) { return 4; }

std::string_view to_string(Verdict verdict);

/// A request and the arbiter's verdict in the same frame.
struct CommandRecord {
  ReorientationRequest request;
  Verdict verdict = Verdict::granted;
};
template <typename Visit, ConstOr<CommandRecord> T>
void fields(Visit&& visit, T& record) {
  visit(record.request, record.verdict);
}

}  // namespace reorient
