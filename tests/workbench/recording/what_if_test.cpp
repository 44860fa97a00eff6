// SPDX-License-Identifier: MIT
// A run keeps its latest frames, and they are replayed with other parameters and scripts.
#include "workbench/recording/what_if.h"

#include <atomic>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "engine/record/input_bytes.h"
#include "tests/engine/eventful_run.h"
#include "tests/waiting.h"
#include "workbench/recording/byte_blocks.h"
#include "workbench/recording/recent_frames.h"

namespace reorient {
namespace {

constexpr int kRunFrames = 300;

const std::vector<Bytes>& inputs_of_run() {
  static const std::vector<Bytes> all = eventful_run(kRunFrames);
  return all;
}

class KeptRun : public testing::Test {
 protected:
  /// Runs the engine; frames for which `is_shown` is false are not kept.
  void run(RecentFramesOptions options = {}, const std::function<bool(int)>& is_shown = {}) {
    frames.emplace(options);
    FrameLoop engine(eventful_setup());
    SceneTruth scene;
    for (int i = 0; i < kRunFrames; ++i) {
      const StoredInputs stored(inputs_of_run().at(static_cast<std::size_t>(i)));
      FrameInputs inputs = stored.inputs();
      if (i == change_at) inputs.parameter_changes.push_back(change);
      const bool is_kept = !is_shown || is_shown(i);
      if (is_kept) frames->before(inputs, engine);
      const FrameRecord& frame = engine.step(inputs);
      times.push_back(frame.world.time);
      if (!is_kept) continue;
      frames->observe(frame, scene);
      // Frames come faster than on a robot.
      EXPECT_TRUE(await([&] { return frames->counts().end >= times.back(); })) << i << ' ' << frames->counts().left_out;
    }
  }
  WhatIfAnswer ask(const WhatIfQuestion& question) const { return what_if(*frames->frames(), question); }

