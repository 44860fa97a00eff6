// SPDX-License-Identifier: MIT
// Random faults of robot, guard and engine, in simulated time: no joint receives a target that is too fast for it, each
// whole packet is answered, and at the end the robot is in a safe posture.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "robots/nao/guard/session.h"
#include "robots/nao/lola/packed.h"
#include "tests/robots/nao/twin/twin_body.h"

namespace reorient::nao {
namespace {

class Trouble {
 public:
  explicit Trouble(std::uint64_t seed)
      : random_(seed, 0x2a0), shared_(std::make_unique<SharedBody>()), session_(*shared_) {
    session_.connected();
  }

  void live() {
    request_.posture = WantedPosture::stand;
    const int troubles = 5 + static_cast<int>(20.0 * random_.uniform());
    for (int i = 0; i < troubles; ++i) {
      cause();
      go_on(0.1 + 2.0 * random_.uniform());
    }
    // The engine ends; all other faults are over.
    engine_lives_ = false;
    body_.tilt(0.0f, 0.0f);
    body_.block(kJoints);
    body_.set_status(0.0f);
    foreign_ = false;
    if (!is_connected_) reconnect();
    go_on(8.0);
    const auto story = [this] {
      std::string text = "state " + std::to_string(static_cast<int>(session_.report(time_).state)) + ", warnings " +
                         std::to_string(session_.report(time_).warnings);
      for (const auto& [what, times] : done_) text += "; " + std::to_string(times) + " x " + what;
      return text;
    };
    ASSERT_EQ(body_.complaint(), "");
    ASSERT_TRUE(body_.is_soft()) << story();
    ASSERT_TRUE(body_.sits() || body_.lies()) << story();
    ASSERT_EQ(unanswered_, 0) << "valid packets without an answer; " << story();
    ASSERT_EQ(body_.falls(), pushes_) << "fell because of a command; " << story();
  }

  const std::map<std::string, int>& done() const { return done_; }

 private:
  std::size_t below(std::size_t count) {
    return static_cast<std::size_t>(random_.uniform() * static_cast<double>(count));
  }

  void cause() {
    switch (below(20)) {
      case 0:
        return note("split packets", [&] { split_ = 50; });
      case 1:
        return note("two packets at once", [&] { joined_ = 50; });
      case 2:
        return note("silence", [&] { time_ += 0.05 + 3.0 * random_.uniform(); });
      case 3:
        return note("connection closed", [&] {
          disconnect();
          time_ += 2.0 * random_.uniform();
          reconnect();
        });
      case 4:
        return note("an unknown key", [&] { unknown_ = !unknown_; });
      case 5:
        return note("Status as float", [&] { float_status_ = !float_status_; });
      case 6:
        return note("a key is missing", [&] {
          missing_ = static_cast<int>(below(kSensorKeys));
          left_ = 100;
        });
      case 7:
        return note("an invalid number", [&] {
          nan_in_ = static_cast<int>(below(12));
          left_ = 100;
        });
      case 8:
        return note("a body of another version, for one connection", [&] {
          disconnect();
          foreign_ = random_.uniform() < 0.3;
          reconnect();
        });
      case 9:
        return note("no answer is read", [&] { deaf_ = 1 + static_cast<int>(below(100)); });
      case 10:
        return note("an answer is read in pieces", [&] { sips_ = 100; });
      case 11:
        return note("noise", [&] {
          std::vector<std::byte> noise(1 + below(3000));
          for (std::byte& byte : noise) byte = static_cast<std::byte>(below(256));
          // The stream is out of sync in any case until one side disconnects, which the robot does here.
          static_cast<void>(feed(noise));
          disconnect();
          reconnect();
        });
      case 12:
        return note("the engine is stopped", [&] { engine_lives_ = false; });
      case 13:
        return note("the engine continues", [&] { engine_lives_ = true; });
      case 14:
        return note("the engine sends invalid values", [&] { faulty_ = 100; });
      case 15:
        return note("another posture is requested", [&] { request_.posture = static_cast<WantedPosture>(below(3)); });
      case 16:
        return note("it is pushed over", [&] {
          if (body_.lies() || !body_.stands()) return;
          body_.push();
          ++pushes_;
          go_on(1.5);
          body_.pick_up_and_put_down();
        });
      case 17:
        return note("an operator tilts it", [&] {
          body_.tilt(static_cast<float>(0.6 * random_.uniform() - 0.3),
                     static_cast<float>(0.8 * random_.uniform() - 0.4));
          go_on(3.0 * random_.uniform());
          body_.tilt(0.0f, 0.0f);
        });
      case 18:
        return note("a joint is held", [&] { body_.block(below(kJoints + 1)); });
      case 19:
        return note("a motor is hot", [&] { body_.set_status(static_cast<float>(below(4))); });
    }
  }

