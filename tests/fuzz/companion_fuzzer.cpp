// SPDX-License-Identifier: MIT
// Arbitrary bytes from a client of the companion: before or after its hello. With any bytes, the companion
// continues, and its output is usable.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>

#include <unistd.h>

#include "robots/companion/companion.h"
#include "tests/fuzz/promises.h"
#include "tests/robots/companion/raw_client.h"

namespace reorient {
namespace {

class Served {
 public:
  void serve(std::span<const std::byte> bytes) {
    if (bytes.empty()) return;
    const Haste haste(5.0);
    const auto how = static_cast<unsigned>(bytes.front());
    now_ += 5.0;
    looks_ = 0;
    RawClient client(path());
    require(client.is_connected(), "the companion listens");
    if ((how & 1) != 0) client.introduce(small_hello(1 + (how >> 1 & 3), 1 + (how >> 3 & 1)));
    if ((how & 17) == 17) client.paint(7);
    client.send_bytes(bytes.subspan(1), (how & 32) != 0 ? client.memory() : -1);
    if (const Handshake* const handshake = companion_.wait_for_handshake(); handshake != nullptr)
      companion_.begin(*handshake, false, 1);
    for (int i = 0; i < 3; ++i) look();
    for (const RawClient::Heard& heard : client.hear())
      require(heard.kind >= REORIENT_WELCOME && heard.kind <= REORIENT_NOTE,
              "the type of a message is one of the protocol");
    client.end();
    look();
  }

 private:
  static std::filesystem::path path() { return "/tmp/reorient-fuzz-" + std::to_string(getpid()); }

  void look() {
    Observation seen;
    looks_ = 0;
    now_ += 0.03;
    if (!companion_.observe(seen)) return;
    require(std::isfinite(seen.time) && seen.time > last_time_, "time increases");
    for (const BodySample& sample : seen.body_samples) {
      require(sample.time >= last_time_ && sample.time <= seen.time, "samples lie between two frames, in order");
      last_time_ = sample.time;
    }
    last_time_ = seen.time;
    require(seen.odometry.position.allFinite() && std::isfinite(seen.odometry.rotation), "the odometry is finite");
    require(seen.body.acceleration.allFinite() && std::isfinite(seen.body.foot_load), "the sensor values are finite");
    require(seen.body_samples.size() <= 100, "samples are bounded");
    require(!seen.external.initial_pose || seen.external.initial_pose->pose.position.allFinite(),
            "an initial pose is finite");
    require(seen.external.messages.size() <= kMostMessages, "messages are bounded");
    require(!seen.upper || seen.upper->robot_from_camera.matrix().allFinite(), "the camera's pose is finite");
    companion_.answer({});
  }

  double now_ = 0.0;
  int looks_ = 0;
  double last_time_ = -1.0;
  Companion companion_{{path(), no_known_robots(), 3, [this] { return now_; }, [this] { return ++looks_ > 1; }, 0.0}};
};

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static reorient::Served served;
  served.serve(std::as_bytes(std::span(data, size)));
  return 0;
}
