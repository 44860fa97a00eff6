// SPDX-License-Identifier: MIT
// Grants or refuses the commands of behaviors that change the belief in this frame, each with a verdict.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/world/commands.h"
#include "engine/world/world.h"

namespace reorient {

/// After a reorientation was granted, the same one is refused for some time, until its effect can be observed.
struct ArbiterParameters {
  double flip_cooldown = 3.0;   // s
  double purge_cooldown = 3.0;  // s
  double reset_cooldown = 3.0;  // s
};

template <typename Visit>
void describe(ArbiterParameters& p, Visit&& visit) {
  visit("flip_cooldown", p.flip_cooldown, 0.0, 60.0, "s",
        "time after a granted flip during which the arbiter refuses further flips");
  visit("purge_cooldown", p.purge_cooldown, 0.0, 60.0, "s",
        "time after a granted purge during which the arbiter refuses further purges");
  visit("reset_cooldown", p.reset_cooldown, 0.0, 60.0, "s",
        "time after a granted reset during which the arbiter refuses further resets");
}

/// Result for one frame.
struct Arbitration {
  std::optional<CommandRecord> granted;  ///< one reorientation at most
  bool train = true;                     ///< false: a state holds a lease on pausing the training
  bool evaluate = true;
  std::vector<CommandRecord> commands;  ///< one for each request, in their order
  std::vector<Lease> begun;             ///< leases that were not held in the previous frame
};

/// The verdict on a behavior's latest request of one kind.
struct LastVerdict {
  NameId machine = kNoName;
  Reorientation reorientation = Reorientation::flip_pose;
  Verdict verdict = Verdict::granted;
  NameId outranked_by = kNoName;  ///< the machine whose command was granted instead
  int refusals = 0;               ///< since the latest one that was granted
};
template <typename Visit, ConstOr<LastVerdict> T>
void fields(Visit&& visit, T& last) {
  visit(last.machine, last.reorientation, last.verdict, last.outranked_by, last.refusals);
}

class Arbiter {
 public:
  explicit Arbiter(const ArbiterParameters& parameters = {}) : parameters_(parameters) {}

  void set_parameters(const ArbiterParameters& parameters) { parameters_ = parameters; }

  /// Of the requests that are allowed and not too soon, the greatest priority wins, at a tie the first.
  /// Not allowed: every request while the robot is lifted, since its camera's pose is unknown then; a flip and a purge
  /// also while it falls, lies or gets up. Pausing is always granted. The result is valid until the next call.
  const Arbitration& arbitrate(std::span<const ReorientationRequest> requests, std::span<const Lease> leases,
                               const World& world);

  /// Maps held leases to new numbers of names; they remain held.
  void rename(const NameTable& before, const NameTable& now);

  /// Of the latest request of this kind by this machine; nullptr: it has requested none.
  const LastVerdict* last_verdict(NameId machine, Reorientation reorientation) const;
  /// Time from now on for which such a request is too soon: s.
  double wait(Reorientation reorientation, double time) const;

  /// The latest result; before the first one, training and evaluation are permitted.
  const Arbitration& last() const { return result_; }

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.granted_at_, self.held_, self.result_.train, self.result_.evaluate, self.verdicts_);
  }

 private:
  double cooldown(Reorientation reorientation) const;
  Verdict judge(const ReorientationRequest& request, const World& world) const;
  void note_leases(std::span<const Lease> leases);
  void note_verdicts();

  ArbiterParameters parameters_;
  std::array<std::optional<double>, 3> granted_at_;  ///< s, per reorientation
  std::vector<Lease> held_;                          ///< in the previous frame
  Arbitration result_;
  std::vector<LastVerdict> verdicts_;  ///< at most one for each machine and kind
};

}  // namespace reorient
