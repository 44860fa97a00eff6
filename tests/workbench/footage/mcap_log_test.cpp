// SPDX-License-Identifier: MIT
// Logs in MCAP files, written for the test and read back as footage.
#include "workbench/footage/mcap_log.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/paths.h"
#include "tests/robots/footage/ros_messages.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/footage/ros_log_writer.h"
#include "tests/workbench/recording/raw_mcap.h"

namespace reorient {
namespace {

using Bytes = std::vector<std::byte>;

/// A walk along an arc while head and torso move.
std::vector<FootageFrame> walk(int count = 20) {
  std::vector<FootageFrame> frames;
  for (int i = 0; i < count; ++i) {
    FootageFrame frame;
    frame.time = 0.1 * i;
    frame.image = Image(8, 6);
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 16; ++x) frame.image.row(y)[x] = static_cast<std::uint8_t>(3 * i + 16 * y + x);
    frame.camera.width = 8;
    frame.camera.height = 6;
    frame.camera.focal = {9.0, 10.0};
    frame.camera.center = {3.25, 2.75};
    frame.camera.k1 = -0.1;
    frame.torso = {0.02 * std::sin(0.5 * i), 0.1};
    frame.robot_from_camera = robot_from_camera({}, {0.1 * i, 0.2}, frame.torso, 0.25);
    frame.odometry = Pose2(0.05 * i, 0.01 * i, 0.03 * i);
    frame.pose = Pose2(-2.0, 1.0, 2.5) * *frame.odometry;
    frames.push_back(frame);
  }
  return frames;
}

void expect_same(const FootageFrame& found, const FootageFrame& expected, double start) {
  EXPECT_NEAR(found.time, start + expected.time, 1e-6);
  EXPECT_EQ(found.image.bytes(), expected.image.bytes());
  EXPECT_EQ(found.camera.focal, expected.camera.focal);
  EXPECT_EQ(found.camera.center, expected.camera.center);
  EXPECT_EQ(found.camera.k1, expected.camera.k1);
  EXPECT_TRUE(found.robot_from_camera.isApprox(expected.robot_from_camera, 1e-9)) << found.name;
  EXPECT_NEAR(found.torso.roll, expected.torso.roll, 1e-9);
  EXPECT_NEAR(found.torso.pitch, expected.torso.pitch, 1e-9);
  ASSERT_EQ(found.pose.has_value(), expected.pose.has_value());
  ASSERT_EQ(found.odometry.has_value(), expected.odometry.has_value());
  if (found.pose) {
    EXPECT_TRUE(found.pose->position.isApprox(expected.pose->position, 1e-9));
    EXPECT_NEAR(angle_difference(found.pose->rotation, expected.pose->rotation), 0.0, 1e-9);
  }
  if (found.odometry) {
    EXPECT_LT((found.odometry->position - expected.odometry->position).norm(), 1e-9);
    EXPECT_NEAR(angle_difference(found.odometry->rotation, expected.odometry->rotation), 0.0, 1e-9);
  }
}

struct Read {
  std::vector<FootageFrame> frames;
  std::string error;
  LogCounts counts;
};

Read read(const Bytes& file, const McapLogOptions& options = {}) {
  Read read;
  try {
    McapLog log(std::make_unique<mcap::MemorySource>(file), "a log", options);
    for (FootageFrame frame; log.next(frame);) read.frames.push_back(frame);
    read.counts = log.counts();
  } catch (const BadFootage& bad) {
    read.error = bad.what();
  }
  return read;
}

TEST(McapLog, OfRosGivesTheFramesThatWereRecorded) {
  for (const ByteOrder order : {ByteOrder::little, ByteOrder::big}) {
    for (const bool with_imu : {false, true}) {
      RosLogOptions options;
      options.order = order;
      options.with_imu = with_imu;
      const std::vector<FootageFrame> frames = walk();
      const Read found = read(ros_log(frames, options));
      EXPECT_EQ(found.error, "");
      ASSERT_EQ(found.frames.size(), frames.size());
      for (std::size_t i = 0; i < frames.size(); ++i) expect_same(found.frames[i], frames[i], options.start);
    }
  }
}

TEST(McapLog, WithoutPoseOrOdometryLeavesThemEmpty) {
  std::vector<FootageFrame> frames = walk();
  for (FootageFrame& frame : frames) frame.pose.reset();
  Read found = read(ros_log(frames));
  ASSERT_EQ(found.frames.size(), frames.size()) << found.error;
  for (std::size_t i = 0; i < frames.size(); ++i) expect_same(found.frames[i], frames[i], 1700000000.0);
  frames = walk();
  for (FootageFrame& frame : frames) frame.odometry.reset();
  found = read(ros_log(frames));
  ASSERT_EQ(found.frames.size(), frames.size()) << found.error;
  for (std::size_t i = 0; i < frames.size(); ++i) expect_same(found.frames[i], frames[i], 1700000000.0);
}

TEST(McapLog, OfCompressedImagesUsesTheGivenDecoder) {
  const std::vector<FootageFrame> frames = walk(3);
  RosLogOptions written;
  written.encode = [](const Image& image) {
    const auto bytes = std::as_bytes(std::span(image.bytes()));
    return Bytes(bytes.begin(), bytes.end());
  };
  McapLogOptions options;
  options.frames.decode_image = [](std::span<const std::byte> file, const std::string& where) {
    EXPECT_TRUE(where.starts_with("/camera/image_raw/compressed, message ")) << where;
    Image image(8, 6);
    std::memcpy(image.row(0), file.data(), file.size());
    return image;
  };
  const Read found = read(ros_log(frames, written), options);
  ASSERT_EQ(found.frames.size(), frames.size()) << found.error;
  for (std::size_t i = 0; i < frames.size(); ++i) expect_same(found.frames[i], frames[i], written.start);
}

TEST(McapLog, IsReadFromADisk) {
  const TemporaryFolder folder;
  const Bytes bytes = ros_log(walk(3));
  const auto file = folder.write("walk.mcap", {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  McapLog log(file, {});
  FootageFrame frame;
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(log.next(frame));
  EXPECT_FALSE(log.next(frame));
  EXPECT_EQ(log.choices().at(0), "image: /camera/image_raw (sensor_msgs/msg/Image, cdr)");
  EXPECT_THROW(McapLog(file.parent_path() / "missing.mcap", {}), BadFootage);
  EXPECT_THROW(McapLog(folder.write("text.mcap", "no log"), {}), BadFootage);
}

TEST(McapLog, ThatIsCutGivesTheFramesBeforeTheCutThenAlwaysTheSameError) {
  std::vector<FootageFrame> frames = walk(30);
  for (FootageFrame& frame : frames) {  // several chunks
    frame.image = Image(320, 200);
    frame.camera.width = 320;
    frame.camera.focal = {300.0, 310.0};
    frame.camera.center = {159.5, 99.5};
    frame.camera.height = 200;
    auto noise = static_cast<std::uint32_t>(1e6 * frame.time);
    for (int y = 0; y < 200; ++y) {
      for (int x = 0; x < 640; ++x) {
        noise = 1664525u * noise + 1013904223u;
        frame.image.row(y)[x] = static_cast<std::uint8_t>(noise >> 24);
      }
    }
  }
  const Bytes whole = ros_log(frames);
  ASSERT_GT(whole.size(), 1000000u);
  std::size_t most = 0;
  for (const std::size_t left : {whole.size() / 3, whole.size() / 2, whole.size() - 1000000, whole.size() - 1}) {
    const Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(left));
    McapLog log(std::make_unique<mcap::MemorySource>(cut), "a log", {});
    std::string error;
    std::size_t count = 0;
    try {
      for (FootageFrame frame; log.next(frame); ++count) expect_same(frame, frames[count], 1700000000.0);
    } catch (const BadFootage& bad) {
      error = bad.what();
    }
    EXPECT_TRUE(error.starts_with("a log: at byte ")) << error;
    EXPECT_GE(count, most);
    most = count;
    FootageFrame frame;
    try {
      log.next(frame);
      ADD_FAILURE() << "the log is damaged";
    } catch (const BadFootage& again) {
      EXPECT_EQ(again.what(), error);
    }
  }
  EXPECT_EQ(most, frames.size());
}

TEST(McapLog, WithADamagedMessageGivesTheFramesBeforeIt) {
  mcap::RawMcap file;
  file.magic();
  file.header();
  file.schema(1, "sensor_msgs/msg/Image");
  file.channel(1, 1, "/image");
  const auto image = [](double seconds) {
    return ros_image({{static_cast<messages::Time>(1e9 * seconds), "camera"}, 4, 2, "mono8", 4, Bytes(8)});
  };
  file.message(1, 1000000000, image(1.0));
  file.message(1, 2000000000, image(2.0));
  Bytes damaged = image(3.0);
  damaged.erase(damaged.end() - 3, damaged.end());
  file.message(1, 3000000000, damaged);
  file.message(1, 4000000000, image(4.0));
  file.end();
  McapLogOptions options;
  options.frames.camera.emplace().width = 4;
  options.frames.camera->height = 2;
  const Read found = read(file.bytes(), options);
  EXPECT_EQ(found.frames.size(), 2u);
  EXPECT_EQ(found.error, "a log: /image, message 3: byte 48: data: expected at most 5 elements, found 8");
  ASSERT_FALSE(found.frames.empty());
  EXPECT_NEAR(found.frames[0].robot_from_camera.translation().z(), 0.5, 1e-9)
      << "the default of logs without transforms";
}

TEST(McapLog, ByTheWriterOfTheMcapProjectIsRead) {
  for (const char* const name : {"chunks_zstd", "chunks_without_repeated_topics", "without_chunks"}) {
    McapLog log(std::filesystem::path(kSourceFolder) / "tests/robots/footage/golden" / (std::string(name) + ".mcap"),
                {});
    FootageFrame frame;
    for (int i = 0; i < 3; ++i) {
      ASSERT_TRUE(log.next(frame)) << name;
      EXPECT_EQ(frame.time, 1700000000.0 + i);
      EXPECT_EQ(frame.image.width(), 4);
      EXPECT_EQ(frame.camera.focal, Eigen::Vector2d(100.0, 104.0));
      ASSERT_TRUE(frame.pose);
      EXPECT_EQ(frame.pose->position, Eigen::Vector2d(i, 2.0));
      EXPECT_NEAR(frame.pose->rotation, 2.0 * std::atan2(0.6, 0.8), 1e-12);
      EXPECT_FALSE(frame.odometry);
      EXPECT_NEAR(frame.robot_from_camera.translation().z(), 0.5, 1e-12);
      EXPECT_TRUE(frame.robot_from_camera.linear().isApprox(Eigen::Matrix3d::Identity(), 1e-12));
    }
    EXPECT_FALSE(log.next(frame)) << name;
  }
}

TEST(McapLog, OfFoxgloveInJsonIsRead) {
  using Json = nlohmann::json;
  mcap::RawMcap file;
  file.magic();
  file.header();
  file.schema(1, "foxglove.RawImage");
  file.schema(2, "foxglove.CameraCalibration");
  file.schema(3, "foxglove.FrameTransform");
  file.schema(4, "foxglove.PoseInFrame");
  for (std::uint16_t id = 1; id <= 4; ++id)
    file.channel(id, id, std::vector{"/cam/image", "/cam/calibration", "/tf", "/pose"}.at(id - 1u), "json");
  const auto add = [&](std::uint16_t channel, std::uint64_t time, Json json) {
    json["timestamp"] = {{"sec", time / 1000000000}, {"nsec", time % 1000000000}};
    const std::string text = json.dump();
    file.message(channel, time, std::as_bytes(std::span(text)));
  };
  const Json unrotated{{"x", 0.0}, {"y", 0.0}, {"z", 0.0}, {"w", 1.0}};
  add(3, 100,
      {{"parent_frame_id", "base_link"},
       {"child_frame_id", "optical"},
       {"translation", {{"x", 0.0}, {"y", 0.0}, {"z", 0.6}}},
       {"rotation", {{"x", -0.5}, {"y", 0.5}, {"z", -0.5}, {"w", 0.5}}}});
  add(2, 100,
      {{"frame_id", "optical"},
       {"width", 4},
       {"height", 2},
       {"distortion_model", ""},
       {"D", Json::array()},
       {"K", {4.0, 0.0, 1.5, 0.0, 4.0, 0.5, 0.0, 0.0, 1.0}}});
  for (std::uint64_t i = 1; i <= 3; ++i) {
    add(4, i * 1000000000,
        {{"frame_id", "map"},
         {"pose",
          {{"position", {{"x", 1.0 * static_cast<double>(i)}, {"y", 2.0}, {"z", 0.0}}}, {"orientation", unrotated}}}});
    add(1, i * 1000000000,
        {{"frame_id", "optical"},
         {"width", 4},
         {"height", 2},
         {"encoding", "mono8"},
         {"step", 4},
         {"data", "AQIDBAUGBwg="}});
  }
  file.end();
  const Read found = read(file.bytes());
  EXPECT_EQ(found.error, "");
  ASSERT_EQ(found.frames.size(), 3u);
  EXPECT_EQ(found.frames[1].image.view().luma(1, 1), 6);
  ASSERT_TRUE(found.frames[1].pose);
  EXPECT_NEAR(found.frames[1].pose->position.x(), 2.0, 1e-9);
  EXPECT_TRUE(found.frames[1].robot_from_camera.linear().isApprox(Eigen::Matrix3d::Identity(), 1e-9));
  EXPECT_NEAR(found.frames[1].robot_from_camera.translation().z(), 0.6, 1e-9);
}

TEST(McapLog, WithoutAnyUsableImageReportsTheReason) {
  McapLogOptions options;
  options.frames.base_frame = "torso";
  const Read found = read(ros_log(walk(3)), options);
  EXPECT_TRUE(found.frames.empty());
  EXPECT_EQ(found.error,
            "a log: expected transforms from camera frame 'camera_optical_frame' to base frame 'torso' at the images' "
            "times, found the frames 'base_link', 'camera_optical_frame', 'map', 'odom'");
}

TEST(McapLog, WithAFlippedByteGivesFramesOrOneLine) {
  const Bytes whole = ros_log(walk(5));
  for (std::size_t place = 0; place < whole.size(); place += 7) {
    Bytes damaged = whole;
    damaged[place] ^= std::byte{0x21};
    const Read found = read(damaged);
    EXPECT_LE(found.frames.size(), 5u);
    EXPECT_EQ(found.error.find('\n'), std::string::npos) << found.error;
  }
}

}  // namespace
}  // namespace reorient
