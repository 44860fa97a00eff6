// SPDX-License-Identifier: MIT
// The behaviors of a robot in one frame: from the world to their requests.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/script/language/behavior_language.h"
#include "engine/script/language/world_fields.h"
#include "engine/script/script_host.h"
#include "engine/world/arbiter.h"
#include "engine/world/body_claims.h"
#include "engine/world/world.h"

namespace reorient {

class Behaviors {
 public:
  /// References must outlive the behaviors.
  Behaviors(ScriptTexts texts, ParameterRegistry& parameters, const ScriptLimits& limits = kDefaultLimits)
      : host_(std::move(texts), language_, parameters, limits) {}
  /// With the values and actions of an application.
  Behaviors(ScriptTexts texts, const ApplicationState& application, ParameterRegistry& parameters,
            const ScriptLimits& limits = kDefaultLimits)
      : language_(application), host_(std::move(texts), language_, parameters, limits) {}

  /// Each behavior reads this world, the application's values, the other behaviors' states at the start of the frame,
  /// the messages of teammates since the last frame, and who had which part of the body in the last frame.
  /// `arbiter`: the verdicts on their earlier commands; nullptr: none.
  void tick(const World& world, std::span<const Message> messages = {}, const Arbiter* arbiter = nullptr) {
    language_.actions().set_messages(messages);
    language_.actions().set_verdicts(arbiter, claims_, host_.names());
    values_.clear();
    append_world(world, values_);
    said_ = &host_.tick(world.time, values_);
    language_.actions().share_body(claims_);
    leases_.clear();
    host_.append_leases(leases_);
  }

  /// Between two frames. The arbiter and the application's state store names of these behaviors.
  std::vector<ReloadRecord> apply(std::span<const ScriptEdit> edits, Arbiter& arbiter, ApplicationState& application) {
    const std::shared_ptr<const NameTable> before = host_.names().table();
    std::vector<ReloadRecord> reloads = host_.apply(edits);
    arbiter.rename(*before, *host_.names().table());
    application.rename(*before, *host_.names().table());
    claims_.rename(*before, *host_.names().table());
    return reloads;
  }

  // Of the last tick.
  const ScriptOutput& said() const { return *said_; }
  const BehaviorOutput& wanted() const { return language_.output(); }
  std::span<const PartClaim> claims() const { return claims_.last(); }
  std::span<const Lease> leases() const { return leases_; }  ///< all active leases

  /// The host saves and restores the scripts itself.
  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.claims_);
  }

  ScriptHost& host() { return host_; }
  const ScriptHost& host() const { return host_; }

 private:
  BehaviorLanguage language_;
  ScriptHost host_;
  std::vector<double> values_;
  ScriptOutput nothing_;
  const ScriptOutput* said_ = &nothing_;
  std::vector<Lease> leases_;
  BodyClaims claims_;
};

}  // namespace reorient
