// SPDX-License-Identifier: MIT
// The state between two frames as bytes.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "engine/frame.h"

namespace reorient {
namespace {

constexpr std::uint64_t kStateMagic = 0x4865746174537252ull;  // "RrStateH": change it with the layout

bool is_possible(const CameraOptics& camera) {
  constexpr int kMostPixels = 10'000;
  const auto is_size = [](int pixels) { return pixels >= 1 && pixels <= kMostPixels; };
  const auto is_view = [](double angle) { return angle > 0.0 && angle <= 2.0 * kPi; };
  return is_size(camera.width) && is_size(camera.height) && is_view(camera.field_of_view_horizontal) &&
         is_view(camera.field_of_view_vertical) && camera.rate > 0.0 && camera.rate <= 1e4 &&
         (!camera.center || camera.center->cwiseAbs().maxCoeff() <= kMostPixels);
}

/// Whether a body has the order of magnitude of a humanoid. NaN is never in a range.
bool is_possible(const RobotBody& body) {
  constexpr double kLargest = 10.0;  // m
  const auto is_within = [](double value, double most) { return std::abs(value) <= most; };
  const auto is_place = [&](const Eigen::Vector3d& place) {
    return std::all_of(place.begin(), place.end(), [&](double value) { return is_within(value, kLargest); });
  };
  const auto is_mount = [&](const CameraMount& mount) {
    return is_place(mount.position) && is_within(mount.tilt, kPi);
  };
  const auto is_limit = [&](const PitchLimit& limit) {
    return is_within(limit.yaw, kPi) && is_within(limit.min, kPi) && is_within(limit.max, kPi) &&
           limit.min <= limit.max;
  };
  const RobotDimensions& dimensions = body.dimensions;
  const Gait gait = body.gait.value_or(Gait());
  return dimensions.torso_height > 0.0 && is_within(dimensions.torso_height, kLargest) &&
         is_place(dimensions.first_axis) && is_place(dimensions.second_axis) && is_mount(dimensions.upper) &&
         is_mount(dimensions.lower) && is_within(body.lying_height, kLargest) && is_within(body.neck.yaw, kPi) &&
         !body.neck.pitch.empty() && std::all_of(body.neck.pitch.begin(), body.neck.pitch.end(), is_limit) &&
         is_within(body.head_speed, 1e3) && is_possible(body.upper_camera) &&
         (!body.lower_camera || is_possible(*body.lower_camera)) && is_within(body.standing_load.value_or(0.0), 1e4) &&
         is_within(gait.forward, 1e2) && is_within(gait.left, 1e2) && is_within(gait.turn, 1e2) &&
         is_within(gait.cruise, 1e2) && is_within(body.get_up_time.value_or(0.0), 1e4);
}

/// The setup for a loop with the current values. The seed is unused, because the random numbers continue.
FrameSetup read_setup(ByteReader& in) {
  std::uint64_t magic = 0;
  in(magic);
  check_bytes(magic == kStateMagic, "state: not saved by this version of the program");
  FrameSetup setup;
  in(setup.field, setup.body, setup.room_awareness, setup.parameters, setup.application);
  check_bytes(is_possible(setup.body), "state: impossible body of the robot (expected the measures of a humanoid)");
  return setup;
}

}  // namespace

template <typename Archive>
void FrameLoop::archive(Archive& archive, auto& self) {
  archive(self.field_vision_, self.localizer_, self.arbiter_, self.posture_, self.repeated_pose_,
          self.carried_.get_up_requested, self.carried_.external, self.carried_.world, self.carried_.odometry,
          self.carried_.application, self.behaviors_);
  if (self.room_) archive(*self.room_);
}

void FrameLoop::save(std::vector<std::byte>& state) const {
  ByteWriter out(state);
  out(kStateMagic, world().field, body_, room_.has_value(), registry_.overrides(), carried_.application.declared());
  archive(out, *this);
  behaviors_.host().save(out);
}

FrameLoop::FrameLoop(ByteReader&& state) : FrameLoop(read_setup(state)) {
  archive(state, *this);
  behaviors_.host().restore(state);
  state.finish();
  check_bytes(std::isfinite(world().time) && world().time_step >= 0.0, "state: invalid time");
  check_bytes(world().pose.pose.position.allFinite() && world().pose.covariance.allFinite(),
              "state: believed pose: expected finite values");
  record_.names = behaviors_.host().names().table();
}

FrameLoop::FrameLoop(std::span<const std::byte> state) try : FrameLoop(ByteReader(state)) {
} catch (const BadBytes&) {
  throw;
} catch (const std::runtime_error& error) {  // errors of the setup
  throw BadBytes(error.what());
} catch (const std::exception&) {  // of the standard library, such as a size that no memory can have
  throw BadBytes("state: invalid values (expected those of an engine)");
}

}  // namespace reorient
