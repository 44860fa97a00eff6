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
  /// s: what was asked for longer ago is not followed any more.
  static constexpr double kHolds = 0.1;

  /// A robot answers, perhaps another one than before: nothing is known of where its joints are.
  void connected();

  /// One cycle. `request`, `walk`: the newest that there are, however old; nothing where there was none. The first
  /// command holds the joints where they were measured, without stiffness. Nothing: they were not measured yet.
  std::optional<Command> step(const Measurement& measurement, const std::optional<RobotIdentity>& robot,
                              const std::optional<BodyRequest>& request, const std::optional<WalkTargets>& walk = {});

  /// From now on it sits down, and then lets go, whatever is asked.
  void finish() { finishing_ = true; }
  /// Nothing that it still could do would make the body safer.
  bool is_at_rest() const;

  GuardState state() const { return state_; }
  std::uint32_t worries() const { return worries_; }
  std::uint32_t worrying_joint() const { return joint_; }

 private:
  void take_over(const Measurement& measurement);
  bool has(std::uint32_t worry) const { return (worries_ & worry) != 0; }
  void look_after(const Measurement& measurement, const std::optional<RobotIdentity>& robot);
  WantedPosture wanted(const std::optional<BodyRequest>& request, double age) const;
  void decide(WantedPosture wanted);
  void let_go_at_last();
  void begin(GuardState state);
  void hold_head(const std::optional<BodyRequest>& request, double age);
  void follow(const std::optional<WalkTargets>& walk, double age);
  void move_head(const BodyRequest& request);
  void limit();
  Lights lights(const std::optional<BodyRequest>& request) const;

  GuardState state_ = GuardState::waiting;
  std::uint32_t worries_ = 0;
  std::uint32_t joint_ = 0;
  bool finishing_ = false;

  bool is_known_ = false;  // where the joints are
  JointValues measured_{};
  double tilt_ = 0.0;                 // rad, of the torso against upright
  double upright_within_ = 0.0;       // rad, the greater of roll and pitch
  int blind_ = 1000;                  // cycles without positions or angles
  std::array<int, kJoints> stuck_{};  // cycles for which a joint is not where it should be

  Glide glide_;
  bool is_crouched_ = false;  // while sitting down: the second part of the way
  bool walks_ = false;        // the walk moves the joints
  int held_ = 0;              // cycles for which it could not sit down though it is to end
  JointValues goal_{};        // before limits
  JointValues stiff_{};       // wanted
  JointValues position_{};    // commanded
  JointValues stiffness_{};   // commanded
};

}  // namespace reorient::nao
