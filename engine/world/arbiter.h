// SPDX-License-Identifier: MIT
// Who may rearrange the belief in this frame? Behaviours ask; the arbiter grants or refuses, each with a verdict.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/world/commands.h"
#include "engine/world/world.h"

namespace reorient {

/// After a reorientation was granted, the same one is refused for some time: its effect must show first.
struct ArbiterParameters {
  double flip_cooldown = 3.0;   // s
  double purge_cooldown = 3.0;  // s
  double reset_cooldown = 3.0;  // s
};

template <typename Visit>
void describe(ArbiterParameters& p, Visit&& visit) {
  visit("flip_cooldown", p.flip_cooldown, 0.0, 60.0, "s", "how long after a flip no other flip is granted");
  visit("purge_cooldown", p.purge_cooldown, 0.0, 60.0, "s", "how long after a purge no other purge is granted");
  visit("reset_cooldown", p.reset_cooldown, 0.0, 60.0, "s", "how long after a reset no other reset is granted");
}

/// What holds in this frame.
struct Arbitration {
  std::optional<CommandRecord> granted;  ///< one reorientation at most
  bool train = true;                     ///< false: somebody holds a lease on pausing the training
  bool evaluate = true;
  std::vector<CommandRecord> commands;  ///< one for each request, in their order
  std::vector<Lease> begun;             ///< leases that were not held in the frame before
};

class Arbiter {
 public:
  explicit Arbiter(const ArbiterParameters& parameters = {}) : parameters_(parameters) {}

  void set_parameters(const ArbiterParameters& parameters) { parameters_ = parameters; }

  /// Among the requests that are allowed and not too soon the greatest priority wins, at a tie the first.
  /// Not allowed: everything while the robot is lifted, since nothing is known of its camera then; a flip and a purge
  /// also while it falls, lies or gets up. Pausing is always granted. The result is valid until the next call.
  const Arbitration& arbitrate(std::span<const ReorientationRequest> requests, std::span<const Lease> leases,
                               const World& world);

  /// The names of scripts have other numbers from now on; leases that are held stay so.
  void rename(const NameTable& before, const NameTable& now);

  /// The latest one; before the first everything is allowed to happen.
  const Arbitration& last() const { return result_; }

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.granted_at_, self.held_, self.result_.train, self.result_.evaluate);
  }

 private:
  double cooldown(Reorientation reorientation) const;
  Verdict judge(const ReorientationRequest& request, const World& world) const;
  void note_leases(std::span<const Lease> leases);

  ArbiterParameters parameters_;
  std::array<std::optional<double>, 3> granted_at_;  ///< s, per reorientation
  std::vector<Lease> held_;                          ///< in the frame before
  Arbitration result_;
};

}  // namespace reorient
