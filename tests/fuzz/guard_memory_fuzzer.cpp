// SPDX-License-Identifier: MIT
// Arbitrary bytes in the memory that the guard shares with engine and walk, as faulty processes of the same user may
// write: the guard sends only commands that the joints can carry out, and the engine reads a bounded number of values.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <memory>
#include <span>
#include <vector>

#include "robots/nao/guard/session.h"
#include "tests/fuzz/promises.h"

namespace reorient::nao {
namespace {

/// Writes bytes over a value with its sequence number, and removes them from the front.
template <typename Shared>
void overwrite(Shared& value, std::span<const std::byte>& bytes) {
  const std::size_t size = std::min(sizeof(value), bytes.size());
  if (size > 0) std::memcpy(static_cast<void*>(&value), bytes.data(), size);
  bytes = bytes.subspan(size);
}

void require_possible(const Command& command, const Command& before, bool any) {
  for (std::size_t joint = 0; joint < kJoints; ++joint) {
    require(std::isfinite(command.position[joint]), "the target of a joint is finite");
    require(command.stiffness[joint] >= 0.0f && command.stiffness[joint] <= 1.0f, "stiffness has its range");
    if (!any || command.stiffness[joint] <= 0.0f || before.stiffness[joint] <= 0.0f) continue;
    const auto most = static_cast<float>(kJointLimits[joint].speed * kCycle) + 1e-3f;
    require(std::fabs(command.position[joint] - before.position[joint]) <= most, "no target is faster than its joint");
  }
  const auto is_shown = [](float light) { return light >= 0.0f && light <= 1.0f; };
  const auto is_color = [&](const Lights::Color& color) {
    return is_shown(color.red) && is_shown(color.green) && is_shown(color.blue);
  };
  const Lights& lights = command.lights;
  require(std::all_of(lights.left_eye.begin(), lights.left_eye.end(), is_color) && is_color(lights.chest) &&
              std::all_of(lights.right_ear.begin(), lights.right_ear.end(), is_shown),
          "lights have their range");
}

void live(std::span<const std::byte> bytes) {
  const Haste haste(5.0);
  if (bytes.empty()) return;
  const auto shared = std::make_unique<SharedBody>();
  Session session(*shared);
  session.connected();
  const auto how = std::to_integer<unsigned>(bytes[0]);
  bytes = bytes.subspan(1);
  Measurement measurement;
  measurement.position = (how & 1) != 0 ? standing_posture() : sitting_posture();
  measurement.fresh = ~0u;
  RobotIdentity identity;
  identity.body_version = {'6', '.', '0', '.', '0'};
  Command before;
  bool any = false;
  std::vector<std::byte> packet(2048);
  std::vector<Measurement> news;
  std::uint64_t seen = 0;
  for (int cycle = 0; cycle < 100; ++cycle) {
    const double time = 1.0 + cycle * kCycle;
    BodyRequest request;  // of an engine that works, until the bytes replace it
    request.time = time;
    request.posture = cycle < 5 ? WantedPosture::sit : WantedPosture::stand;
    shared->request.write(request);
    if (cycle % 10 == 9) {
      overwrite(shared->request, bytes);
      if ((how & 2) != 0) overwrite(shared->walk, bytes);
      if ((how & 4) != 0) overwrite(shared->measured, bytes);
      if ((how & 8) != 0) overwrite(shared->measurements[0], bytes);
      if ((how & 16) != 0) overwrite(shared->report, bytes);
    }
    const std::size_t size = write_sensor_packet(measurement, identity, packet);
    const std::span<std::byte> space = session.space();
    require(space.size() >= size, "the buffer has space");
    std::copy_n(packet.begin(), size, space.begin());
    require(session.received(size, time), "a valid packet is read");
    if (!session.to_send().empty()) {
      Command command;
      require(read_command_packet(session.to_send(), command), "an answer can be read");
      require_possible(command, before, any);
      before = command;
      any = true;
      session.sent(session.to_send().size(), time);
      for (std::size_t joint = 0; joint < kJoints; ++joint) {
        if (command.stiffness[joint] > 0.0f) measurement.position[joint] = command.position[joint];
      }
    }
    news.clear();
    seen = shared->news(seen, news);
    require(news.size() <= kMeasurements, "the engine reads a bounded number of measurements");
    GuardReport report;
    static_cast<void>(shared->report.read(report));
  }
  session.finish();
}

}  // namespace
}  // namespace reorient::nao

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::nao::live({reinterpret_cast<const std::byte*>(data), size});
  return 0;
}
