// SPDX-License-Identifier: MIT
#include "workbench/footage/log_topics.h"

#include <string>

#include <gtest/gtest.h>

#include "robots/footage/footage.h"

namespace reorient {
namespace {

using messages::Content;

/// Channels with the numbers 1, 2 ... of the given topics and types; "cdr" unless the type is Foxglove's.
mcap::Contents contents_of(const std::vector<std::pair<std::string, std::string>>& topics) {
  mcap::Contents contents;
  for (const auto& [topic, type] : topics) {
    const auto id = static_cast<std::uint16_t>(contents.channels.size() + 1);
    contents.schemas.push_back({id, type, "", ""});
    contents.channels.push_back({id, id, topic, type.starts_with("foxglove.") ? "protobuf" : "cdr", {}});
  }
  return contents;
}

const std::string kImage = "sensor_msgs/msg/Image", kInfo = "sensor_msgs/msg/CameraInfo",
                  kTf = "tf2_msgs/msg/TFMessage", kPose = "geometry_msgs/msg/PoseStamped",
                  kOdometry = "nav_msgs/msg/Odometry";

std::string error_of(const mcap::Contents& contents, const LogTopics& wanted = {}) {
  try {
    choose_topics(contents, wanted, true);
  } catch (const BadFootage& bad) {
    return bad.what();
  }
  return {};
}

TEST(LogTopics, ThatAreTheOnlyOnesAreChosen) {
  const ChosenTopics chosen = choose_topics(contents_of({{"/camera/image_raw", kImage},
                                                         {"/camera/camera_info", kInfo},
                                                         {"/tf", kTf},
                                                         {"/tf_static", kTf},
                                                         {"/amcl_pose", kPose},
                                                         {"/goal_pose", kPose},
                                                         {"/odom", kOdometry},
                                                         {"/scan", "sensor_msgs/msg/Scan"}}),
                                            {}, true);
  ASSERT_EQ(chosen.channels.size(), 6u);
  EXPECT_EQ(chosen.channels.at(1).uses, std::vector{Content::image});
  EXPECT_EQ(chosen.channels.at(3).validity, TransformTree::Validity::limited);
  EXPECT_EQ(chosen.channels.at(4).validity, TransformTree::Validity::fixed);
  EXPECT_EQ(chosen.channels.at(5).topic, "/amcl_pose");
  EXPECT_EQ(chosen.channels.at(7).uses, std::vector{Content::odometry});
  EXPECT_EQ(chosen.lines.at(0), "image: /camera/image_raw (sensor_msgs/msg/Image, cdr)");
}

TEST(LogTopics, OfSeveralCamerasNeedAName) {
  const mcap::Contents contents = contents_of({{"/left/image_raw", kImage},
                                               {"/left/camera_info", kInfo},
                                               {"/right/image_raw/compressed", "sensor_msgs/msg/CompressedImage"},
                                               {"/right/camera_info", kInfo}});
  EXPECT_EQ(
      error_of(contents),
      "expected the name of one image topic, because there are 2: '/left/image_raw', '/right/image_raw/compressed'");
  LogTopics wanted;
  wanted.image = "/right/image_raw/compressed";
  const ChosenTopics chosen = choose_topics(contents, wanted, true);
  ASSERT_EQ(chosen.channels.size(), 2u);
  EXPECT_EQ(chosen.channels.at(4).topic, "/right/camera_info") << "of the same namespace";
  wanted.image = "/front/image_raw";
  EXPECT_EQ(error_of(contents, wanted),
            "image topic: expected one of '/left/image_raw', '/right/image_raw/compressed', found '/front/image_raw'");
  wanted.image = "/left/camera_info";
  EXPECT_NE(error_of(contents, wanted), "");
}

TEST(LogTopics, ThatAreMissingAreNamedWithWhatCannotBeRead) {
  mcap::Contents contents = contents_of({{"/camera/image_raw", "sensor_msgs/Image"}});
  contents.channels[0].encoding = "ros1";
  EXPECT_EQ(error_of(contents),
            "expected a topic with image messages, found none; not readable: '/camera/image_raw (sensor_msgs/Image in "
            "ros1, expected cdr)'");
  EXPECT_EQ(error_of(contents_of({{"/camera/image_raw", kImage}})),
            "expected a topic with camera info messages, found none; --fov-degrees describes a camera "
            "without distortion");
  EXPECT_EQ(choose_topics(contents_of({{"/camera/image_raw", kImage}}), {}, false).channels.size(), 1u);
}

TEST(LogTopics, OfPosesBesideTransformsNeedAName) {
  std::vector<std::pair<std::string, std::string>> topics{
      {"/image", kImage}, {"/camera_info", kInfo}, {"/a", kPose}, {"/b", kPose}};
  EXPECT_EQ(error_of(contents_of(topics)), "expected the name of one pose topic, because there are 2: '/a', '/b'");
  topics.emplace_back("/tf", kTf);
  const ChosenTopics chosen = choose_topics(contents_of(topics), {}, true);
  EXPECT_FALSE(chosen.has(Content::pose));
  EXPECT_EQ(chosen.lines.back(), "pose: none of '/a', '/b'");
  LogTopics wanted;
  wanted.pose = "/b";
  EXPECT_TRUE(choose_topics(contents_of(topics), wanted, true).has(Content::pose));
}

TEST(LogTopics, OfOneMessageTypeServeAsPoseAndOdometry) {
  LogTopics wanted;
  wanted.pose = "/truth";
  wanted.odometry = "/odom";
  const ChosenTopics chosen = choose_topics(
      contents_of({{"/image", kImage}, {"/camera_info", kInfo}, {"/odom", kOdometry}, {"/truth", kOdometry}}), wanted,
      true);
  EXPECT_EQ(chosen.channels.at(4).uses, std::vector{Content::pose});
  wanted.odometry.reset();
  EXPECT_EQ(
      choose_topics(contents_of({{"/image", kImage}, {"/camera_info", kInfo}, {"/truth", kOdometry}}), wanted, true)
          .channels.at(3)
          .uses,
      std::vector{Content::pose});
}

TEST(LogTopics, WithoutMessagesAreMissing) {
  mcap::Contents contents =
      contents_of({{"/camera/image_raw", kImage}, {"/camera/camera_info", kInfo}, {"/camera/image_rect", kImage}});
  contents.statistics.emplace().messages_of = {{2, 5}, {3, 5}};
  const ChosenTopics chosen = choose_topics(contents, {}, true);
  EXPECT_TRUE(chosen.channels.at(3).rectified);
  EXPECT_FALSE(chosen.channels.contains(1));
}

TEST(LogTopics, OfFoxgloveLastUntilTheNextMessage) {
  const ChosenTopics chosen = choose_topics(contents_of({{"/cam/image", "foxglove.RawImage"},
                                                         {"/cam/calibration", "foxglove.CameraCalibration"},
                                                         {"/transforms", "foxglove.FrameTransforms"}}),
                                            {}, true);
  ASSERT_EQ(chosen.channels.size(), 3u);
  EXPECT_EQ(chosen.channels.at(3).validity, TransformTree::Validity::lasting);
}

}  // namespace
}  // namespace reorient
