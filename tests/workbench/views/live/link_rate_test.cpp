// SPDX-License-Identifier: MIT
// The rate of frames and images over simulated connections: what arrives is never old, and the rates recover.
#include "workbench/views/live/server/link_rate.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace reorient::live {
namespace {

constexpr double kMegabit = 1e6 / 8.0;         // bytes
constexpr double kFrameInterval = 1.0 / 30.0;  // s
constexpr double kStep = 0.001;                // s
constexpr std::size_t kImage = 50'000, kParticles = 21'000, kWall = 60'000;

/// Bytes/s at a time.
using Rate = std::function<double(double time)>;

/// A queue with a rate, whose acknowledgments return after `delay` s.
struct SimulatedLink {
  struct Message {
    double made = 0.0;   // s, of the frame
    double bytes = 0.0;  // left
    std::size_t bulk = kBulkCount;
  };
  struct Arrival {
    double time = 0.0, age = 0.0;  // s
    std::size_t bulk = kBulkCount;
  };

  /// Whether an acknowledgment arrived.
  bool step(double now, double rate) {
    double budget = rate * kStep;
    while (!queue.empty() && budget > 0.0) {
      const double taken = std::min(budget, queue.front().bytes);
      queue.front().bytes -= taken;
      budget -= taken;
      passed += taken;
      if (queue.front().bytes > 0.0) break;
      arrivals.push_back({now + delay, now + delay - queue.front().made, queue.front().bulk});
      acknowledgments.emplace_back(now + 2.0 * delay, passed);
      queue.pop_front();
    }
    const double before = acknowledged;
    while (!acknowledgments.empty() && acknowledgments.front().first <= now) {
      acknowledged = acknowledgments.front().second;
      acknowledgments.pop_front();
    }
    while (!pings.empty() && pings.front().second <= acknowledged + 0.5) pings.pop_front();
    return acknowledged > before;
  }
  void send(double now, double made, std::size_t bytes, std::size_t bulk) {
    queue.push_back({made, static_cast<double>(bytes), bulk});
    sent += static_cast<double>(bytes);
    pings.emplace_back(now, sent);
  }
  LinkMeasurement measure(double now) const {
    const double waiting = std::max(0.0, std::round(sent - acknowledged));
    return {.time = now,
            .delivered = static_cast<std::uint64_t>(acknowledged),
            .waiting = static_cast<std::size_t>(waiting),
            .unanswered = pings.empty() ? 0.0 : now - pings.front().first,
            .round_trip = 2.0 * delay};
  }

