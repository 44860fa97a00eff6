// SPDX-License-Identifier: MIT
// Records as bytes, and the digest of a run.
#include "engine/record/record_bytes.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/engine/frame_fixture.h"

namespace reorient {
namespace {

const std::string kBusy = R"(behavior "tested" { initial = "waiting",
  enter = function() command.pause_training() log.info("begins") end,
  state "waiting" { update = function() head.look(0.1, 0.2) end, { "acting", after = 0.05, because = "it is time" } },
  state "acting" { enter = function() command.flip_pose() end, update = function() error("always") end } })";

/// Frames with as many events as possible and all topics filled.
std::vector<FrameRecord> busy_records() {
  HandFedLoop loop(kBusy);
  loop.wanted = Topics::all();
  loop.set_pose(Pose2(-2.0, 1.0, 0.5));
  std::vector<FrameRecord> records;
  for (int i = 0; i < 12; ++i) {
    if (i == 4) loop.inputs.parameter_changes.push_back({"pose_filter.particles", "50", ParameterOrigin::live, ""});
    if (i == 5) loop.inputs.parameter_changes.push_back({"pose_filter.particle", "50", ParameterOrigin::live, ""});
    if (i == 6) loop.inputs.script_edits.push_back({"behaviors/tested.lua", ScriptText{"broken(", ""}});
    records.push_back(loop.step());
    records.back().own_images();
  }
  return records;
}

std::vector<std::byte> bytes_of(const FrameRecord& record) {
  std::vector<std::byte> bytes;
  write_record(record, bytes);
  return bytes;
}

TEST(RecordBytes, AreReadBackAsTheSameRecord) {
  bool any_reorientation = false, any_fault = false, any_log = false, any_reload = false;
  for (const FrameRecord& record : busy_records()) {
    const std::vector<std::byte> bytes = bytes_of(record);
    const FrameRecord read = read_record(bytes);
    EXPECT_EQ(bytes_of(read), bytes);
    EXPECT_EQ(read.filled, record.filled);
    EXPECT_EQ(read.names->names, record.names->names);
    EXPECT_EQ(read.world.pose.pose.position, record.world.pose.pose.position);
    EXPECT_EQ(read.images.upper.width, record.images.upper.width);
    EXPECT_EQ(read.images.upper.at(33, 44), record.images.upper.at(33, 44));
    EXPECT_EQ(read.room.model.size(), record.room.model.size());
    EXPECT_EQ(read.room.evidence, record.room.evidence);
    EXPECT_EQ(read.room.evidence.size(), read.room.model.size());
    EXPECT_EQ(read.feature_fits[0].line_points.size(), read.percepts[0].line_points.size());
    any_reorientation |= read.reorientation.has_value();
    any_fault |= !read.faults.empty();
    any_log |= !read.logs.empty();
    any_reload |= !read.reloads.empty();
  }
  EXPECT_TRUE(any_reorientation && any_fault && any_log && any_reload) << "the frames should contain all events";
}

TEST(RecordBytes, AreRefusedIfTruncatedOrExtended) {
  std::vector<std::byte> bytes = bytes_of(busy_records()[3]);
  for (std::size_t size = 0; size < bytes.size(); size += 1 + size / 50)
    EXPECT_THROW(read_record(std::span<const std::byte>(bytes).first(size)), BadBytes) << size;
  bytes.push_back({});
  EXPECT_THROW(read_record(bytes), BadBytes);
  bytes.pop_back();
  bytes[0] = std::byte{0};
  EXPECT_THROW(read_record(bytes), BadBytes);
}

RC_GTEST_PROP(RecordBytesProperty, ThatAreDamagedNeverCrashTheReader, ()) {
  static const std::vector<std::byte> good = bytes_of(busy_records()[3]);
  std::vector<std::byte> bytes = good;
  const int changes = *rc::gen::inRange(1, 8);
  for (int i = 0; i < changes; ++i) {
    const std::size_t at = *rc::gen::inRange<std::size_t>(0, bytes.size());
    bytes[at] = static_cast<std::byte>(*rc::gen::inRange(0, 256));
  }
  try {
    const FrameRecord record = read_record(bytes);
    for (const TransitionRecord& transition : record.transitions) record.name(transition.machine);
    std::vector<std::byte> again;
    write_record(record, again);
  } catch (const BadBytes&) {
  }
}

