// SPDX-License-Identifier: MIT
#include "robots/footage/log_frames.h"

#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "geometry/pose2.h"

namespace reorient {
namespace {

using messages::Content;
using messages::Time;
using Validity = TransformTree::Validity;

Time at(double seconds) { return static_cast<Time>(std::llround(1e9 * seconds)); }

messages::Quaternion quaternion(const Eigen::Matrix3d& rotation) {
  const Eigen::Quaterniond q(rotation);
  return {q.x(), q.y(), q.z(), q.w()};
}

LogMessage message(Content content, double seconds, messages::Message body) {
  LogMessage message;
  message.where = "/topic, message 1";
  message.log_time = at(seconds);
  message.content = content;
  message.message = std::move(body);
  return message;
}

LogMessage image(double seconds, double log_seconds = -1.0) {
  messages::RawImage raw{{at(seconds), "optical"}, 4, 2, "mono8", 4, messages::Bytes(8)};
  return message(Content::image, log_seconds < 0.0 ? seconds : log_seconds, raw);
}

LogMessage camera_info(double seconds) {
  messages::CameraInfo info;
  info.width = 4;
  info.height = 2;
  info.k = {4.0, 0.0, 1.5, 0.0, 4.0, 0.5, 0.0, 0.0, 1.0};
  return message(Content::camera_info, seconds, info);
}

LogMessage transform(const std::string& parent, const std::string& child, double seconds,
                     const Eigen::Vector3d& translation, const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity(),
                     Validity validity = Validity::limited) {
  messages::Transforms all;
  all.transforms.push_back({{at(seconds), parent}, child, {translation, quaternion(rotation)}});
  LogMessage one = message(Content::transforms, seconds, all);
  one.validity = validity;
  return one;
}

LogMessage pose(Content content, double seconds, const std::string& frame, const Eigen::Vector3d& position,
                const Eigen::Matrix3d& rotation = Eigen::Matrix3d::Identity(), const std::string& child = "") {
  return message(content, seconds, messages::Pose{{at(seconds), frame}, child, {position, quaternion(rotation)}});
}

LogMessage imu(double seconds, const Eigen::Matrix3d& rotation) {
  return message(Content::imu, seconds, messages::Imu{{at(seconds), "imu"}, quaternion(rotation)});
}

/// A camera 0.4 m above the base and 0.1 m in front of it, which points along the base's x axis.
LogMessage mount() {
  return transform("base_link", "optical", 0.0, {0.1, 0.0, 0.4}, body_from_optical().linear(), Validity::fixed);
}

std::vector<FootageFrame> frames_of(LogFrames& frames) {
  std::vector<FootageFrame> all;
  for (FootageFrame frame; frames.next(frame);) all.push_back(frame);
  return all;
}

FootageFrame only_frame(LogFrameOptions options, std::vector<LogMessage> messages) {
  LogFrames frames(std::move(options));
  for (LogMessage& each : messages) frames.add(std::move(each));
  frames.finish();
  const std::vector<FootageFrame> all = frames_of(frames);
  EXPECT_EQ(all.size(), 1u) << frames.reason_of_no_frame();
  return all.empty() ? FootageFrame{} : all[0];
}

TEST(LogFrames, ConvertOpticalAxesToBodyAxes) {
  const Eigen::Matrix3d rotation = body_from_optical().linear();
  EXPECT_EQ(rotation * Eigen::Vector3d::UnitX(), -Eigen::Vector3d::UnitY()) << "right";
  EXPECT_EQ(rotation * Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitZ()) << "down";
  EXPECT_EQ(rotation * Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitX()) << "ahead";
}

TEST(LogFrames, HaveThePoseOfTheirTransforms) {
  const FootageFrame frame = only_frame(
      {}, {mount(), camera_info(1.0), transform("map", "odom", 1.0, {1.0, 2.0, 0.0}, rotation_about_z(kPi / 2.0)),
           transform("odom", "base_link", 1.0, {3.0, 0.0, 0.3}, rotation_about_z(0.5)), image(1.0)});
  EXPECT_EQ(frame.time, 1.0);
  EXPECT_EQ(frame.name, "/topic, message 1");
  EXPECT_EQ(frame.image.width(), 4);
  EXPECT_EQ(frame.camera.focal.x(), 4.0);
  ASSERT_TRUE(frame.pose);
  EXPECT_TRUE(frame.pose->position.isApprox(Eigen::Vector2d(1.0, 5.0), 1e-9));
  EXPECT_NEAR(frame.pose->rotation, kPi / 2.0 + 0.5, 1e-9);
  ASSERT_TRUE(frame.odometry);
  EXPECT_TRUE(frame.odometry->position.isApprox(Eigen::Vector2d(3.0, 0.0), 1e-9));
  EXPECT_NEAR(frame.odometry->rotation, 0.5, 1e-9);
  EXPECT_TRUE(frame.robot_from_camera.translation().isApprox(Eigen::Vector3d(0.1, 0.0, 0.7), 1e-9));
  EXPECT_TRUE(frame.robot_from_camera.linear().isApprox(Eigen::Matrix3d::Identity(), 1e-9));
}

TEST(LogFrames, IncludeRollAndPitchOfTheBaseInTheCameraPose) {
  const Eigen::Matrix3d tilt = rotation_about_y(0.2) * rotation_about_x(-0.1);
  const FootageFrame frame =
      only_frame({}, {mount(), camera_info(1.0),
                      transform("map", "base_link", 1.0, {1.0, 2.0, 0.3}, rotation_about_z(2.0) * tilt), image(1.0)});
  ASSERT_TRUE(frame.pose);
  EXPECT_NEAR(frame.pose->rotation, 2.0, 1e-9);
  EXPECT_FALSE(frame.odometry);
  EXPECT_TRUE(frame.robot_from_camera.linear().isApprox(tilt, 1e-9));
  const Eigen::Vector3d expected = Eigen::Vector3d(0.0, 0.0, 0.3) + tilt * Eigen::Vector3d(0.1, 0.0, 0.4);
  EXPECT_TRUE(frame.robot_from_camera.translation().isApprox(expected, 1e-9));
  EXPECT_NEAR(frame.torso.roll, -0.1, 1e-9);
  EXPECT_NEAR(frame.torso.pitch, 0.2, 1e-9);
}

TEST(LogFrames, WithPlanarPosesTakeTheAttitudeFromTheImu) {
  LogFrameOptions options;
  options.base_height = 0.25;
  const Eigen::Matrix3d tilt = rotation_about_y(0.2) * rotation_about_x(-0.1);
  // The sensor is mounted upside down in the base.
  const Eigen::Matrix3d base_from_imu = rotation_about_x(kPi);
  const FootageFrame frame =
      only_frame(options, {mount(), transform("base_link", "imu", 0.0, {0.0, 0.0, 0.0}, base_from_imu, Validity::fixed),
                           camera_info(1.0), transform("map", "base_link", 1.0, {1.0, 2.0, 0.0}, rotation_about_z(2.0)),
                           imu(1.0, rotation_about_z(-0.7) * tilt * base_from_imu), image(1.0)});
  EXPECT_NEAR(frame.torso.roll, -0.1, 1e-9);
  EXPECT_NEAR(frame.torso.pitch, 0.2, 1e-9);
  EXPECT_TRUE(frame.robot_from_camera.linear().isApprox(tilt, 1e-9));
  EXPECT_NEAR((frame.robot_from_camera * Eigen::Vector3d::Zero()).z(), 0.25 + (tilt * Eigen::Vector3d(0.1, 0, 0.4)).z(),
              1e-9);
}

TEST(LogFrames, InterpolateAtTheTimeOfTheImage) {
  LogFrames frames({});
  frames.add(mount());
  frames.add(camera_info(1.0));
  frames.add(transform("map", "base_link", 1.0, {1.0, 0.0, 0.0}));
  frames.add(image(1.05));
  FootageFrame frame;
  EXPECT_FALSE(frames.next(frame)) << "the next transform is not known yet";
  frames.add(transform("map", "base_link", 1.1, {2.0, 0.0, 0.0}));
  EXPECT_FALSE(frames.next(frame)) << "there may be one that is nearer";
  frames.add(camera_info(1.6));
  ASSERT_TRUE(frames.next(frame));
  EXPECT_NEAR(frame.pose->position.x(), 1.5, 1e-9);
  EXPECT_FALSE(frames.next(frame));
}

TEST(LogFrames, UseAPoseTopicIfTransformsDoNotContainThePose) {
  const std::vector<LogMessage> log{
      mount(), camera_info(1.0), pose(Content::pose, 1.0, "map", {3.0, 4.0, 0.0}, rotation_about_z(1.0)), image(1.0)};
  const FootageFrame frame = only_frame({}, log);
  ASSERT_TRUE(frame.pose);
  EXPECT_TRUE(frame.pose->position.isApprox(Eigen::Vector2d(3.0, 4.0), 1e-9));
  EXPECT_NEAR(frame.pose->rotation, 1.0, 1e-9);

  std::vector<LogMessage> with_both = log;
  with_both.insert(with_both.begin(), transform("map", "base_link", 1.0, {7.0, 0.0, 0.0}));
  EXPECT_NEAR(only_frame({}, with_both).pose->position.x(), 7.0, 1e-9);
  LogFrameOptions options;
  options.prefer_pose_topic = true;
  EXPECT_NEAR(only_frame(options, with_both).pose->position.x(), 3.0, 1e-9);
}

TEST(LogFrames, TransformAPoseFromItsOwnFrame) {
  const FootageFrame frame = only_frame(
      {}, {mount(), transform("map", "mocap", 0.0, {10.0, 0.0, 0.0}, rotation_about_z(kPi / 2.0), Validity::fixed),
           camera_info(1.0), pose(Content::pose, 1.0, "mocap", {3.0, 4.0, 0.0}), image(1.0)});
  ASSERT_TRUE(frame.pose);
  EXPECT_TRUE(frame.pose->position.isApprox(Eigen::Vector2d(6.0, 3.0), 1e-9));
  EXPECT_NEAR(frame.pose->rotation, kPi / 2.0, 1e-9);
}

TEST(LogFrames, ReadOdometryOfAnotherPartOfTheRobot) {
  const FootageFrame frame = only_frame(
      {}, {mount(),
           transform("base_footprint", "base_link", 0.0, {0.5, 0.0, 0.3}, Eigen::Matrix3d::Identity(), Validity::fixed),
           camera_info(1.0),
           pose(Content::odometry, 1.0, "odom", {1.0, 0.0, 0.0}, rotation_about_z(kPi / 2.0), "base_footprint"),
           image(1.0)});
  EXPECT_FALSE(frame.pose);
  ASSERT_TRUE(frame.odometry);
  EXPECT_TRUE(frame.odometry->position.isApprox(Eigen::Vector2d(1.0, 0.5), 1e-9));
  EXPECT_NEAR(frame.robot_from_camera.translation().z(), 0.7, 1e-9) << "its height is that of the base";
}

TEST(LogFrames, WithoutPoseAndOdometryStandOnTheGround) {
  LogFrameOptions options;
  options.base_height = 0.2;
  const FootageFrame frame = only_frame(options, {mount(), camera_info(1.0), image(1.0)});
  EXPECT_FALSE(frame.pose);
  EXPECT_FALSE(frame.odometry);
  EXPECT_NEAR(frame.robot_from_camera.translation().z(), 0.6, 1e-9);
  EXPECT_EQ(frame.torso.pitch, 0.0);
}

TEST(LogFrames, SkipAndCountImagesWithoutCameraPoseOrCalibration) {
  LogFrames frames({});
  frames.add(image(1.0));
  frames.add(image(2.0));
  FootageFrame frame;
  EXPECT_FALSE(frames.next(frame));
  EXPECT_EQ(frames.counts().without_camera_pose, 1u);
  frames.add(mount());
  frames.add(image(3.0));
  EXPECT_FALSE(frames.next(frame));
  EXPECT_EQ(frames.counts().without_calibration, 1u);
  frames.finish();
  EXPECT_FALSE(frames.next(frame));
  EXPECT_EQ(frames.counts().images, 3u);
  EXPECT_EQ(frames.counts().frames, 0u);
  EXPECT_NE(frames.reason_of_no_frame().find("'optical' to base frame 'base_link'"), std::string::npos);
}

TEST(LogFrames, SortImagesByTime) {
  LogFrameOptions options;
  options.base_from_camera = Isometry3::Identity();
  LogFrames frames(options);
  frames.add(camera_info(0.9));
  for (const double seconds : {1.2, 1.0, 1.1, 1.1}) frames.add(image(seconds, 1.2));
  frames.add(image(2.0));
  frames.add(image(0.5, 2.1));  // far too late
  frames.finish();
  std::vector<double> times;
  for (const FootageFrame& frame : frames_of(frames)) times.push_back(frame.time);
  EXPECT_EQ(times, (std::vector<double>{0.5, 1.0, 1.1, 1.2, 2.0})) << "no frame was asked for before all were there";
  EXPECT_EQ(frames.counts().out_of_order, 1u);
}

TEST(LogFrames, SkipAnImageThatComesAfterALaterFrame) {
  LogFrameOptions options;
  options.base_from_camera = Isometry3::Identity();
  LogFrames frames(options);
  frames.add(camera_info(0.9));
  frames.add(image(1.0));
  frames.add(camera_info(2.0));
  EXPECT_EQ(frames_of(frames).size(), 1u);
  frames.add(image(0.5, 2.0));
  frames.finish();
  EXPECT_TRUE(frames_of(frames).empty());
  EXPECT_EQ(frames.counts().out_of_order, 1u);
}

TEST(LogFrames, RefuseAClockThatWasSetBack) {
  LogFrameOptions options;
  options.base_from_camera = Isometry3::Identity();
  LogFrames frames(options);
  frames.add(camera_info(99.0));
  frames.add(image(100.0));
  frames.add(camera_info(101.0));
  FootageFrame frame;
  EXPECT_TRUE(frames.next(frame));
  frames.add(image(60.0, 102.0));
  frames.finish();
  EXPECT_THROW(frames.next(frame), BadFootage);
}

TEST(LogFrames, WithoutTimesUseTheTimeOfRecording) {
  LogFrameOptions options;
  options.base_from_camera = Isometry3::Identity();
  const auto times_of = [&](const std::vector<double>& stamps) {
    LogFrames frames(options);
    frames.add(camera_info(100.0));
    for (std::size_t i = 0; i < stamps.size(); ++i) frames.add(image(stamps[i], 100.0 + static_cast<double>(i)));
    frames.finish();
    std::vector<double> times;
    for (const FootageFrame& frame : frames_of(frames)) times.push_back(frame.time);
    return times;
  };
  EXPECT_EQ(times_of({0.0, 0.0, 0.0}), (std::vector<double>{100.0, 101.0, 102.0}));
  EXPECT_EQ(times_of({0.0, 0.1, 0.2}), (std::vector<double>{0.0, 0.1, 0.2})) << "simulated time begins at 0";
}

TEST(LogFrames, DecodeCompressedImagesWithTheGivenFunction) {
  LogFrameOptions options;
  options.base_from_camera = Isometry3::Identity();
  const messages::CompressedImage compressed{{at(1.0), "optical"}, "jpeg", messages::Bytes(3)};
  std::string where;
  options.decode_image = [&](std::span<const std::byte> file, const std::string& place) {
    EXPECT_EQ(file.size(), 3u);
    where = place;
    return Image(4, 2);
  };
  const FootageFrame frame = only_frame(options, {camera_info(1.0), message(Content::image, 1.0, compressed)});
  EXPECT_EQ(frame.image.width(), 4);
  EXPECT_EQ(where, "/topic, message 1");

  options.decode_image = nullptr;
  LogFrames frames(options);
  frames.add(camera_info(1.0));
  frames.add(message(Content::image, 1.0, compressed));
  frames.finish();
  FootageFrame none;
  try {
    frames.next(none);
    ADD_FAILURE() << "there is no decoder";
  } catch (const BadFootage& bad) {
    EXPECT_STREQ(bad.what(), "/topic, message 1: expected an uncompressed image, found the format 'jpeg'");
  }
}

TEST(LogFrames, IgnoreAndCountInvalidMotions) {
  LogFrameOptions options;
  options.base_from_camera = Isometry3::Identity();
  LogFrames frames(options);
  frames.add(message(Content::pose, 1.0, messages::Pose{{at(1.0), "map"}, "", {{0, 0, 0}, {0.0, 0.0, 0.0, 0.0}}}));
  EXPECT_EQ(frames.counts().invalid_motions, 1u);
}

}  // namespace
}  // namespace reorient
