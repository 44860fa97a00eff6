// SPDX-License-Identifier: MIT
// Faulty clients, in simulated time: whatever a client does, the companion neither blocks nor crashes, and serves the
// next client.
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <limits>
#include <map>

#include <gtest/gtest.h>
#include <unistd.h>

#include "geometry/random.h"
#include "robots/companion/companion.h"
#include "tests/robots/companion/raw_client.h"
#include "tests/temporary_folder.h"

namespace reorient {
namespace {

class BrokenClients {
 public:
  explicit BrokenClients(std::uint64_t seed)
      : random_(seed, 0xb0c),
        companion_({path(), no_known_robots(), seed, [this] { return now_; }, [this] { return ++looks_ > 1; }, 0.0}) {}

  void live() {
    const int actions = 10 + static_cast<int>(40.0 * random_.uniform());
    for (int i = 0; i < actions; ++i) {
      act();
      if (random_.uniform() < 0.7) look();
      now_ += random_.uniform() < 0.1 ? 3.0 : 0.03;
    }
    go_on();
  }

  const std::map<std::string, int>& done() const { return done_; }

 private:
  std::filesystem::path path() const { return folder_.path() / "s"; }
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }

  RawClient& client() {
    if (clients_.empty()) {
      clients_.emplace_back(path());
      clients_.back().introduce(small_hello(1 + below(3), 1 + static_cast<std::uint32_t>(below(2))));
    }
    return clients_[below(clients_.size())];
  }

  double nonsense() {
    const double numbers[] = {std::nan(""), std::numeric_limits<double>::infinity(), -1e308, 1e30, -0.0, 5e-324};
    return numbers[below(std::size(numbers))];
  }

  /// A frame as a client sends it, with an image.
  reorient_frame good_frame(RawClient& client) {
    time_ += 0.03;
    ++number_;
    return standing_frame(number_, time_,
                          client.slots() != nullptr ? client.paint(static_cast<std::uint8_t>(number_)) : 0);
  }

  void act() {
    struct Action {
      const char* name;
      std::function<void()> act;
    };
    const Action actions[] = {
        {"valid frames",
         [&] {
           RawClient& one = client();
           for (std::size_t i = 0; i < 1 + below(4); ++i) one.send(REORIENT_FRAME, good_frame(one));
         }},
        {"disconnected during a message",
         [&] {
           RawClient& one = client();
           std::vector<std::byte> bytes;
           append_message(REORIENT_FRAME, good_frame(one), bytes);
           bytes.resize(below(bytes.size()));
           one.send_bytes(bytes);
           one.end();
         }},
        {"disconnected", [&] { client().end(); }},
        {"a wrong version",
         [&] {
           const reorient_header header{8, REORIENT_FRAME, static_cast<std::uint16_t>(3 + below(60000))};
           client().send_bytes(std::as_bytes(std::span(&header, 1)));
         }},
        {"a size of 2^31",
         [&] {
           const reorient_header header{0x80000000u + static_cast<std::uint32_t>(below(100)), REORIENT_FRAME,
                                        REORIENT_VERSION_2};
           client().send_bytes(std::as_bytes(std::span(&header, 1)));
         }},
        {"invalid numbers",
         [&] {
           RawClient& one = client();
           reorient_frame frame = good_frame(one);
           frame.has = static_cast<std::uint32_t>(below(1024));
           double* const fields[] = {&frame.time,          &frame.odometry[below(3)], &frame.head[below(2)],
                                     &frame.attitude[1],   &frame.acceleration[2],    &frame.belief[below(3)],
                                     &frame.covariance[3], &frame.told_pose[0],       &frame.images[0].age};
           *fields[below(std::size(fields))] = nonsense();
           one.send(REORIENT_FRAME, frame);
         }},
        {"time going back",
         [&] {
           RawClient& one = client();
           time_ -= random_.uniform() < 0.5 ? 0.5 : 5000.0;
           one.send(REORIENT_FRAME, good_frame(one));
         }},
        {"time far ahead",
         [&] {
           RawClient& one = client();
           time_ += 1e8;
           one.send(REORIENT_FRAME, good_frame(one));
         }},
        {"images that shrink",
         [&] {
           RawClient& one = client();
           if (one.memory() >= 0) {
             EXPECT_NE(ftruncate(one.memory(), 64), 0) << "the seal prevents it";
           }
           one.send(REORIENT_FRAME, good_frame(one));
         }},
        {"memory without a seal",
         [&] {
           const OwnedDescriptor memory = memory_of(3 * (REORIENT_SLOT_HEADER + 64 * 64), false);
           client().send(REORIENT_MEMORY, reorient_memory{0, REORIENT_SLOT_HEADER + 64 * 64}, memory.get());
         }},
        {"unrequested descriptors",
         [&] {
           const OwnedDescriptor memory = memory_of(64, true);
           RawClient& one = client();
           for (int i = 0; i < 5; ++i) {
             std::vector<std::byte> bytes;
             append_message(REORIENT_FRAME, good_frame(one), bytes);
             one.send_bytes(bytes, memory.get());
           }
         }},
        {"overwritten images",
         [&] {
           RawClient& one = client();
           reorient_frame frame = good_frame(one);
           frame.images[0].sequence += static_cast<std::uint64_t>(below(5)) - 2;
           one.send(REORIENT_FRAME, frame);
         }},
        {"two clients",
         [&] {
           clients_.emplace_back(path());
           clients_.back().introduce(small_hello(5));
         }},
        {"a client that sends nothing", [&] { clients_.emplace_back(path()); }},
        {"a flood",
         [&] {
           RawClient& one = client();
           for (int i = 0; i < 300; ++i) one.send(REORIENT_FRAME, good_frame(one));
         }},
        {"noise",
         [&] {
           std::vector<std::byte> bytes(below(2000));
           for (std::byte& byte : bytes) byte = static_cast<std::byte>(below(256));
           client().send_bytes(bytes);
         }},
        {"a message with a wrong byte",
         [&] {
           RawClient& one = client();
           std::vector<std::byte> bytes;
           append_message(REORIENT_FRAME, good_frame(one), bytes);
           for (std::size_t i = 0; i < 1 + below(4); ++i)
             bytes[below(bytes.size())] = static_cast<std::byte>(below(256));
           one.send_bytes(bytes);
         }},
        {"a second hello", [&] { client().send(REORIENT_HELLO, small_hello(2)); }},
        {"another robot",
         [&] {
           reorient_hello hello = small_hello(3);
           hello.body.torso_height = 0.1 + random_.uniform();
           clients_.clear();
           clients_.emplace_back(path());
           clients_.back().introduce(hello);
         }},
        {"a flood of samples",
         [&] {
           reorient_sample sample{};
           sample.time = time_;
           sample.has = REORIENT_HAS_ACCELERATION;
           RawClient& one = client();
           for (int i = 0; i < 400; ++i) one.send(REORIENT_SAMPLE, sample);
         }},
        {"a client that does not read",
         [&] {
           for (int i = 0; i < 300; ++i) companion_.answer({});
         }},
    };
    const Action& action = actions[below(std::size(actions))];
    ++done_[action.name];
    action.act();
    std::erase_if(clients_, [](const RawClient& one) { return !one.is_connected(); });
    if (clients_.size() > 5) clients_.erase(clients_.begin());
  }