TEST(Topics, HaveUniqueNamesInTheirOrder) {
  for (int i = 0; i < kTopicCount; ++i) {
    const TopicInfo& row = kTopics[static_cast<std::size_t>(i)];
    EXPECT_EQ(static_cast<int>(row.topic), i);
    for (int j = 0; j < i; ++j) EXPECT_NE(row.name, kTopics[static_cast<std::size_t>(j)].name);
  }
}

/// The digest after three frames, the second of which differs.
std::uint64_t digest_after(const std::function<void(HandFedLoop&)>& differ, const std::string& behavior = kBusy) {
  FrameSetup setup;
  setup.room_awareness = false;
  HandFedLoop loop(behavior, std::move(setup));
  loop.wanted = {Topic::images};
  RecordDigest digest;
  for (int i = 0; i < 3; ++i) {
    if (i == 1) differ(loop);
    digest.add(loop.step());
  }
  return digest.digest().value();
}

TEST(RecordDigest, IsTheSameForTheSameInputs) {
  const auto nothing = [](HandFedLoop&) {};
  EXPECT_EQ(digest_after(nothing), digest_after(nothing));
}

TEST(RecordDigest, DoesNotDependOnTheRequestedTopics) {
  EXPECT_EQ(digest_after([](HandFedLoop& loop) { loop.wanted = Topics::all(); }), digest_after([](HandFedLoop&) {}));
}

TEST(RecordDigest, ChangesWithAnyBitOfTheImage) {
  const std::uint64_t before = digest_after([](HandFedLoop&) {});
  for (const auto& [x, y] : {std::pair(0, 0), std::pair(319, 0), std::pair(1, 60), std::pair(160, 61),
                             std::pair(0, 119), std::pair(319, 119)}) {
    EXPECT_NE(digest_after([x = x, y = y](HandFedLoop& loop) { loop.image.row(y)[x] ^= 1; }), before) << x << ' ' << y;
  }
}

TEST(RecordDigest, ChangesWithEachMeasurement) {
  const std::uint64_t before = digest_after([](HandFedLoop&) {});
  const std::pair<const char*, std::function<void(Observation&)>> changes[] = {
      {"time", [](Observation& o) { o.time += 1e-9; }},
      {"head yaw", [](Observation& o) { o.body.head.yaw += 1e-9; }},
      {"head pitch", [](Observation& o) { o.body.head.pitch += 1e-9; }},
      {"torso roll", [](Observation& o) { o.body.torso.roll += 1e-9; }},
      {"torso pitch", [](Observation& o) { o.body.torso.pitch += 1e-9; }},
      {"angular velocity", [](Observation& o) { o.body.angular_velocity.y() += 1e-9; }},
      {"acceleration", [](Observation& o) { o.body.acceleration.x() += 1e-9; }},
      {"odometry x", [](Observation& o) { o.odometry.position.x() += 1e-9; }},
      {"odometry y", [](Observation& o) { o.odometry.position.y() += 1e-9; }},
      {"odometry rotation", [](Observation& o) { o.odometry.rotation += 1e-9; }},
      {"foot load", [](Observation& o) { o.body.foot_load += 1e-9; }},
      {"penalized", [](Observation& o) { o.external.referee = RefereeState{true}; }},
      {"focal length", [](Observation& o) { o.upper->camera.focal.x() += 1e-9; }},
      {"distortion", [](Observation& o) { o.upper->camera.k1 += 1e-9; }},
      {"camera pose", [](Observation& o) { o.upper->robot_from_camera.translation().x() += 1e-9; }},
  };
  for (const auto& [name, change] : changes) {
    EXPECT_NE(digest_after([&change = change](HandFedLoop& loop) { change(loop.inputs.observation); }), before) << name;
  }
}

TEST(RecordDigest, ChangesWithTheCommandsAlone) {
  const auto nothing = [](HandFedLoop&) {};
  const std::string training = R"(behavior "tested" { enter = function() command.pause_training() end })";
  const std::string evaluation = R"(behavior "tested" { enter = function() command.pause_evaluation() end })";
  EXPECT_NE(digest_after(nothing, training), digest_after(nothing, evaluation));
  EXPECT_EQ(digest_after(nothing, training), digest_after(nothing, training));
}

}  // namespace
}  // namespace reorient
