// SPDX-License-Identifier: MIT
// Arbitrary bytes from the process that listens at LoLA's socket, in pieces: the guard closes the connection, or sends
// only commands that the joints can carry out. The same bytes as a command for the simulated robot.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "robots/nao/guard/session.h"
#include "tests/fuzz/promises.h"

namespace reorient::nao {
namespace {

void hear(std::span<const std::byte> bytes) {
  const Haste haste(5.0);
  static const auto body = std::make_unique<SharedBody>();
  BodyRequest request;
  request.time = 1.0;
  request.posture = WantedPosture::sit;  // before it stands up, as the engine requests
  request.moves_head = 1;
  request.head_yaw = 1.0f;
  request.head_speed = 3.0f;
  body->request.write(request);
  Session session(*body);
  session.connected();
  Command before;
  bool any = false;
  const std::size_t piece = bytes.empty() ? 1 : 1 + std::to_integer<std::size_t>(bytes[0]) * 8;
  double time = 1.0;
  while (!bytes.empty()) {
    const std::span<std::byte> space = session.space();
    require(!space.empty(), "the buffer has space");
    const std::size_t size = std::min({space.size(), bytes.size(), piece});
    std::copy_n(bytes.begin(), size, space.begin());
    bytes = bytes.subspan(size);
    if (!session.received(size, time)) return;
    time += kCycle;
    if (session.to_send().empty()) continue;
    require(session.to_send().size() == kCommandBytes, "an answer is one packet");
    Command command;
    require(read_command_packet(session.to_send(), command), "an answer can be read");
    for (std::size_t joint = 0; joint < kJoints; ++joint) {
      require(std::isfinite(command.position[joint]), "the target of a joint is finite");
      require(command.stiffness[joint] >= 0.0f && command.stiffness[joint] <= 1.0f, "stiffness has its range");
      if (!any || command.stiffness[joint] <= 0.0f || before.stiffness[joint] <= 0.0f) continue;
      const auto most = static_cast<float>(kJointLimits[joint].speed * kCycle) + 1e-3f;
      require(std::fabs(command.position[joint] - before.position[joint]) <= most,
              "no target is faster than its joint");
    }
    before = command;
    any = true;
    request.posture = WantedPosture::stand;
    request.time = time;
    body->request.write(request);
    session.sent(session.to_send().size(), time);
  }
}

}  // namespace
}  // namespace reorient::nao

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::byte> bytes(reinterpret_cast<const std::byte*>(data), size);
  reorient::nao::Command command;
  static_cast<void>(reorient::nao::read_command_packet(bytes, command));
  reorient::nao::hear(bytes);
  return 0;
}