  /// Processes frames like an engine.
  void look() {
    looks_ = 0;
    if (!engine_) {
      const Handshake* const handshake = companion_.wait_for_handshake();
      if (handshake == nullptr) return;
      companion_.begin(*handshake, false, 1);
      engine_ = true;
    }
    Observation observation;
    looks_ = 0;
    if (!companion_.observe(observation)) {
      engine_ = !companion_.has_other_robot();
      return;
    }
    ASSERT_GT(observation.time, last_time_);
    for (const BodySample& sample : observation.body_samples) ASSERT_TRUE(sample.time > last_time_);
    last_time_ = observation.time;
    ASSERT_TRUE(std::isfinite(observation.time) && observation.odometry.position.allFinite());
    Answer answer;
    if (random_.uniform() < 0.1) answer.reorientation = static_cast<Reorientation>(below(3));
    companion_.answer(answer);
  }

  /// Checks that the companion serves the next client.
  void go_on() {
    clients_.clear();
    now_ += 5.0;
    RawClient good(path());
    good.introduce(small_hello(99));
    time_ = 1.0;
    std::optional<reorient_answer> answer;
    for (int i = 0; i < 60 && !answer; ++i) {
      good.send(REORIENT_FRAME, good_frame(good));
      look();
      now_ += 0.03;
      answer = good.answer();
    }
    const Companion::Counts& counts = companion_.counts();
    ASSERT_TRUE(answer) << counts.frames << " frames, " << counts.unusable << " unusable, " << counts.superseded
                        << " superseded, " << counts.unanswered << " unanswered; connected " << good.is_connected()
                        << ", engine " << engine_;
    EXPECT_GT(answer->frames, 0u);
  }

  TemporaryFolder folder_;
  Random random_;
  double now_ = 10.0;
  int looks_ = 0;
  Companion companion_;
  bool engine_ = false;
  std::vector<RawClient> clients_;
  double time_ = 100.0;
  double last_time_ = -1.0;
  std::uint64_t number_ = 0;
  std::map<std::string, int> done_;
};

TEST(BrokenClients, EndOnlyTheirOwnConnections) {
  const char* const wanted = std::getenv("REORIENT_SEQUENCES");
  const std::uint64_t sequences = wanted != nullptr ? std::strtoull(wanted, nullptr, 10) : 50;
  std::map<std::string, int> done;
  for (std::uint64_t seed = 1; seed <= sequences && !HasFatalFailure(); ++seed) {
    SCOPED_TRACE("sequence " + std::to_string(seed));
    BrokenClients clients(seed);
    clients.live();
    for (const auto& [name, count] : clients.done()) done[name] += count;
  }
  EXPECT_EQ(done.size(), 21u);
  for (const auto& [name, count] : done) RecordProperty(name, count);
}

}  // namespace
}  // namespace reorient