  double delay = 0.01;                                  // s
  double sent = 0.0, passed = 0.0, acknowledged = 0.0;  // bytes
  std::deque<Message> queue;
  std::deque<std::pair<double, double>> acknowledgments;  // time, bytes
  std::deque<std::pair<double, double>> pings;            // time, bytes before it; not answered
  std::vector<Arrival> arrivals;
};

/// Frames of 16 kB with an image, particles five times a second and a wall each second, as ViewerMailbox handles them.
std::vector<SimulatedLink::Arrival> run(double seconds, const Rate& rate, double delay = 0.01) {
  SimulatedLink link;
  link.delay = delay;
  LinkState state;
  WaitingFrame frame;
  double made = 0.0, again = 0.0;
  int frames = 0;
  for (double now = 100.0; now < 100.0 + seconds; now += kStep) {  // clocks do not begin at 0
    if (now >= 100.0 + frames * kFrameInterval) {
      frame.bytes = 16'000;
      frame.bulk[static_cast<std::size_t>(Bulk::upper)] = kImage;
      if (frames % 6 == 0) frame.bulk[static_cast<std::size_t>(Bulk::particles)] = kParticles;
      if (frames % 30 == 0) frame.bulk[static_cast<std::size_t>(Bulk::wall)] = kWall;
      frame.replaces = frame.bytes > 0;
      made = again = now;
      ++frames;
    }
    if (link.step(now, rate(now - 100.0))) {
      state = measure(state, link.measure(now));
      again = now;
    }
    const bool is_empty =
        frame.bytes == 0 && std::all_of(frame.bulk.begin(), frame.bulk.end(), [](auto n) { return n == 0; });
    if (is_empty || now < again) continue;
    const LinkDecision decision = decide(state, link.measure(now), frame);
    state = decision.state;
    again = now + decision.again;
    if (!decision.sends) continue;
    frame.replaces = false;
    if (frame.bytes > 0) link.send(now, made, std::exchange(frame.bytes, 0), kBulkCount);
    for (std::size_t bulk = 0; bulk < kBulkCount; ++bulk)
      if (decision.bulk[bulk]) link.send(now, made, std::exchange(frame.bulk[bulk], 0), bulk);
  }
  for (SimulatedLink::Arrival& arrival : link.arrivals) arrival.time -= 100.0;
  return link.arrivals;
}

/// Arrivals a second from `begin` to `end`. No bulk: of frames.
double rate_of(const std::vector<SimulatedLink::Arrival>& all, double begin, double end,
               std::optional<Bulk> bulk = std::nullopt) {
  const std::size_t which = bulk ? static_cast<std::size_t>(*bulk) : kBulkCount;
  const auto count = std::count_if(all.begin(), all.end(), [&](const auto& one) {
    return one.bulk == which && one.time >= begin && one.time < end;
  });
  return static_cast<double>(count) / (end - begin);
}

/// The age of frames in s that a fraction of them does not exceed.
double age_of(const std::vector<SimulatedLink::Arrival>& all, double begin, double end, double fraction) {
  std::vector<double> ages;
  for (const auto& one : all)
    if (one.bulk == kBulkCount && one.time >= begin && one.time < end) ages.push_back(one.age);
  if (ages.empty()) return 1e9;
  std::sort(ages.begin(), ages.end());
  return ages[std::min(ages.size() - 1, static_cast<std::size_t>(fraction * static_cast<double>(ages.size())))];
}

Rate constant(double megabits) {
  return [=](double) { return megabits * kMegabit; };
}

TEST(LinkRate, LeavesNothingOutOfAFastConnection) {
  for (const double delay : {0.001, 0.01, 0.03}) {
    const auto all = run(20.0, constant(50.0), delay);
    EXPECT_NEAR(rate_of(all, 0.0, 20.0), 30.0, 0.2);
    EXPECT_NEAR(rate_of(all, 0.0, 20.0, Bulk::upper), 30.0, 0.2);
    EXPECT_NEAR(rate_of(all, 0.0, 20.0, Bulk::wall), 1.0, 0.1);
    EXPECT_LT(age_of(all, 0.0, 20.0, 1.0), 0.1);
  }
}

TEST(LinkRate, LeavesImagesOutBeforeFrames) {
  for (const double delay : {0.001, 0.01, 0.03}) {
    const auto all = run(30.0, constant(10.0), delay);
    EXPECT_GT(rate_of(all, 5.0, 30.0), 28.0);
    EXPECT_GT(rate_of(all, 5.0, 30.0, Bulk::upper), 7.0);
    EXPECT_LT(age_of(all, 5.0, 30.0, 1.0), kMostAge);
  }
}

TEST(LinkRate, KeepsFramesRecentAtTwoMegabits) {
  for (const double delay : {0.001, 0.01, 0.03}) {
    const auto all = run(60.0, constant(2.0), delay);
    EXPECT_GT(rate_of(all, 5.0, 60.0), 6.0);
    EXPECT_GT(rate_of(all, 5.0, 60.0, Bulk::upper), 0.8);
    EXPECT_GT(rate_of(all, 5.0, 60.0, Bulk::particles), 0.8);
    EXPECT_GT(rate_of(all, 5.0, 60.0, Bulk::wall), 0.2);
    EXPECT_LT(age_of(all, 5.0, 60.0, 1.0), kMostAge);
  }
}

TEST(LinkRate, KeepsFramesComingAtHalfAMegabit) {
  const auto all = run(120.0, constant(0.5));
  EXPECT_GT(rate_of(all, 10.0, 120.0), 1.5);
  EXPECT_LT(rate_of(all, 10.0, 120.0, Bulk::upper), 0.1) << "an image takes 0.8 s";
  EXPECT_GT(rate_of(all, 10.0, 120.0, Bulk::wall), 0.05) << "the wall arrives, too";
  EXPECT_LT(age_of(all, 10.0, 120.0, 0.95), 1.2 * kMostAge) << "one frame takes 0.26 s";
}

TEST(LinkRate, RecoversAfterTheConnectionWasSlow) {
  const auto all = run(40.0, [](double time) { return (time > 10.0 && time < 20.0 ? 2.0 : 20.0) * kMegabit; });
  EXPECT_GT(rate_of(all, 2.0, 10.0, Bulk::upper), 25.0);
  EXPECT_LT(rate_of(all, 12.0, 20.0), 15.0);
  EXPECT_LT(age_of(all, 10.0, 20.0, 1.0), 1.0) << "what was on its way";
  EXPECT_LT(age_of(all, 12.0, 20.0, 1.0), kMostAge);
  EXPECT_GT(rate_of(all, 24.0, 40.0), 29.0);
  EXPECT_GT(rate_of(all, 24.0, 40.0, Bulk::upper), 25.0);
}

TEST(LinkRate, SendsTheNewestFrameAfterTheConnectionStalled) {
  const auto all = run(30.0, [](double time) { return time > 10.0 && time < 20.0 ? 0.0 : 10.0 * kMegabit; });
  EXPECT_EQ(rate_of(all, 10.2, 20.0), 0.0);
  EXPECT_LT(age_of(all, 20.5, 30.0, 1.0), kMostAge);
  EXPECT_GT(rate_of(all, 23.0, 30.0), 25.0);
}

TEST(LinkRate, BearsPausesOfTheConnection) {
  // 4 Mbit/s, of which nothing passes for 0.1 s of each 0.5 s.
  const auto all = run(60.0, [](double time) { return std::fmod(time, 0.5) < 0.1 ? 0.0 : 5.0 * kMegabit; });
  EXPECT_GT(rate_of(all, 5.0, 60.0), 12.0);
  EXPECT_GT(rate_of(all, 5.0, 60.0, Bulk::upper), 1.0);
  EXPECT_LT(age_of(all, 5.0, 60.0, 1.0), kMostAge);
}

TEST(LinkRate, DoesNotOscillate) {
  const auto all = run(60.0, constant(2.0));
  for (double begin = 10.0; begin < 60.0; begin += 5.0)
    EXPECT_NEAR(rate_of(all, begin, begin + 5.0), rate_of(all, 10.0, 60.0), 2.0) << begin << " s";
}

TEST(LinkRate, DecidesTheSameForTheSameValues) {
  const LinkState state{
      .last = {.time = 5.0, .delivered = 1000, .unanswered = 0.2}, .bytes = 1e5, .seconds = 0.5, .known_until = 9.0};
  const LinkMeasurement link{.time = 5.1, .delivered = 30'000, .waiting = 20'000, .unanswered = 0.2};
  const LinkDecision one = decide(state, link, {.bytes = 1000}), same = decide(state, link, {.bytes = 1000});
  EXPECT_EQ(one.sends, same.sends);
  EXPECT_EQ(one.again, same.again);
  EXPECT_EQ(one.state.bytes, same.state.bytes);
}

TEST(LinkRate, AsksNeverForNoTime) {
  // Without progress, and with a clock that stands still or goes back.
  LinkState state;
  for (const double time : {1.0, 1.0, 1.1, 1.2, 1.3, 0.5, 1.4}) {
    const LinkDecision decision =
        decide(state, {.time = time, .delivered = 0, .waiting = 1'000'000, .unanswered = 0.2}, {.bytes = 1});
    state = decision.state;
    EXPECT_GT(decision.again, 0.0);
    EXPECT_LT(decision.again, 1.0);
  }
  EXPECT_FALSE(decide(state, {.time = 1.5, .delivered = 0, .waiting = 1, .unanswered = 0.2}, {.bytes = 1}).sends);
}

}  // namespace
}  // namespace reorient::live
