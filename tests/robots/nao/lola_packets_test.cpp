// SPDX-License-Identifier: MIT
// LoLA's packets, with the sizes of those of a real robot.
#include <algorithm>
#include <array>
#include <limits>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/head.h"
#include "robots/nao/lola/command_packet.h"
#include "robots/nao/lola/packed.h"
#include "robots/nao/lola/packet_stream.h"
#include "robots/nao/lola/sensor_packet.h"
#include "tests/robots/nao/twin/twin_body.h"

namespace reorient::nao {
namespace {

constexpr std::uint32_t kAll = (1u << kSensorKeys) - 1;

std::vector<std::byte> packet_of(const Measurement& measurement) {
  std::vector<std::byte> bytes(4096);
  bytes.resize(write_sensor_packet(measurement, TwinBody().identity(), bytes));
  return bytes;
}

/// A map of one key with these numbers.
std::vector<std::byte> packet_with(std::string_view key, const std::vector<float>& numbers) {
  std::vector<std::byte> bytes(4096);
  PackedWriter writer(bytes);
  writer.map(1);
  writer.text(key);
  writer.array(static_cast<std::uint32_t>(numbers.size()));
  for (const float number : numbers) writer.number(number);
  bytes.resize(writer.size());
  return bytes;
}

TEST(SensorPacket, Has896BytesLikeThatOfARobot) { EXPECT_EQ(packet_of(TwinBody().measurement()).size(), 896u); }

TEST(SensorPacket, IsUnchangedByWritingAndReading) {
  Measurement written = TwinBody().measurement();
  written.position[kHeadYaw] = 0.25f;
  written.status[kLeftKneePitch] = 2.0f;
  Measurement read;
  SensorReader reader;
  ASSERT_TRUE(reader.read(packet_of(written), read));
  EXPECT_EQ(read.fresh, kAll);
  EXPECT_EQ(read.position, written.position);
  EXPECT_EQ(read.status, written.status);
  EXPECT_EQ(read.accelerometer, written.accelerometer);
  EXPECT_EQ(read.fsr, written.fsr);
  EXPECT_EQ(read.battery, written.battery);
  ASSERT_TRUE(reader.robot());
  EXPECT_STREQ(reader.robot()->body_version.data(), "6.0.0");
  EXPECT_STREQ(reader.robot()->head_id.data(), "P0000074A04S83I00012");
}

TEST(SensorPacket, MayHaveItsKeysInAnyOrderAndUnknownKeys) {
  std::vector<std::byte> bytes(4096);
  PackedWriter writer(bytes);
  writer.map(3);
  writer.text("Angles");
  writer.array(2);
  writer.number(0.1f);
  writer.number(0.2f);
  writer.text("Whistle");
  writer.map(1);
  writer.text("heard");
  writer.array(0);
  writer.text("Position");
  writer.array(kJoints);
  for (std::size_t i = 0; i < kJoints; ++i) writer.small(1);
  bytes.resize(writer.size());
  SensorReader reader;
  Measurement measurement;
  for (int again = 0; again < 2; ++again) {
    ASSERT_TRUE(reader.read(bytes, measurement));
    EXPECT_TRUE(measurement.has(SensorKey::angles));
    EXPECT_TRUE(measurement.has(SensorKey::position));
    EXPECT_FALSE(measurement.has(SensorKey::status));
    EXPECT_EQ(measurement.angles[1], 0.2f);
    EXPECT_EQ(measurement.position[kRightHand], 1.0f);
  }
}

TEST(SensorPacket, MayChangeTheOrderOfItsKeys) {
  SensorReader reader;
  Measurement measurement;
  ASSERT_TRUE(reader.read(packet_with("Angles", {0.1f, 0.2f}), measurement));
  ASSERT_TRUE(reader.read(packet_with("Sonar", {0.3f, 0.4f}), measurement));
  EXPECT_EQ(measurement.sonar[0], 0.3f);
  EXPECT_EQ(measurement.angles[0], 0.1f);
  EXPECT_FALSE(measurement.has(SensorKey::angles));
}

TEST(SensorPacket, InvalidNumbersLeaveTheMeasurementUnchanged) {
  SensorReader reader;
  Measurement measurement;
  measurement.angles = {0.5f, 0.6f};
  for (const float odd : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
    ASSERT_TRUE(reader.read(packet_with("Angles", {0.1f, odd}), measurement));
    EXPECT_EQ(measurement.angles, (std::array{0.5f, 0.6f}));
    EXPECT_FALSE(measurement.has(SensorKey::angles));
  }
  ASSERT_TRUE(reader.read(packet_with("Angles", {0.1f}), measurement));
  EXPECT_EQ(measurement.angles, (std::array{0.5f, 0.6f}));
}

TEST(CommandPacket, WithAllElevenKeysHas786Bytes) {
  const std::array<std::byte, kCommandBytes> bytes = command_packet(Command());
  const PackedExtent extent = first_packed_value(bytes);
  EXPECT_EQ(extent.state, PackedExtent::State::whole);
  EXPECT_EQ(extent.size, 786u);
}

TEST(CommandPacket, IsUnchangedByWritingAndReading) {
  Command written;
  written.position[kHeadPitch] = 0.3f;
  written.stiffness.fill(0.5f);
  written.lights.left_eye[2] = {0.1f, 0.2f, 0.3f};
  written.lights.chest = {1.0f, 0.5f, 0.25f};
  written.lights.skull[11] = 0.75f;
  Command read;
  ASSERT_TRUE(read_command_packet(command_packet(written), read));
  EXPECT_EQ(read.position, written.position);
  EXPECT_EQ(read.stiffness, written.stiffness);
  EXPECT_EQ(read.lights.left_eye, written.lights.left_eye);
  EXPECT_EQ(read.lights.chest, written.lights.chest);
  EXPECT_EQ(read.lights.skull, written.lights.skull);
}

class LolaStream : public testing::Test {
 protected:
  void send(std::span<const std::byte> bytes) {
    const std::span<std::byte> space = stream_.space();
    ASSERT_LE(bytes.size(), space.size());
    std::copy(bytes.begin(), bytes.end(), space.begin());
    stream_.written(bytes.size());
  }
  int packets() {
    int count = 0;
    std::span<const std::byte> packet;
    while (stream_.next(packet) == PacketStream::State::packet) ++count;
    return count;
  }
  PacketStream stream_;
  const std::vector<std::byte> one_ = packet_of(TwinBody().measurement());
};

TEST_F(LolaStream, JoinsThePiecesOfAPacket) {
  for (std::size_t i = 0; i + 1 < one_.size(); ++i) {
    send(std::span(one_).subspan(i, 1));
    ASSERT_EQ(packets(), 0);
  }
  send(std::span(one_).last(1));
  EXPECT_EQ(packets(), 1);
}

TEST_F(LolaStream, SeparatesSeveralPackets) {
  std::vector<std::byte> three;
  for (int i = 0; i < 3; ++i) three.insert(three.end(), one_.begin(), one_.end());
  send(std::span(three).first(three.size() - 10));
  EXPECT_EQ(packets(), 2);
  send(std::span(three).last(10));
  EXPECT_EQ(packets(), 1);
}

TEST_F(LolaStream, RejectsAPacketWithoutAnEnd) {
  std::span<const std::byte> packet;
  send(std::array{std::byte{0xdb}, std::byte{0x7f}, std::byte{0xff}, std::byte{0xff}, std::byte{0xff}});
  EXPECT_EQ(stream_.next(packet), PacketStream::State::waiting);
  send(std::vector<std::byte>(PacketStream::kLongest));
  EXPECT_EQ(stream_.next(packet), PacketStream::State::invalid);
}

TEST(HeadPitchRange, MatchesTheNeckOfTheEngine) {
  const NeckReach neck;
  for (double yaw = -2.08; yaw < 2.08; yaw += 0.05) {
    const PitchRange range = head_pitch_range(static_cast<float>(yaw));
    EXPECT_NEAR(range.least, neck.pitch_at(yaw).min, 1e-5) << yaw;
    EXPECT_NEAR(range.most, neck.pitch_at(yaw).max, 1e-5) << yaw;
  }
}

TEST(HeadPitchRange, IsInterpolatedBetweenTheRowsOfTheTable) {
  EXPECT_FLOAT_EQ(head_pitch_range(0.0f).most, 0.515f);
  EXPECT_FLOAT_EQ(head_pitch_range(-0.486f).most, 0.422f);
  EXPECT_NEAR(head_pitch_range(0.243f).most, 0.4685f, 1e-4f);
  EXPECT_FLOAT_EQ(head_pitch_range(3.0f).least, -0.449f);
}

}  // namespace
}  // namespace reorient::nao
