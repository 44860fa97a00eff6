// SPDX-License-Identifier: MIT
// The same state and the same inputs give the same record for any observer, in any process.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <span>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "engine/record/record_bytes.h"
#include "tests/engine/eventful_run.h"
#include "tests/temporary_folder.h"
#include "tests/this_program.h"

namespace reorient {
namespace {

constexpr int kFrames = 480;

const std::vector<Bytes>& run() {
  static const std::vector<Bytes> frames = eventful_run(kFrames);
  return frames;
}

/// The topics that are always filled, and the other reproducible topics that the record contains.
Bytes content_of(const FrameRecord& record) {
  Bytes bytes;
  for (const TopicInfo& topic : kTopics) {
    if (topic.reproducible && record.filled.has(topic.topic)) write_topic(record, topic.topic, bytes);
  }
  return bytes;
}

Bytes always_of(const FrameRecord& record) {
  Bytes bytes;
  for (const TopicInfo& topic : kTopics) {
    if (topic.always) write_topic(record, topic.topic, bytes);
  }
  return bytes;
}

Bytes state_of(const FrameLoop& engine) {
  Bytes bytes;
  engine.save(bytes);
  return bytes;
}

constexpr Topics kEverything = Topics::all();

/// Frames from `begin` on, each as its record's content.
std::vector<Bytes> records(FrameLoop& engine, int begin, int end, Topics wanted = kEverything) {
  std::vector<Bytes> all;
  for (int i = begin; i < end; ++i)
    all.push_back(content_of(engine.step(StoredInputs(run()[static_cast<std::size_t>(i)]).inputs(), wanted)));
  return all;
}

TEST(Inputs, AreReadBackFromBytesUnchanged) {
  for (const Bytes& bytes : run()) {
    Bytes again;
    write_inputs(StoredInputs(bytes).inputs(), again);
    ASSERT_EQ(again, bytes);
  }
}

/// A recording brings the limits of its scripts. Together they must not exceed those of the program.
TEST(State, WithHugeLimitsOfItsScriptsIsRefusedBeforeTheyRun) {
  FrameSetup setup = eventful_setup();
  const Bytes state = state_of(FrameLoop(setup));
  struct Limit {
    const char* name;
    std::size_t at;  // in the limits, which begin with the three that are bounded
    std::int32_t value;
  };
  const auto with = [&](const Limit& limit) {
    const std::int32_t usual[] = {kDefaultLimits.instructions_per_frame, kDefaultLimits.instructions_per_load,
                                  kDefaultLimits.max_memory, kDefaultLimits.string_length};
    const auto pattern = std::as_bytes(std::span(usual));
    Bytes changed = state;
    int found = 0;
    for (auto at = changed.begin();
         (at = std::search(at, changed.end(), pattern.begin(), pattern.end())) != changed.end(); at += 1) {
      std::memcpy(&*at + sizeof(std::int32_t) * limit.at, &limit.value, sizeof(limit.value));
      ++found;
    }
    EXPECT_GT(found, 0) << "the limits of each script";
    return changed;
  };
  for (const Limit& limit : {Limit{"instructions_per_frame", 0, 100'000'000},
                             Limit{"instructions_per_load", 1, 1'000'000'000}, Limit{"max_memory", 2, 1'048'576}}) {
    const Bytes changed = with(limit);
    try {
      const FrameLoop engine{std::span<const std::byte>(changed)};
      ADD_FAILURE() << limit.name;
    } catch (const BadBytes& bad) {
      EXPECT_NE(std::string(bad.what()).find("script." + std::string(limit.name) + ": expected at most "),
                std::string::npos)
          << bad.what();
    }
  }
  EXPECT_NO_THROW(FrameLoop{std::span<const std::byte>(with({"max_memory", 2, 2048}))});
}

TEST(Inputs, GiveTheSameRecordsForAnyObserver) {
  FrameLoop watched(eventful_setup());
  FrameLoop alone(eventful_setup());
  bool granted = false, fault = false, reload = false;
  for (const Bytes& bytes : run()) {
    const StoredInputs inputs(bytes);
    const FrameRecord& record = watched.step(inputs.inputs(), kEverything);
    ASSERT_EQ(always_of(record), always_of(alone.step(StoredInputs(bytes).inputs())));
    granted |= record.reorientation.has_value();
    fault |= !record.faults.empty();
    reload |= !record.reloads.empty();
  }
  EXPECT_TRUE(granted && fault && reload) << "the run should contain all events";
  EXPECT_EQ(state_of(watched), state_of(alone));
}

TEST(Inputs, AreRefusedIfTruncatedOrOfAnotherFormat) {
  const Bytes& good = run()[0];
  for (std::size_t size = 0; size < good.size(); size += 1 + good.size() / 50)
    EXPECT_THROW(StoredInputs(std::span(good).first(size)), BadBytes);
  Bytes bad = good;
  bad[0] = std::byte{0};
  EXPECT_THROW(StoredInputs{bad}, BadBytes);
  bad = good;
  bad.push_back({});
  EXPECT_THROW(StoredInputs{bad}, BadBytes);
}

/// One loop that runs without interruption: its state before each frame, and its records.
struct Uninterrupted {
  std::vector<Bytes> states;
  std::vector<Bytes> records;

  Uninterrupted() {
    FrameLoop engine(eventful_setup());
    for (const Bytes& inputs : run()) {
      states.push_back(state_of(engine));
      records.push_back(content_of(engine.step(StoredInputs(inputs).inputs(), kEverything)));
    }
    states.push_back(state_of(engine));
  }
};

RC_GTEST_PROP(State, SavedAndRestoredContinuesTheSame, ()) {
  static const Uninterrupted whole;
  constexpr int kLength = 20;
  const auto begin = *rc::gen::inRange(0, kFrames - kLength);
  FrameLoop restored{std::span<const std::byte>(whole.states[static_cast<std::size_t>(begin)])};
  const std::vector<Bytes> part = records(restored, begin, begin + kLength);
  for (int i = 0; i < kLength; ++i) {
    const Bytes& expected = whole.records[static_cast<std::size_t>(begin + i)];
    if (part[static_cast<std::size_t>(i)] != expected) RC_FAIL("frame " + std::to_string(begin + i) + " differs");
  }
  RC_ASSERT(state_of(restored) == whole.states[static_cast<std::size_t>(begin + kLength)]);
}

TEST(State, CanBeSavedBeforeTheFirstFrame) {
  FrameLoop engine(eventful_setup());
  const Bytes state = state_of(engine);
  FrameLoop restored{std::span<const std::byte>(state)};
  EXPECT_EQ(records(restored, 0, 60), records(engine, 0, 60));
}

TEST(State, OfARobotWithoutRoomAwarenessIsRestored) {
  FrameSetup setup = eventful_setup();
  setup.room_awareness = false;
  FrameLoop engine(std::move(setup));
  records(engine, 0, 60);
  const Bytes state = state_of(engine);
  FrameLoop restored{std::span<const std::byte>(state)};
  EXPECT_EQ(records(restored, 60, 120), records(engine, 60, 120));
}

TEST(State, ContainsAScriptOnTrialAndTheVersionForARollback) {
  const char* const good = "behavior \"b\" { update = function() log.info(\"good\") end }";
  const char* const bad = "behavior \"b\" { update = function() error(\"bad\") end }";
  FrameSetup setup;
  setup.scripts.apply({"behaviors/b.lua", ScriptText{good, ""}});
  setup.behaviors = {"b"};
  FrameLoop engine(std::move(setup));
  FrameInputs inputs;
  const auto step = [&inputs](FrameLoop& loop, int frames) {
    for (int i = 0; i < frames; ++i) {
      inputs.observation.time += 0.1;
      loop.step(inputs);
      inputs.script_edits.clear();
    }
  };
  step(engine, 30);
  inputs.script_edits.push_back({"behaviors/b.lua", ScriptText{bad, ""}});
  step(engine, 2);
  const Bytes state = state_of(engine);
  FrameLoop restored{std::span<const std::byte>(state)};
  step(restored, 10);
  ASSERT_EQ(restored.record().logs.size(), 1u);
  EXPECT_EQ(restored.record().logs[0].text, "good");
}

std::string digits(const Bytes& bytes) {
  Digest digest;
  digest.add(std::span<const std::byte>(bytes));
  return digest.hex();
}

Bytes read_bytes(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  Bytes bytes(text.size());
  std::memcpy(bytes.data(), text.data(), text.size());
  return bytes;
}

/// The second process: continues with the state from the file that the environment names, and prints the records.
TEST(StateInAnotherProcess, DISABLED_Continues) {
  const char* const file = std::getenv("REORIENT_TEST_STATE");
  ASSERT_NE(file, nullptr);
  const Bytes state = read_bytes(file);
  FrameLoop restored{std::span<const std::byte>(state)};
  for (const Bytes& record : records(restored, 240, 480)) std::printf("record %s\n", digits(record).c_str());
}

TEST(State, ContinuesTheSameInAnotherProcess) {
  FrameLoop engine(eventful_setup());
  records(engine, 0, 240);
  const Bytes state = state_of(engine);
  const TemporaryFolder folder;
  const std::filesystem::path file =
      folder.write("state", std::string(reinterpret_cast<const char*>(state.data()), state.size()));
  std::string expected;
  for (const Bytes& record : records(engine, 240, 480)) expected += "record " + digits(record) + "\n";

  const std::string command = "REORIENT_TEST_STATE='" + file.string() + "' " + this_program() +
                              " --gtest_also_run_disabled_tests --gtest_filter='StateInAnotherProcess.*' 2>&1";
  FILE* const pipe = popen(command.c_str(), "r");
  ASSERT_NE(pipe, nullptr);
  std::string output;
  std::array<char, 256> line{};
  while (std::fgets(line.data(), line.size(), pipe) != nullptr) {
    if (std::string_view(line.data()).starts_with("record ")) output += line.data();
  }
  EXPECT_EQ(pclose(pipe), 0);
  EXPECT_EQ(output, expected);
}

TEST(State, IsRefusedIfTruncatedOrOfAnotherFormat) {
  FrameLoop engine(eventful_setup());
  records(engine, 0, 30, {});
  Bytes state = state_of(engine);
  for (std::size_t size = 0; size < state.size(); size += 1 + state.size() / 40)
    EXPECT_THROW(FrameLoop{std::span<const std::byte>(state).first(size)}, BadBytes) << size;
  state.push_back({});
  EXPECT_THROW(FrameLoop{std::span<const std::byte>(state)}, BadBytes);
  state.pop_back();
  state[0] = std::byte{0};
  EXPECT_THROW(FrameLoop{std::span<const std::byte>(state)}, BadBytes);
}

TEST(State, WithAnImpossibleBodyIsRefusedWithAReason) {
  const RobotBody body = eventful_setup().body;
  const FrameLoop engine(eventful_setup());
  const Bytes state = state_of(engine);
  Bytes known;
  ByteWriter{known}(body);
  const auto place = std::search(state.begin(), state.end(), known.begin(), known.end());
  ASSERT_NE(place, state.end());
  const std::vector<std::function<void(RobotBody&)>> changes{
      [](RobotBody& one) { one.dimensions.torso_height = 1e308; },
      [](RobotBody& one) { one.dimensions.torso_height = std::nan(""); },
      [](RobotBody& one) { one.dimensions.upper.position.x() = -1e9; },
      [](RobotBody& one) { one.upper_camera.width = 2'000'000'000; },
      [](RobotBody& one) { one.upper_camera.height = -1; },
      [](RobotBody& one) { one.upper_camera.field_of_view_vertical = 0.0; },
      [](RobotBody& one) { one.neck.pitch[0].min = 1e300; },
      [](RobotBody& one) { one.neck.pitch.clear(); },
      [](RobotBody& one) { one.neck.yaw = std::nan(""); },
      [](RobotBody& one) { one.head_speed = 1e308; },
      [](RobotBody& one) { one.get_up_time = 1e308; },
      [](RobotBody& one) { one.name = std::string(1000, 'x'); }};  // possible
  for (std::size_t i = 0; i < changes.size(); ++i) {
    RobotBody changed = body;
    changes[i](changed);
    Bytes forged(state.begin(), place);
    ByteWriter{forged}(changed);
    forged.insert(forged.end(), place + static_cast<std::ptrdiff_t>(known.size()), state.end());
    std::string why;
    try {
      const FrameLoop restored{std::span<const std::byte>(forged)};
    } catch (const BadBytes& bad) {
      why = bad.what();
    }
    const bool is_possible = i + 1 == changes.size();
    EXPECT_EQ(why, is_possible ? "" : "state: impossible body of the robot (expected the measures of a humanoid)") << i;
  }
}

RC_GTEST_PROP(State, ThatIsDamagedNeverCrashesTheReader, ()) {
  static const Bytes good = [] {
    FrameLoop engine(eventful_setup());
    records(engine, 0, 90, {});
    return state_of(engine);
  }();
  Bytes state = good;
  const int changes = *rc::gen::inRange(1, 6);
  for (int i = 0; i < changes; ++i) {
    // The filters are at the start, the texts at the end.
    const std::size_t range = *rc::gen::arbitrary<bool>() ? state.size() : std::min<std::size_t>(state.size(), 4000);
    state[*rc::gen::inRange<std::size_t>(0, range)] = static_cast<std::byte>(*rc::gen::inRange(0, 256));
  }
  try {
    FrameLoop restored{std::span<const std::byte>(state)};
    for (int i = 90; i < 93; ++i) restored.step(StoredInputs(run()[static_cast<std::size_t>(i)]).inputs(), kEverything);
  } catch (const BadBytes&) {
  }
}

}  // namespace
}  // namespace reorient
