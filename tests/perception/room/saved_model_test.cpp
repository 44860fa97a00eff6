// SPDX-License-Identifier: MIT
// Saved models of rooms: written and read, damaged, and used by a robot on another day.
#include "perception/room/saved_model.h"

#include <cmath>
#include <cstring>
#include <functional>
#include <string>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "geometry/pose2.h"
#include "perception/room/room_awareness.h"
#include "tests/perception/room/painted_room.h"
#include "tests/perception/room/saved_models.h"

namespace reorient {
namespace {

using test::bytes_of;
using test::ModelBytes;
using test::some_model;

std::string refusal_of(const ModelBytes& bytes) {
  try {
    read_model(bytes);
    return "none";
  } catch (const BadBytes& refused) {
    return refused.what();
  }
}

RC_GTEST_PROP(SavedModel, IsReadBackUnchanged, ()) {
  const SavedModel model = some_model(*rc::gen::arbitrary<std::uint64_t>(), 0, *rc::gen::inRange(0, 100) / 100.0,
                                      *rc::gen::inRange(0, 48), *rc::gen::inRange(0, 49));
  const ModelBytes bytes = bytes_of(model);
  const SavedModel read = read_model(bytes);
  RC_ASSERT(bytes_of(read) == bytes);
  RC_ASSERT(read.learned == model.learned);
  RC_ASSERT(differences(read.basis, model.basis).empty());
  RC_ASSERT(read.model.known_tiles() == model.model.known_tiles());
}

CameraBias some_bias() {
  CameraBias bias;
  bias.torso = {0.01, -0.02};
  bias.mounts = {TiltBias{0.03, 0.04}, TiltBias{-0.05, 0.06}};
  bias.deviation = 0.004;
  return bias;
}

TEST(SavedModel, ContainsTheAnglesOfTheRobotThatLearnedIt) {
  SavedModel model = some_model(1);
  model.camera_bias = KnownBias{1234, some_bias()};
  const SavedModel read = read_model(bytes_of(model));
  ASSERT_TRUE(read.camera_bias);
  EXPECT_EQ(read.camera_bias->body, 1234u);
  EXPECT_EQ(read.camera_bias->bias.torso.pitch, -0.02);
  EXPECT_EQ(read.camera_bias->bias.mounts[1].pitch, 0.06);
  EXPECT_EQ(read.camera_bias->bias.deviation, 0.004);
}

TEST(SavedModel, WithImpossibleCameraAnglesIsRefused) {
  for (const double angle : {std::nan(""), 2.0, -1e300}) {
    SavedModel model = some_model(1);
    model.camera_bias = KnownBias{1, some_bias()};
    model.camera_bias->bias.mounts[0].roll = angle;
    EXPECT_EQ(refusal_of(bytes_of(model)), "it is damaged: an angle of a camera is invalid");
  }
}

TEST(SavedModel, OfTheFirstFormatIsReadWithoutAngles) {
  const SavedModel model = some_model(1);
  ModelBytes bytes = bytes_of(model);
  bytes.erase(bytes.end() - 9);  // the flag for missing angles, before the checksum
  bytes = test::with(std::move(bytes), test::kVersionAt, std::uint32_t{1});
  std::uint32_t size = 0;
  std::memcpy(&size, bytes.data() + test::kSizeAt, sizeof(size));
  bytes = test::with_checksum(test::with(std::move(bytes), test::kSizeAt, size - 1));
  const SavedModel read = read_model(bytes);
  EXPECT_FALSE(read.camera_bias);
  EXPECT_EQ(read.model.known_tiles(), model.model.known_tiles());
}

RC_GTEST_PROP(SavedModel, RotatedTwiceBy180DegreesIsUnchanged, ()) {
  SavedModel model = some_model(*rc::gen::arbitrary<std::uint64_t>());
  const ModelBytes before = bytes_of(model);
  model.rotate_by_180_degrees();
  RC_ASSERT(bytes_of(model) != before);
  model.rotate_by_180_degrees();
  RC_ASSERT(bytes_of(model) == before);
}

TEST(SavedModel, HasTheBytesOfItsFormat) {
  // Old files must stay readable: a change of the content of a model needs a new format number.
  SavedModel model;
  model.basis.wall = {9.0, 0.5, 2.5, 1, 4};
  model.learned = 12.5;
  std::vector<TileModel> tiles(4);
  tiles[1].mean[0] = 0.25f;
  tiles[1].mean[13] = 0.75f;
  tiles[1].variance[2] = 0.5f;
  tiles[1].visits = 3;
  tiles[1].trained = 0.1;
  tiles[1].light = {1.5, -2.0, 3.0};
  tiles[1].light_visits = 2;
  model.model = BackgroundModel(tiles);
  const ModelBytes bytes = bytes_of(model);
  ASSERT_EQ(bytes.size(), 16u + 78u + 4u * 152u + 1u + 8u);
  EXPECT_EQ(std::memcmp(bytes.data(), "RRmModel\x02\0\0\0", 12), 0);
  std::uint64_t checksum = 0;
  std::memcpy(&checksum, bytes.data() + bytes.size() - 8, 8);
  EXPECT_EQ(checksum, 0xA9A303988C0A6757ull);
}

TEST(SavedModel, OfDamagedBytesIsRefusedWithTheReason) {
  const std::vector<test::DamagedModel> all = test::damaged_models();
  EXPECT_GE(all.size(), 48u);
  for (const test::DamagedModel& damaged : all) {
    const std::string refusal = refusal_of(damaged.bytes);
    EXPECT_NE(refusal.find(damaged.complaint), std::string::npos) << damaged.what << ": " << refusal;
    EXPECT_EQ(refusal.find('\n'), std::string::npos) << damaged.what;
  }
}

TEST(SavedModel, WithAnyByteChangedIsRefused) {
  const ModelBytes good = bytes_of(some_model(1));
  for (std::size_t i = 0; i < good.size(); i += i < 300 ? 1 : 37) {
    for (const unsigned flip : {0x01u, 0x80u, 0xFFu})
      EXPECT_NE(refusal_of(test::with(good, i, good[i] ^ static_cast<std::byte>(flip))), "none") << i;
  }
}

TEST(SavedModel, CutAnywhereIsRefused) {
  const ModelBytes good = bytes_of(some_model(1));
  for (std::size_t size = 0; size < good.size(); size += size < 300 ? 1 : 41)
    EXPECT_NE(refusal_of({good.begin(), good.begin() + static_cast<long>(size)}), "none") << size;
}

SavedModel learned_by(const test::ScanningRobot& robot, double seconds) {
  SavedModel model{robot.awareness.basis(), seconds, BackgroundModel()};
  model.model = robot.awareness.model();
  return model;
}

TEST(ModelOfYesterday, DetectsAWrongBeliefWithinThreeSecondsInOtherLight) {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    const test::PaintedRoom room = test::PaintedRoom::colorful(seed);
    test::ScanningRobot yesterday(room, {}, seed);
    yesterday.run(30.0);
    test::ScanningRobot today(room, {}, seed + 100);
    today.exposure = {1.5, 6.0, -5.0};
    today.belief = reflect(today.truth);
    today.train = false;
    today.awareness.take_model(read_model(bytes_of(learned_by(yesterday, 30.0))));
    today.run(3.0);
    EXPECT_GT(today.awareness.confidences().evidence, 5.5) << "threshold of scripts/lib/decision.lua";
    EXPECT_GT(today.awareness.confidences().coverage, 0.3);
  }
}

TEST(ModelOfYesterday, RotatedSupportsTheReflection) {
  const test::PaintedRoom room = test::PaintedRoom::colorful(4);
  test::ScanningRobot yesterday(room, {}, 4);
  yesterday.run(30.0);
  SavedModel model = learned_by(yesterday, 30.0);
  model.rotate_by_180_degrees();
  test::ScanningRobot today(room, {}, 5);
  today.train = false;
  today.awareness.take_model(model);
  today.run(3.0);
  EXPECT_GT(today.awareness.confidences().evidence, 5.5);
  today.belief = reflect(today.truth);
  today.awareness.restart();
  today.run(3.0);
  EXPECT_LT(today.awareness.confidences().evidence, -5.5);
}

TEST(ModelOfYesterday, ReplacesOnlyTheModel) {
  const test::PaintedRoom room = test::PaintedRoom::colorful(6);
  test::ScanningRobot robot(room, {}, 6);
  robot.run(20.0);
  const SavedModel model = learned_by(robot, 20.0);
  robot.awareness.take_model(model);
  const Confidences& confidences = robot.awareness.confidences();
  EXPECT_EQ(confidences.evidence, 0.0);
  EXPECT_EQ(confidences.current, 0.0);
  EXPECT_EQ(confidences.age, 0.0);
  EXPECT_EQ(robot.awareness.light().luma, Light().luma);
  EXPECT_EQ(bytes_of(learned_by(robot, 20.0)), bytes_of(model));
}

TEST(ModelOfYesterday, WithOtherParametersIsRefusedWithTheirNames) {
  const SavedModel model = some_model(1);
  const auto refusal = [&](const std::function<void(RoomParameters&)>& change) -> std::string {
    RoomParameters parameters;
    change(parameters);
    RoomAwareness room(parameters);
    try {
      room.take_model(model);
      return "none";
    } catch (const UnfitModel& unfit) {
      EXPECT_EQ(room.model().known_tiles(), 0) << "the room awareness is unchanged";
      return unfit.what();
    }
  };
  const std::string reason = "it was learned with other parameters: ";
  EXPECT_EQ(refusal([](RoomParameters& p) { p.wall.radius = 9.0; }), reason + "wall.radius=8");
  EXPECT_EQ(refusal([](RoomParameters& p) { p.wall.columns = 24; }), reason + "wall.columns=48");
  EXPECT_EQ(refusal([](RoomParameters& p) { p.wall.rows = 2, p.wall.top = 3.1; }), reason + "wall.top=5.5 wall.rows=4");
  EXPECT_EQ(refusal([](RoomParameters& p) { p.wall.bottom = 0.75; }), reason + "wall.bottom=0.7");
  EXPECT_EQ(refusal([](RoomParameters& p) { p.color.gray_within = 6.5; }), reason + "color.gray_within=5");
  EXPECT_EQ(refusal([](RoomParameters& p) { p.color.blur = 0.05; }), reason + "color.blur=0");
  EXPECT_EQ(refusal([](RoomParameters& p) { p.light.enabled = false; }), reason + "light_adaptation.enabled=true");
  EXPECT_EQ(refusal([](RoomParameters& p) { p.pose_light.enabled = false; }), reason + "pose_light.enabled=true");
  EXPECT_EQ(refusal([](RoomParameters& p) { p.wall.columns = 47; }), "none") << "an odd number is made even";
  EXPECT_EQ(refusal([](RoomParameters& p) { p.evidence.gain = 9.0; }), "none") << "the gain changes no histogram";
}

}  // namespace
}  // namespace reorient