  template <typename Cause>
  void note(const char* what, Cause&& cause) {
    ++done_[what];
    cause();
  }

  void disconnect() {
    session_.disconnected();
    is_connected_ = false;
  }
  void reconnect() {
    session_.connected();
    body_.meet();
    is_connected_ = true;
    waiting_.clear();
    deaf_ = 0;
    received_.clear();
  }

  void go_on(double seconds) {
    for (double end = time_ + seconds; time_ < end; time_ += kCycle) cycle();
  }

  void cycle() {
    ask();
    body_.step();
    const std::vector<std::byte> packet = make_packet();
    waiting_.insert(waiting_.end(), packet.begin(), packet.end());
    const bool holds_back = joined_ > 0 && --joined_ % 2 == 1;
    std::size_t now = holds_back ? 0 : waiting_.size();
    if (split_ > 0 && --split_ % 2 == 1) now = below(waiting_.size());
    const std::vector<std::byte> part(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(now));
    waiting_.erase(waiting_.begin(), waiting_.begin() + static_cast<std::ptrdiff_t>(now));
    const bool whole = waiting_.empty() && !holds_back;
    const bool takes_all = deaf_ == 0 && sips_ == 0;
    const int before = answers_;
    if (!feed(part)) {
      disconnect();
      reconnect();
      return;
    }
    take_answers();
    if (whole && takes_all && !unusable_ && answers_ == before) ++unanswered_;
  }

  bool feed(std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
      const std::span<std::byte> space = session_.space();
      if (space.empty()) return false;
      const std::size_t size = std::min(space.size(), bytes.size());
      std::copy_n(bytes.begin(), size, space.begin());
      if (!session_.received(size, time_)) return false;
      bytes = bytes.subspan(size);
    }
    return true;
  }

  void take_answers() {
    if (deaf_ > 0) {
      --deaf_;
      return;
    }
    while (!session_.to_send().empty()) {
      std::size_t size = session_.to_send().size();
      if (sips_ > 0) size = std::min(size, 1 + below(300));
      received_.insert(received_.end(), session_.to_send().begin(),
                       session_.to_send().begin() + static_cast<std::ptrdiff_t>(size));
      session_.sent(size, time_);
      if (sips_ > 0) {
        --sips_;
        break;
      }
    }
    while (true) {
      const PackedExtent extent = first_packed_value(received_);
      if (extent.state != PackedExtent::State::whole) {
        ASSERT_NE(extent.state, PackedExtent::State::invalid);
        break;
      }
      Command command;
      ASSERT_EQ(extent.size, kCommandBytes);
      ASSERT_TRUE(read_command_packet(std::span(received_).first(extent.size), command));
      body_.take(command);
      ++answers_;
      received_.erase(received_.begin(), received_.begin() + static_cast<std::ptrdiff_t>(extent.size));
    }
  }

