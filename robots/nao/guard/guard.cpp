// SPDX-License-Identifier: MIT
#include "robots/nao/guard/guard.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

namespace reorient::nao {
namespace {

constexpr double kHeadStops = 0.5;    // s without a request
constexpr double kSitsDown = 1.0;     // s without a request
constexpr double kUpright = 0.2;      // rad, largest roll and pitch for standing up and sitting down (Nao Devils)
constexpr double kFalls = 0.7;        // rad, more than a robot leans that is held or walks
constexpr double kStandUp = 2.4;      // s
constexpr double kCrouch = 1.8;       // s, the first part of sitting down
constexpr double kArmsDown = 0.6;     // s, the second part
constexpr double kBackToStand = 1.0;  // s after a walk
constexpr int kLetsGoAfter =
    417;  // cycles, 5 s: time for the operator to put the robot upright after stopping the guard

constexpr float kLegs = 0.8f, kArms = 0.4f, kHead = 0.6f;  // stiffness
constexpr float kHips = 0.1f;  // stiffness of a sitting robot's hips, so that it does not tip over (Nao Devils)
constexpr float kStiffening = static_cast<float>(kCycle / 0.3);  // from 0 to 1 in 0.3 s
constexpr float kLoosening = static_cast<float>(kCycle / 1.0);

constexpr float kFar = 0.35f;       // rad between a joint and its target
constexpr int kStuckAfter = 42;     // cycles: half a second
constexpr int kGivenUpAfter = 250;  // cycles: 3 s
constexpr int kBlindAfter = 8;      // cycles: 0.1 s
constexpr float kLowCharge = 0.1f, kNoCharge = 0.05f;

constexpr std::uint32_t kUnwell = kTooHot | kBatteryEmpty | kJointGivenUp;

float stiffness_of(std::size_t joint) { return is_head(joint) ? kHead : is_leg(joint) ? kLegs : kArms; }

/// Whether the robot rests on its calves and needs no stiffness.
bool has_bent_knees(const JointValues& joints) {
  constexpr float kBent = 1.8f;  // rad
  return std::min(joints[kLeftKneePitch], joints[kRightKneePitch]) > kBent;
}

/// Whether a value is plausible: a packet with valid format may contain wrong numbers.
bool are_plausible(std::span<const float> angles) {
  constexpr float kMost = 7.0f;  // rad, more than a turn
  return std::all_of(angles.begin(), angles.end(), [](float angle) { return std::fabs(angle) < kMost; });
}

/// Checks values of another process, which may be faulty.
float in_range(float value, float least, float most, float otherwise) {
  return std::isfinite(value) ? std::clamp(value, least, most) : otherwise;
}

}  // namespace

void Guard::connected() {
  const bool finishing = finishing_;
  *this = Guard();
  finishing_ = finishing;
}

/// Handles the first measurement of a connection. A stiff body, or a body with unknown stiffness, may stand: removing
/// the stiffness would make it fall.
void Guard::take_over(const Measurement& measurement) {
  position_ = measured_;
  goal_ = measured_;
  taken_over_ = measurement.time;
  const bool is_known = measurement.has(SensorKey::stiffness);
  float legs = 0.0f;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    stiffness_[joint] = is_known ? in_range(measurement.stiffness[joint], 0.0f, 1.0f, 0.0f) : stiffness_of(joint);
    if (is_leg(joint)) legs += stiffness_[joint];
  }
  constexpr float kLimp = 0.05f * (kRightAnkleRoll - kHipYawPitch + 1);
  begin(has_bent_knees(measured_) || legs < kLimp ? GuardState::soft : GuardState::standing_up);
}

bool Guard::is_at_rest() const {
  return state_ == GuardState::waiting || state_ == GuardState::fallen ||
         (state_ == GuardState::soft && *std::max_element(stiffness_.begin(), stiffness_.end()) <= 0.0f);
}

std::optional<Command> Guard::step(const Measurement& measurement, const std::optional<RobotIdentity>& robot,
                                   const std::optional<BodyRequest>& request, const std::optional<WalkTargets>& walk) {
  check_body(measurement, robot);
  if (!is_known_) return std::nullopt;
  if (state_ == GuardState::waiting) take_over(measurement);
  const auto age_of = [&](const auto& said) {
    return said ? std::fabs(measurement.time - said->time) : std::numeric_limits<double>::infinity();
  };
  const double age = age_of(request);
  warnings_ = age <= kHolds ? warnings_ & ~kNoRequest : warnings_ | kNoRequest;
  // A guard that has just started holds a standing robot until the engine had time to write a request.
  const double without = !request ? measurement.time - taken_over_ : std::isfinite(age) ? age : kSitsDown + 1.0;
  decide(wanted(request, without));
  if (!glide_.is_over()) goal_ = glide_.step();
  if (state_ == GuardState::standing && age <= kHolds) follow(walk, age_of(walk));  // otherwise it holds its posture
  hold_head(request, age);
  limit();
  return Command{position_, stiffness_, lights(request, age)};
}

