// SPDX-License-Identifier: MIT
// The state between two frames as bytes.
#include "engine/frame.h"

namespace reorient {
namespace {

constexpr std::uint64_t kStateMagic = 0x4565746174537252ull;  // "RrStateE": change it with the layout

/// The setup for a loop with the current values. The seed is unused, because the random numbers continue.
FrameSetup read_setup(ByteReader& in) {
  std::uint64_t magic = 0;
  in(magic);
  check_bytes(magic == kStateMagic, "state: not saved by this version of the program");
  FrameSetup setup;
  in(setup.field, setup.body, setup.room_awareness, setup.parameters);
  return setup;
}

}  // namespace

template <typename Archive>
void FrameLoop::archive(Archive& archive, auto& self) {
  archive(self.field_vision_, self.localizer_, self.arbiter_, self.posture_, self.repeated_pose_,
          self.carried_.get_up_requested, self.carried_.external, self.carried_.world, self.carried_.odometry);
  if (self.room_) archive(*self.room_);
}

void FrameLoop::save(std::vector<std::byte>& state) const {
  ByteWriter out(state);
  out(kStateMagic, world().field, body_, room_.has_value(), registry_.overrides());
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
} catch (const std::exception& error) {  // errors of the setup
  throw BadBytes(error.what());
}

}  // namespace reorient