  std::vector<std::byte> make_packet() {
    Measurement measurement = body_.measurement();
    RobotIdentity identity = body_.identity();
    if (foreign_) identity.body_version[0] = '5';
    std::vector<std::byte> bytes(2048);
    bytes.resize(write_sensor_packet(measurement, identity, bytes));
    const bool odd = left_ > 0 && --left_ > 0;
    unusable_ = odd;  // perhaps without positions, which the first answer needs
    if (!odd) missing_ = nan_in_ = -1;
    if (!odd && !unknown_ && !float_status_) return bytes;
    // Copy the packet key by key and insert the faults.
    std::vector<std::byte> changed(4096);
    PackedWriter writer(changed);
    PackedReader reader(bytes);
    const std::uint32_t pairs = reader.map().value();
    writer.map(pairs + (unknown_ ? 1 : 0) - (missing_ >= 0 ? 1 : 0));
    if (unknown_) {
      writer.text("Whistle");
      writer.array(1);
      writer.boolean(true);
    }
    for (std::uint32_t i = 0; i < pairs; ++i) {
      const std::string key(reader.text().value());
      const std::uint32_t count = reader.array().value();
      const bool left_out = static_cast<int>(i) == missing_;
      if (!left_out) {
        writer.text(key);
        writer.array(count);
      }
      for (std::uint32_t value = 0; value < count; ++value) {
        if (key == "RobotConfig") {
          const std::string_view text = reader.text().value();
          if (!left_out) writer.text(text);
          continue;
        }
        float number = reader.number().value();
        if (static_cast<int>(i) == nan_in_ && value == 0) number = odd_number();
        if (left_out) continue;
        if (key == "Status" && !float_status_ && std::isfinite(number)) {
          writer.small(static_cast<std::uint8_t>(std::clamp(number, 0.0f, 3.0f)));
        } else {
          writer.number(number);
        }
      }
    }
    changed.resize(writer.size());
    return changed;
  }

  float odd_number() {
    const float numbers[] = {std::nanf(""), std::numeric_limits<float>::infinity(), -3e38f, 1e30f};
    return numbers[below(std::size(numbers))];
  }

  void ask() {
    if (!engine_lives_ || ++cycle_ % 3 != 0) return;
    BodyRequest request = request_;
    // As the engine does, and an operator who presses the button at once.
    if ((session_.report(time_).warnings & kStandRefused) != 0) request.posture = WantedPosture::sit;
    request.time = time_;
    request.moves_head = 1;
    request.head_yaw = static_cast<float>(1.8 * std::sin(time_));
    request.head_pitch = static_cast<float>(0.5 * std::sin(1.7 * time_));
    request.head_speed = static_cast<float>(2.0 + 5.0 * random_.uniform());
    if (faulty_ > 0) {
      --faulty_;
      request.head_yaw = odd_number();
      request.head_speed = odd_number();
      WalkTargets walk;  // with invalid values, too
      walk.time = random_.uniform() < 0.1 ? odd_number() : time_;
      walk.moves_joints = 1;
      for (std::size_t joint = 0; joint < kJoints; ++joint) {
        walk.joints[joint] = standing_posture()[joint] + static_cast<float>(0.3 * (random_.uniform() - 0.5));
        walk.stiffness[joint] = static_cast<float>(0.6 + random_.uniform());
      }
      walk.joints[below(kJoints)] = odd_number();
      shared_->walk.write(walk);
      if (random_.uniform() < 0.1) request.posture = static_cast<WantedPosture>(9);
      if (random_.uniform() < 0.1) request.time = odd_number();
    }
    shared_->request.write(request);
  }

  Random random_;
  std::unique_ptr<SharedBody> shared_;
  Session session_;
  TwinBody body_;
  BodyRequest request_;
  double time_ = 10.0;
  int cycle_ = 0;
  bool engine_lives_ = true, is_connected_ = true, foreign_ = false, unknown_ = false, float_status_ = false;
  bool unusable_ = false;
  int split_ = 0, joined_ = 0, deaf_ = 0, sips_ = 0, faulty_ = 0, left_ = 0, missing_ = -1, nan_in_ = -1;
  std::vector<std::byte> waiting_, received_;
  int answers_ = 0, unanswered_ = 0, pushes_ = 0;
  std::map<std::string, int> done_;
};

TEST(GuardInTrouble, AlwaysEndsInASafePosture) {
  const char* const wanted = std::getenv("REORIENT_SEQUENCES");
  const int sequences = wanted != nullptr ? std::atoi(wanted) : 50;
  std::map<std::string, int> done;
  for (int seed = 1; seed <= sequences; ++seed) {
    Trouble trouble(static_cast<std::uint64_t>(seed));
    trouble.live();
    if (testing::Test::HasFatalFailure()) FAIL() << "seed " << seed;
    for (const auto& [what, times] : trouble.done()) done[what] += times;
  }
  EXPECT_EQ(done.size(), 20u);
  for (const auto& [what, times] : done) std::printf("%6d times: %s\n", times, what.c_str());
}

}  // namespace
}  // namespace reorient::nao
