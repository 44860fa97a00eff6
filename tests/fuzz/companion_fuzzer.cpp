// SPDX-License-Identifier: MIT
// Arbitrary bytes from a client of the companion: before or after its hello, or as changes of the messages of a whole
// session. With any bytes, the companion continues, and its output is usable.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <unistd.h>

#include "engine/merged_percepts.h"
#include "engine/world/application_state.h"
#include "robots/companion/companion.h"
#include "tests/declared_field.h"
#include "tests/fuzz/promises.h"
#include "tests/robots/companion/raw_client.h"

namespace reorient {
namespace {

/// A value of each way to be read, and an action.
ApplicationInterface fuzzed_interface() {
  ApplicationInterface declared;
  declared.name = "fuzzed";
  declared.values = {
      {"a.x", "", {declared_field("", FieldType::number, {{0.0}, {}})}},
      {"a.t", "", {declared_field("", FieldType::text, {{}, {""}})}},
      {"p", "", {declared_field("", FieldType::pose, {{0.0, 0.0, 0.0}, {}})}},
      {"l",
       "",
       {declared_field("i", FieldType::integer, {{0.0}, {}}), declared_field("b", FieldType::boolean, {{0.0}, {}})},
       3}};
  declared.actions = {
      {"k",
       "",
       {declared_field("d", FieldType::number, {{0.0}, {}}), declared_field("f", FieldType::text, {{}, {""}})},
       20.0,
       true}};
  return declared;
}

KnownRobots known_interface() {
  KnownRobots known = no_known_robots();
  known.default_interface = fuzzed_interface();
  known.interface = [](std::string_view, const std::string&) { return fuzzed_interface(); };
  return known;
}

constexpr std::uint32_t kMostFuzzedPercepts = 4;

struct FrameWithPercepts {
  reorient_frame frame;
  reorient_percepts header;
  std::array<reorient_percept, kMostFuzzedPercepts> percepts;
};

/// The message of a hello whose client has a detector of its own.
std::vector<std::byte> with_detector(const reorient_hello& hello, std::uint32_t use) {
  struct {
    reorient_header header;
    reorient_hello hello;
    std::array<reorient_lens, 2> lenses;
    reorient_interface interface;
    reorient_detector detector;
  } const message{
      {sizeof(message) - sizeof(reorient_header), REORIENT_HELLO, REORIENT_VERSION_2}, hello, {}, {}, {use, 0}};
  const auto bytes = std::as_bytes(std::span(&message, 1));
  return {bytes.begin(), bytes.end()};
}

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
    const reorient_hello hello = small_hello(1 + (how >> 1 & 3), 1 + (how >> 3 & 1));
    const bool has_detector = (how & 7) == 5;
    if (has_detector) client.introduce(with_detector(hello, 1 + (how >> 3 & 1)));
    if ((how & 1) != 0 && !has_detector) client.introduce(hello);
    if ((how & 17) == 17) client.paint(7);
    const bool is_session = (how & 65) == 65;
    if (!is_session) client.send_bytes(bytes.subspan(1), (how & 32) != 0 ? client.memory() : -1);
    if (const Handshake* const handshake = companion_.wait_for_handshake(); handshake != nullptr)
      companion_.begin(*handshake, (how & 128) != 0, 1);
    if (is_session) play(client, bytes.subspan(1));
    for (int i = 0; i < 3; ++i) look();
    for (const RawClient::Heard& heard : client.hear())
      require(heard.kind >= REORIENT_WELCOME && heard.kind <= REORIENT_ACTION,
              "the type of a message is one of the protocol");
    client.end();
    look();
  }

 private:
  static std::filesystem::path path() { return "/tmp/reorient-fuzz-" + std::to_string(getpid()); }