  std::optional<RecentFrames> frames;
  std::vector<double> times;
  int change_at = -1;
  ParameterChange change;
};

WhatIfQuestion with(const std::string& name, const std::string& value, double from = 0.0) {
  return {{{{name, value, ParameterOrigin::live, ""}}, {}}, from};
}

TEST_F(KeptRun, IsTheSameWithTheValuesThatItHad) {
  run();
  EXPECT_EQ(frames->counts().frames, static_cast<std::uint64_t>(kRunFrames));
  EXPECT_EQ(frames->counts().left_out, 0u);
  const WhatIfAnswer answer = ask(with("orientation.hold_time", "0.2"));
  ASSERT_EQ(answer.frames.size(), static_cast<std::size_t>(kRunFrames));
  EXPECT_FALSE(answer.first_decision) << answer.first_decision->text;
  EXPECT_FALSE(answer.first_action) << answer.first_action->what;
  EXPECT_FALSE(answer.has_gap);
  EXPECT_FALSE(answer.events.empty());
  for (std::size_t i = 0; i < answer.frames.size(); ++i) {
    const WhatIfAnswer::Frame& frame = answer.frames[i];
    EXPECT_EQ(frame.time, times[i]);
    EXPECT_EQ(frame.recorded.evidence, frame.tried.evidence);
    EXPECT_EQ(frame.recorded.states, frame.tried.states);
  }
}

TEST_F(KeptRun, ShowsBothRunsAndTheFirstDecisionThatDiffers) {
  run();
  const double from = times[30];
  const WhatIfAnswer answer = ask(with("head_scan.timeout", "0.5", from));
  ASSERT_FALSE(answer.frames.empty());
  EXPECT_EQ(answer.frames.front().time, from) << "the frames before it are replayed, but not shown";
  EXPECT_EQ(answer.frames.back().time, times.back());
  ASSERT_TRUE(answer.first_decision);
  EXPECT_NE(answer.first_decision->text.find("head_scan"), std::string::npos) << answer.first_decision->text;
  EXPECT_FALSE(answer.first_decision->recorded);
  EXPECT_TRUE(answer.first_decision->replayed) << "the head turns back sooner";
  ASSERT_TRUE(answer.first_action) << "so the request to the head is another one";
  EXPECT_GE(answer.first_action->time, answer.first_decision->time);
  EXPECT_FALSE(answer.frames.front().recorded.states.empty()) << "the states at the beginning";
}

TEST_F(KeptRun, TriesAnEditOfAScript) {
  run();
  ScriptText edited = *eventful_setup().scripts.find("behaviors/head_scan.lua");
  edited.text = "behavior 'head_scan' { initial = 'still', state 'still' {} }";
  const WhatIfAnswer answer = ask({{{}, {{"behaviors/head_scan.lua", edited}}}, times[30]});
  ASSERT_TRUE(answer.first_decision);
  EXPECT_NE(answer.first_decision->text.find("head_scan"), std::string::npos) << answer.first_decision->text;
}

TEST_F(KeptRun, RefusesAChangeThatTheRunWouldRefuse) {
  run();
  const auto refusal_of = [this](const WhatIfQuestion& question) -> std::string {
    try {
      ask(question);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_NE(refusal_of(with("head_scan.no_such", "1")).find("head_scan.no_such"), std::string::npos);
  EXPECT_NE(refusal_of(with("head_scan.speed", "-1")).find("head_scan.speed"), std::string::npos);
  EXPECT_NE(refusal_of({{{}, {{"behaviors/head_scan.lua", ScriptText{"broken(", ""}}}}}).find("head_scan.lua"),
            std::string::npos);
  EXPECT_NE(refusal_of(with("head_scan.speed", "1", times.back() + 1.0)).find("no frame"), std::string::npos);
}

/// Otherwise the value that the operator set during the span would replace the tried one.
TEST_F(KeptRun, IgnoresRecordedChangesOfTheTriedParameter) {
  change_at = 100;
  change = {"head_scan.timeout", "3.5", ParameterOrigin::live, ""};
  run();
  const WhatIfAnswer tried = ask(with("head_scan.timeout", "0.5", times[50]));
  const WhatIfAnswer as_later = ask(with("head_scan.timeout", "3.5", times[50]));
  const auto states_after = [](const WhatIfAnswer& answer, std::size_t begin) {
    std::vector<std::pair<std::string, std::string>> all;
    for (std::size_t i = begin; i < answer.frames.size(); ++i)
      all.insert(all.end(), answer.frames[i].tried.states.begin(), answer.frames[i].tried.states.end());
    return all;
  };
  EXPECT_NE(states_after(tried, 60), states_after(as_later, 60));
}

TEST_F(KeptRun, ForgetsTheOldestFramesAboveItsLimit) {
  RecentFramesOptions options;
  options.most_bytes = 1'600'000;
  options.state_every = 1.0;
  run(options);
  const RecentFrames::Counts counts = frames->counts();
  EXPECT_LE(counts.bytes, options.most_bytes);
  EXPECT_GT(counts.frames, 30u);
  EXPECT_LT(counts.frames, static_cast<std::uint64_t>(kRunFrames));
  const WhatIfAnswer answer = ask(with("orientation.hold_time", "0.2"));
  EXPECT_EQ(answer.frames.size(), counts.frames);
  EXPECT_EQ(answer.frames.front().time, counts.begin);
  EXPECT_FALSE(answer.first_action);
}

TEST(ByteBlocks, UseReleasedMemoryAgainAndKeepTheRest) {
  constexpr std::size_t kMany = 3'000'000;
  ByteBlocks blocks;
  std::vector<ByteBlocks::Kept> kept;
  std::set<const std::byte*> places;
  for (int i = 0; i < 50; ++i) {
    kept.push_back(blocks.keep(std::vector<std::byte>(kMany, static_cast<std::byte>(i))));
    places.insert(kept.back().bytes.data());
    if (kept.size() > 4) kept.erase(kept.begin());
    for (std::size_t k = 0; k < kept.size(); ++k) {
      const auto expected = static_cast<std::byte>(i + 1 - static_cast<int>(kept.size()) + static_cast<int>(k));
      ASSERT_EQ(kept[k].bytes.front(), expected);
      ASSERT_EQ(kept[k].bytes.back(), expected);
    }
  }
  EXPECT_LE(places.size(), 6u) << "four that are kept, one that is filled, one that was released";
}

TEST(ByteBlocks, KeepMoreThanABlockAndOutliveTheirObject) {
  std::optional<ByteBlocks> blocks(std::in_place);
  const ByteBlocks::Kept large = blocks->keep(std::vector<std::byte>(9'000'000, std::byte{7}));
  const ByteBlocks::Kept small = blocks->keep(std::vector<std::byte>(10, std::byte{8}));
  blocks.reset();
  EXPECT_EQ(large.bytes.size(), 9'000'000u);
  EXPECT_EQ(large.bytes.back(), std::byte{7});
  EXPECT_EQ(small.bytes.back(), std::byte{8});
}

TEST_F(KeptRun, ContinuesAfterFramesThatWereNotShown) {
  run({}, [](int frame) { return frame < 100 || frame >= 150; });
  const WhatIfAnswer answer = ask(with("orientation.hold_time", "0.2"));
  EXPECT_TRUE(answer.has_gap);
  EXPECT_EQ(answer.frames.size(), static_cast<std::size_t>(kRunFrames - 50));
  EXPECT_FALSE(answer.first_action) << "the frames after the gap begin with a state of their own";
}

TEST_F(KeptRun, EndsAQuestionThatIsStopped) {
  run();
  int asked = 0;
  EXPECT_THROW(what_if(*frames->frames(), with("head_scan.speed", "1"), [&] { return ++asked > 10; }), WhatIfStopped);
  EXPECT_LT(asked, 20);
}

TEST_F(KeptRun, IsAskedWhileItContinues) {
  std::atomic<bool> ends = false;
  std::atomic<int> answers = 0;
  std::thread asker;
  frames.emplace();
  FrameLoop engine(eventful_setup());
  for (const Bytes& bytes : inputs_of_run()) {
    const StoredInputs stored(bytes);
    frames->before(stored.inputs(), engine);
    frames->observe(engine.step(stored.inputs()), {});
    const double end = engine.record().world.time;
    await([&] { return frames->counts().end >= end; });
    if (asker.joinable() || end < 1.0) continue;
    asker = std::thread([&] {
      while (!ends) {
        what_if(*frames->frames(), with("head_scan.speed", "1"));
        ++answers;
      }
    });
  }
  await([&] { return answers > 0; });
  ends = true;
  asker.join();
  EXPECT_EQ(frames->counts().left_out, 0u);
}

}  // namespace
}  // namespace reorient