/// Checks the measurements of the body and updates the warnings.
void Guard::check_body(const Measurement& measurement, const std::optional<RobotIdentity>& robot) {
  const auto set = [this](std::uint32_t warning, bool is) {
    warnings_ = is ? warnings_ | warning : warnings_ & ~warning;
  };
  const bool has_positions = measurement.has(SensorKey::position) && are_plausible(measurement.position);
  const bool has_angles = measurement.has(SensorKey::angles) && are_plausible(measurement.angles);
  const bool sees = has_positions && has_angles;
  blind_ = sees ? 0 : std::min(blind_ + 1, kBlindAfter);
  set(kBlind, blind_ >= kBlindAfter);
  if (has_positions) {
    measured_ = measurement.position;
    is_known_ = true;
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      if (stiffness_[joint] <= 0.0f) position_[joint] = measured_[joint];
    }
  }
  if (has_angles) {
    const double roll = measurement.angles[0], pitch = measurement.angles[1];
    upright_within_ = std::max(std::fabs(roll), std::fabs(pitch));
    tilt_ = std::acos(std::clamp(std::cos(roll) * std::cos(pitch), -1.0, 1.0));
  }
  if (robot) {
    const std::array<char, 32>& version = robot->body_version;
    set(kForeignBody, version[0] != '6' || version[1] != '.');
  }
  if (measurement.has(SensorKey::status)) {
    const auto hottest = std::max_element(measurement.status.begin(), measurement.status.end());
    set(kHot, *hottest >= 1.0f);
    if (*hottest >= 2.0f) set(kTooHot, true);
    if (*hottest < 1.0f) set(kTooHot, false);  // hysteresis: not as soon as it is a little cooler
    if (*hottest >= 1.0f) joint_ = static_cast<std::uint32_t>(hottest - measurement.status.begin());
  }
  // A charge of exactly 0 means unknown, not an empty battery.
  if (measurement.has(SensorKey::battery) && measurement.battery[0] > 0.0f) {
    set(kBatteryLow, measurement.battery[0] < kLowCharge);
    if (measurement.battery[0] < kNoCharge) set(kBatteryEmpty, true);
    if (measurement.battery[0] >= kLowCharge) set(kBatteryEmpty, false);
  }
  bool is_stuck = false;
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const bool is_far = sees && stiffness_[joint] >= 0.3f && std::fabs(position_[joint] - measured_[joint]) > kFar;
    stuck_[joint] = is_far ? std::min(stuck_[joint] + 1, kGivenUpAfter) : 0;
    if (stuck_[joint] < kStuckAfter) continue;
    is_stuck = true;
    joint_ = static_cast<std::uint32_t>(joint);
    // Arms and head give way when an operator holds them, and return by themselves. The legs carry the robot.
    if (is_leg(joint) && stuck_[joint] >= kGivenUpAfter) set(kJointGivenUp, true);
  }
  set(kJointStuck, is_stuck);
}

/// `age`: s since the last request. A robot that sat down because requests were missing must not stand up when they
/// return, since an operator may have lifted it or may be working on it: only a request for another posture, which the
/// engine sends until the button is pressed, shows that the engine knows that it sits.
WantedPosture Guard::wanted(const std::optional<BodyRequest>& request, double age) {
  const bool is_up = state_ == GuardState::standing_up || state_ == GuardState::standing;
  warnings_ &= ~kStandRefused;
  if (age > kSitsDown) may_rise_ = false;
  if (finishing_) return WantedPosture::soft;
  if (age > kSitsDown) return WantedPosture::sit;
  if (!request) return is_up ? WantedPosture::stand : WantedPosture::sit;
  if (request->posture == WantedPosture::stand) {
    if (!may_rise_ && !is_up) warnings_ |= kStandRefused;
    return has(kUnwell | kStandRefused) ? WantedPosture::sit : WantedPosture::stand;
  }
  const bool is_soft = request->posture == WantedPosture::soft;
  may_rise_ |= is_soft || request->posture == WantedPosture::sit;  // not an invalid value
  return is_soft && !has(kUnwell) ? WantedPosture::soft : WantedPosture::sit;
}