  /// Valid messages in any order, each with a few bytes changed.
  void play(RawClient& client, std::span<const std::byte> bytes) {
    constexpr std::size_t kHeader = 4;
    while (bytes.size() >= kHeader) {
      const auto at = [&bytes](std::size_t i) { return std::to_integer<std::size_t>(bytes[i]); };
      const std::size_t what = at(0) % 9, offset = at(1) | at(2) << 8,
                        size = std::min(at(3) % 32, bytes.size() - kHeader);
      const std::span<const std::byte> changes = bytes.subspan(kHeader, size);
      const auto changed = [&](auto message) {
        const std::size_t begin = offset % sizeof(message);
        const std::size_t count = std::min(changes.size(), sizeof(message) - begin);
        if (count > 0) std::memcpy(reinterpret_cast<std::byte*>(&message) + begin, changes.data(), count);
        return message;
      };
      if (what <= 1) {
        client.send(REORIENT_FRAME, changed(standing_frame(++number_, now_, client.paint(7))));
      } else if (what == 2) {
        reorient_sample sample{};
        sample.time = now_;
        client.send(REORIENT_SAMPLE, changed(sample));
      } else if (what == 3) {
        reorient_game game{};
        game.team = 5;
        game.player = 3;
        game.size = 158;
        std::memcpy(game.datagram, "RGme\x14", 5);
        game.datagram[18] = 5;
        client.send(REORIENT_GAME, changed(game));
      } else if (what == 4) {
        client.send(REORIENT_MEMORY, changed(reorient_memory{0, client.slot_size()}), client.memory());
      } else if (what == 6) {
        std::array<char, 96> json{};
        std::string_view(R"({"a":{"x":1.5,"t":"hi"},"p":{"x":1,"y":2,"rotation":3},"l":[{"i":2,"b":true},{}]})")
            .copy(json.data(), json.size());
        std::memset(json.data() + 88, ' ', 8);
        client.send(REORIENT_VALUES, changed(json));
      } else if (what == 7) {
        client.send(REORIENT_REPORT, changed(reorient_report{1, REORIENT_ACTION_DONE, "why"}));
      } else if (what == 8) {
        FrameWithPercepts message{standing_frame(++number_, now_, client.paint(7)), {kMostFuzzedPercepts, 0}, {}};
        for (reorient_percept& percept : message.percepts)
          percept = {REORIENT_PERCEPT_BALL, REORIENT_ON_GROUND, 0, 0.5f, {1.0f, 2.0f, 3.0f, 4.0f}, 0.0f, {}};
        const reorient_frame frame = message.frame;
        message = changed(message);
        if (offset % sizeof(message) >= sizeof(frame)) message.frame = frame;
        client.send(REORIENT_FRAME, message);
      } else {
        decided_ = static_cast<Reorientation>(offset % enum_count(Reorientation{}));
      }
      look();
      bytes = bytes.subspan(kHeader + size);
    }
  }

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
    require(seen.external.values.size() <= kMostValues && seen.external.reports.size() <= kMostReports,
            "values and reports are bounded");
    if (seen.percepts) {
      require(seen.percepts->list.size() <= kMostExternalPercepts, "percepts are bounded");
      for (const ExternalPercept& percept : seen.percepts->list)
        require(mistake_in(percept).empty(), "percepts are valid");
      percepts_ = {};
      const DetectorCamera camera{seen.upper ? seen.upper->camera : CameraModel(), Isometry3::Identity(),
                                  Eigen::Translation3d(0.0, 0.0, 0.5) * Isometry3::Identity()};
      add_external(*seen.percepts, {camera, std::nullopt}, FieldDimensions(), {}, {}, percepts_);
    }
    for (const SetValue& value : seen.external.values) require(value.value < 4, "a value is one of the interface");
    std::vector<std::string> mistakes;
    application_.begin_frame(seen.time);
    application_.take(seen.external.values, seen.time, mistakes);
    application_.take(seen.external.reports, seen.time);
    const ActionRequest request{0, {{0.5}, {"left"}}, {}, 0.0};
    application_.start({&request, 1}, seen.time);
    require(!seen.upper || seen.upper->robot_from_camera.matrix().allFinite(), "the camera's pose is finite");
    require(!seen.external.referee || static_cast<int>(seen.external.referee->state) < enum_count(GameState{}),
            "the state of the game is known");
    Answer answer;
    answer.reorientation = std::exchange(decided_, std::nullopt);
    answer.actions.assign(application_.started().begin(), application_.started().end());
    companion_.answer(answer);
  }

  double now_ = 0.0;
  int looks_ = 0;
  double last_time_ = -1.0;
  std::uint64_t number_ = 0;
  std::array<FieldPercept, 2> percepts_;
  std::optional<Reorientation> decided_;
  ApplicationState application_{fuzzed_interface()};
  Companion companion_{{path(), known_interface(), 3, [this] { return now_; }, [this] { return ++looks_ > 1; }, 0.0}};
};

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static reorient::Served served;
  served.serve(std::as_bytes(std::span(data, size)));
  return 0;
}
