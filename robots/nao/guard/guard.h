// SPDX-License-Identifier: MIT
// Controls the body of a NAO, cycle by cycle: carries out the engine's requests as far as they are safe, and sits down
// if they stop. It has no clock and no socket: inputs are measurements, requests and the time, outputs are commands.
#pragma once

#include <cstdint>
#include <optional>

#include "robots/nao/guard/body_request.h"
#include "robots/nao/guard/postures.h"
#include "robots/nao/lola/sensor_packet.h"

namespace reorient::nao {

class Guard {
 public:
  /// Validity of a request, s. Older requests are ignored.
  static constexpr double kHolds = 0.1;

  /// Call for a new connection, perhaps of another robot: the positions of its joints are unknown.
  void connected();

  /// One cycle. `request`, `walk`: the newest ones, of any age; empty if none was ever written. The first command holds
  /// the joints at the measured positions, without stiffness. Returns nothing if the joints were not measured yet.
  std::optional<Command> step(const Measurement& measurement, const std::optional<RobotIdentity>& robot,
                              const std::optional<BodyRequest>& request, const std::optional<WalkTargets>& walk = {});

  /// From now on the guard sits down and then removes all stiffness, regardless of requests.
  void finish() { finishing_ = true; }
  /// Whether the guard may end: no further command would make the body safer.
  bool is_at_rest() const;

  GuardState state() const { return state_; }
  std::uint32_t warnings() const { return warnings_; }
  std::uint32_t warning_joint() const { return joint_; }

 private:
  void take_over(const Measurement& measurement);
  bool has(std::uint32_t warning) const { return (warnings_ & warning) != 0; }
  void check_body(const Measurement& measurement, const std::optional<RobotIdentity>& robot);
  WantedPosture wanted(const std::optional<BodyRequest>& request, double age);
  void decide(WantedPosture wanted);
  void release_if_held();
  void begin(GuardState state);
  void hold_head(const std::optional<BodyRequest>& request, double age);
  void follow(const std::optional<WalkTargets>& walk, double age);
  void move_head(const BodyRequest& request);
  void limit();
  Lights lights(const std::optional<BodyRequest>& request, double age) const;

  GuardState state_ = GuardState::waiting;
  std::uint32_t warnings_ = 0;
  std::uint32_t joint_ = 0;
  bool finishing_ = false;
  bool may_rise_ = false;    // a request for another posture than standing has arrived since requests were missing
  double taken_over_ = 0.0;  // s, time of the first measurement

  bool is_known_ = false;  // the positions of the joints are known
  JointValues measured_{};
  double tilt_ = 0.0;                 // rad, of the torso from upright
  double upright_within_ = 0.0;       // rad, the greater of roll and pitch
  int blind_ = 1000;                  // cycles without positions or angles
  std::array<int, kJoints> stuck_{};  // cycles for which a joint has not reached its target

  Glide glide_;
  bool is_crouched_ = false;  // while sitting down: the second part of the motion
  bool walks_ = false;        // the walk moves the joints
  int held_ = 0;              // cycles for which it could not sit down although the guard must end
  JointValues goal_{};        // before limits
  JointValues stiff_{};       // requested
  JointValues position_{};    // commanded
  JointValues stiffness_{};   // commanded
};

}  // namespace reorient::nao