void Guard::decide(WantedPosture wanted) {
  const bool may_move = upright_within_ < kUpright && !has(kBlind | kForeignBody);
  const bool on_its_feet = state_ == GuardState::standing_up || state_ == GuardState::standing ||
                           state_ == GuardState::sitting_down || state_ == GuardState::sitting;
  warnings_ &= ~kTilted;
  if (on_its_feet && tilt_ > kFalls) return begin(GuardState::fallen);
  switch (state_) {
    case GuardState::waiting:
      return;
    case GuardState::soft:
      // A fallen robot stays down without requests: the default request is to sit, which is not necessary then.
      if (wanted != WantedPosture::stand) return;
      if (!may_move) {
        warnings_ |= kTilted;
        return;
      }
      return begin(GuardState::standing_up);
    case GuardState::standing_up:
    case GuardState::standing:
      if (wanted == WantedPosture::stand) {
        if (state_ == GuardState::standing_up && glide_.is_over()) begin(GuardState::standing);
      } else if (may_move) {
        begin(GuardState::sitting_down);
      } else {
        warnings_ |= kTilted;
        release_if_held();
      }
      return;
    case GuardState::sitting_down:
      if (!glide_.is_over()) return;
      if (!is_crouched_) {
        is_crouched_ = true;
        glide_ = Glide(goal_, sitting_posture(), kArmsDown);
      } else if (has_bent_knees(measured_)) {  // otherwise an operator holds it, and soft legs would let it fall
        begin(GuardState::sitting);
      } else {
        release_if_held();
      }
      return;
    case GuardState::sitting:
      if (wanted == WantedPosture::soft) return begin(GuardState::soft);
      if (wanted != WantedPosture::stand) return;
      if (!may_move) {
        warnings_ |= kTilted;
        return;
      }
      return begin(GuardState::standing_up);
    case GuardState::fallen:
      if (tilt_ < kFalls && wanted != WantedPosture::stand) begin(GuardState::soft);
      return;
  }
}

/// Called if an operator holds the robot while the guard ends. The last command stays active after the guard ends, so
/// it must not leave a leg stiff.
void Guard::release_if_held() {
  const bool is_held = upright_within_ >= kUpright || state_ == GuardState::sitting_down;
  if (finishing_ && is_held && !has(kBlind | kForeignBody) && ++held_ > kLetsGoAfter) begin(GuardState::soft);
}

void Guard::begin(GuardState state) {
  state_ = state;
  held_ = 0;
  walks_ = false;
  const auto stiffen = [this] {
    for (std::size_t joint = 0; joint < kJoints; ++joint) stiff_[joint] = stiffness_of(joint);
  };
  switch (state) {
    case GuardState::standing_up:
      stiffen();
      glide_ = Glide(position_, standing_posture(), kStandUp);
      break;
    case GuardState::sitting_down:
      stiffen();
      is_crouched_ = false;
      glide_ = Glide(position_, crouching_posture(), kCrouch);
      break;
    case GuardState::sitting:
      for (std::size_t joint = kHipYawPitch; joint < kJoints; ++joint) stiff_[joint] = 0.0f;
      stiff_[kLeftShoulderPitch] = stiff_[kLeftShoulderRoll] = stiff_[kLeftElbowYaw] = 0.0f;
      stiff_[kLeftElbowRoll] = stiff_[kLeftWristYaw] = 0.0f;
      stiff_[kHipYawPitch] = stiff_[kLeftHipPitch] = stiff_[kRightHipPitch] = kHips;
      warnings_ &= ~kJointGivenUp;
      break;
    case GuardState::waiting:
    case GuardState::soft:
      stiff_.fill(0.0f);
      break;
    case GuardState::fallen:  // at once: a stiff robot breaks when it falls
      stiff_.fill(0.0f);
      stiffness_.fill(0.0f);
      break;
    case GuardState::standing:
      break;
  }
}

