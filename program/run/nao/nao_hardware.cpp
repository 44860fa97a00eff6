// SPDX-License-Identifier: MIT
#include "program/run/nao/nao_hardware.h"

#include <array>
#include <utility>

#include <poll.h>

#include "program/monotonic_clock.h"

namespace reorient {
namespace {

void wait_for(double seconds, std::span<const int> descriptors) {
  std::array<pollfd, 2> waits{};
  nfds_t count = 0;
  for (const int descriptor : descriptors) {
    if (descriptor >= 0 && count < waits.size()) waits[count++] = {descriptor, POLLIN, 0};
  }
  poll(waits.data(), count, static_cast<int>(1000.0 * seconds));
}

/// The missing part of the robot, and how to fix it.
std::string description_of(nao::Missing missing) {
  using nao::Missing;
  switch (missing) {
    case Missing::guard:
      return "no guard is running; start reorient-nao-guard";
    case Missing::measurements:
      return "the guard receives no measurements; check that LoLA is running";
    case Missing::images:
      return "no image from /dev/video-top, or its colors are still settling";
    case Missing::nothing:
      break;
  }
  return "";
}

}  // namespace

NaoHardware::NaoHardware(const Options& options)
    : guard_(options.guard.empty() ? nao::default_body_file() : options.guard), both_cameras_(options.both_cameras) {
  if (options.hears_referee)
    referee_ = std::make_unique<nao::UdpReferee>(kGameControllerPort, kGameControllerReturnPort, monotonic_clock);
}

nao::NaoSurroundings NaoHardware::surroundings(std::function<bool()> is_over,
                                               std::function<void(const std::string&)> tell) {
  nao::NaoSurroundings around;
  around.now = monotonic_clock;
  around.wait = wait_for;
  around.is_over = std::move(is_over);
  around.tell_missing = [tell](nao::Missing missing) { tell(description_of(missing)); };
  around.tell = std::move(tell);
  around.body = [this] { return guards_memory(monotonic_clock()); };
  around.run_errand = nao::run_apart;
  around.upper = &upper_;
  around.lower = both_cameras_ ? &lower_ : nullptr;
  around.referee = referee_.get();
  return around;
}

/// Opens the shared memory again if it has no new data for a second, because the file may have been replaced.
nao::SharedBody* NaoHardware::guards_memory(double now) {
  constexpr double kPause = 1.0;  // s
  if (body_ != nullptr && body_->measured != measured_) {
    measured_ = body_->measured;
    next_look_ = now + kPause;
  }
  if (now >= next_look_) {
    next_look_ = now + kPause;
    body_ = nullptr;  // the mapping ends in any case
    mapped_.emplace(guard_, nao::MappedBody::Side::engine);
    body_ = *mapped_ ? &**mapped_ : nullptr;
  }
  return body_;
}

}  // namespace reorient