/// Follows the joints of a walk. If the walk writes nothing for a while, the robot holds its posture and then returns
/// to standing.
void Guard::follow(const std::optional<WalkTargets>& walk, double age) {
  const bool asks = walk && walk->moves_joints != 0;
  if (asks && age <= kHolds) {
    walks_ = true;
    for (std::size_t joint = kHeadPitch + 1; joint < kJoints; ++joint) {
      goal_[joint] = in_range(walk->joints[joint], -4.0f, 4.0f, goal_[joint]);
      stiff_[joint] = in_range(walk->stiffness[joint], 0.0f, 1.0f, stiff_[joint]);
    }
  } else if (walks_ && (!asks || !(age <= kHeadStops))) {
    begin(GuardState::standing);
    for (std::size_t joint = 0; joint < kJoints; ++joint) stiff_[joint] = stiffness_of(joint);
    glide_ = Glide(position_, standing_posture(), kBackToStand);
  }
}

/// Sets the target of the head for this cycle, before limits.
void Guard::hold_head(const std::optional<BodyRequest>& request, double age) {
  const bool has_head = state_ == GuardState::standing || state_ == GuardState::sitting;
  // Without requests for a while the head of a sitting robot becomes soft, because they may be missing for hours.
  if (state_ == GuardState::sitting) stiff_[kHeadYaw] = stiff_[kHeadPitch] = age > kSitsDown ? 0.0f : kHead;
  if (has_head && request && request->moves_head != 0 && age <= kHeadStops) {
    move_head(*request);
  } else if (has_head) {
    goal_[kHeadYaw] = position_[kHeadYaw];
    goal_[kHeadPitch] = position_[kHeadPitch];
  }
}

void Guard::move_head(const BodyRequest& request) {
  const auto toward = [&](std::size_t joint, float wanted) {
    const JointLimits& limits = kJointLimits[joint];
    const float most = in_range(request.head_speed, 0.0f, limits.speed, 0.0f) * static_cast<float>(kCycle);
    const float to = in_range(wanted, limits.least, limits.most, position_[joint]);
    goal_[joint] = position_[joint] + std::clamp(to - position_[joint], -most, most);
  };
  toward(kHeadYaw, request.head_yaw);
  toward(kHeadPitch, request.head_pitch);
}

/// Moves the commanded positions one cycle toward the targets, within the limits of the joints.
void Guard::limit() {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    const JointLimits& limits = kJointLimits[joint];
    if (stiff_[joint] > stiffness_[joint]) {
      stiffness_[joint] = std::min(stiffness_[joint] + kStiffening, stiff_[joint]);
    } else {
      stiffness_[joint] = std::max(stiffness_[joint] - kLoosening, stiff_[joint]);
    }
    float wanted = goal_[joint];
    if (stiffness_[joint] <= 0.0f) continue;  // it stays at its measured position
    if (!is_leg(joint)) wanted = std::clamp(wanted, measured_[joint] - kFar, measured_[joint] + kFar);
    wanted = std::clamp(wanted, limits.least, limits.most);
    if (joint == kHeadPitch) {
      const PitchRange range = head_pitch_range(position_[kHeadYaw]);
      wanted = std::clamp(wanted, range.least, range.most);
    }
    const float most = limits.speed * static_cast<float>(kCycle);
    position_[joint] += std::clamp(wanted - position_[joint], -most, most);
  }
}

/// Shows the engine's lights only as long as it sends requests. The last command stays active after the guard has
/// ended, so it must show nothing that no process keeps true.
Lights Guard::lights(const std::optional<BodyRequest>& request, double age) const {
  if (finishing_) return {};
  Lights lights = age <= kHolds ? request->lights : Lights{};
  const auto shown = [](float& value) { value = in_range(value, 0.0f, 1.0f, 0.0f); };
  const auto shown_color = [&](Lights::Color& color) {
    shown(color.red);
    shown(color.green);
    shown(color.blue);
  };
  for (auto* const eye : {&lights.left_eye, &lights.right_eye}) std::for_each(eye->begin(), eye->end(), shown_color);
  for (auto* const ear : {&lights.left_ear, &lights.right_ear}) std::for_each(ear->begin(), ear->end(), shown);
  std::for_each(lights.skull.begin(), lights.skull.end(), shown);
  for (Lights::Color* const light : {&lights.chest, &lights.left_foot, &lights.right_foot}) shown_color(*light);
  constexpr Lights::Color kRed{1.0f, 0.0f, 0.0f}, kYellow{1.0f, 0.6f, 0.0f};
  if (has(kNoRequest)) lights.chest = kYellow;
  if (has(kUnwell | kForeignBody | kBlind) || state_ == GuardState::fallen) lights.chest = kRed;
  return lights;
}

}  // namespace reorient::nao
