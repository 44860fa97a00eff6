// SPDX-License-Identifier: MIT
// Decodes messages that other libraries have written (write_golden_messages.mjs).
#include <string>

#include <gtest/gtest.h>

#include "robots/footage/footage.h"
#include "robots/footage/messages/foxglove_json.h"
#include "robots/footage/messages/foxglove_protobuf.h"
#include "robots/footage/messages/message_types.h"
#include "robots/footage/messages/ros.h"
#include "tests/robots/footage/golden_files.h"
#include "tests/robots/footage/ros_messages.h"

namespace reorient {
namespace {

using messages::Bytes;

Bytes golden(const std::string& name) { return golden_message(name); }

void expect_header(const messages::Header& header, const std::string& frame) {
  EXPECT_EQ(header.time, 1700000000123456789);
  EXPECT_EQ(header.frame, frame);
}

void expect_motion(const messages::Motion& motion) {
  EXPECT_EQ(motion.translation, Eigen::Vector3d(1.5, -2.25, 0.125));
  EXPECT_EQ(motion.rotation.x, 0.5);
  EXPECT_EQ(motion.rotation.y, -0.5);
  EXPECT_EQ(motion.rotation.z, 0.5);
  EXPECT_EQ(motion.rotation.w, 0.5);
}

void expect_image(const messages::RawImage& image) {
  expect_header(image.header, "camera_optical");
  EXPECT_EQ(image.width, 4u);
  EXPECT_EQ(image.height, 2u);
  EXPECT_EQ(image.encoding, "rgb8");
  EXPECT_EQ(image.step, 14u);
  ASSERT_EQ(image.data.size(), 28u);
  for (std::size_t i = 0; i < image.data.size(); ++i) EXPECT_EQ(std::to_integer<std::size_t>(image.data[i]), 10 + i);
}

void expect_compressed_image(const messages::CompressedImage& image) {
  expect_header(image.header, "camera_optical");
  EXPECT_EQ(image.format, "jpeg");
  EXPECT_EQ(image.data, (Bytes{std::byte{0xFF}, std::byte{0xD8}, std::byte{0xFF}, std::byte{0xD9}, std::byte{0}}));
}

void expect_calibration(const messages::CameraInfo& info) {
  expect_header(info.header, "camera_optical");
  EXPECT_EQ(info.width, 640u);
  EXPECT_EQ(info.height, 480u);
  EXPECT_EQ(info.distortion_model, "plumb_bob");
  EXPECT_EQ(info.d, (std::vector<double>{-0.1, 0.02, 0.0, 0.0, 0.0}));
  for (std::size_t i = 0; i < info.k.size(); ++i) EXPECT_EQ(info.k[i], 100.0 + static_cast<double>(i));
  for (std::size_t i = 0; i < info.p.size(); ++i) EXPECT_EQ(info.p[i], 200.0 + static_cast<double>(i));
}

void expect_transform(const messages::Transform& transform) {
  expect_header(transform.header, "odom");
  EXPECT_EQ(transform.child, "base_link");
  expect_motion(transform.parent_from_child);
}

TEST(GoldenMessages, RosImage) { expect_image(messages::ros::image(golden("image.cdr"))); }

TEST(GoldenMessages, RosCompressedImage) {
  expect_compressed_image(messages::ros::compressed_image(golden("compressed_image.cdr")));
}

TEST(GoldenMessages, RosCameraInfo) {
  const messages::CameraInfo info = messages::ros::camera_info(golden("camera_info.cdr"));
  expect_calibration(info);
  EXPECT_EQ(info.region.x_offset, 8u);
  EXPECT_EQ(info.region.y_offset, 16u);
  EXPECT_EQ(info.region.width, 320u);
  EXPECT_EQ(info.region.height, 240u);
}

TEST(GoldenMessages, RosTransforms) {
  const messages::Transforms all = messages::ros::transforms(golden("transforms.cdr"));
  ASSERT_EQ(all.transforms.size(), 2u);
  expect_transform(all.transforms[0]);
  expect_header(all.transforms[1].header, "base_link");
  EXPECT_EQ(all.transforms[1].child, "camera");
  EXPECT_EQ(all.transforms[1].parent_from_child.rotation.w, 1.0);
}

TEST(GoldenMessages, RosPoses) {
  for (const messages::Pose& pose :
       {messages::ros::pose_stamped(golden("pose_stamped.cdr")),
        messages::ros::pose_with_covariance_stamped(golden("pose_with_covariance_stamped.cdr"))}) {
    expect_header(pose.header, "map");
    EXPECT_EQ(pose.child, "");
    expect_motion(pose.pose);
  }
}

TEST(GoldenMessages, RosOdometry) {
  const messages::Pose pose = messages::ros::odometry(golden("odometry.cdr"));
  expect_header(pose.header, "odom");
  EXPECT_EQ(pose.child, "base_footprint");
  expect_motion(pose.pose);
}

TEST(GoldenMessages, RosImu) {
  const messages::Imu imu = messages::ros::imu(golden("imu.cdr"));
  expect_header(imu.header, "imu");
  ASSERT_TRUE(imu.orientation);
  EXPECT_EQ(imu.orientation->y, -0.5);
  EXPECT_FALSE(messages::ros::imu(golden("imu_without_orientation.cdr")).orientation);
}

TEST(GoldenMessages, FoxgloveImages) {
  expect_image(messages::foxglove_protobuf::raw_image(golden("raw_image.pb")));
  expect_image(messages::foxglove_json::raw_image(golden("raw_image.json")));
  expect_compressed_image(messages::foxglove_protobuf::compressed_image(golden("compressed_image.pb")));
  expect_compressed_image(messages::foxglove_json::compressed_image(golden("compressed_image.json")));
}

TEST(GoldenMessages, FoxgloveCameraCalibration) {
  expect_calibration(messages::foxglove_protobuf::camera_calibration(golden("camera_calibration.pb")));
  expect_calibration(messages::foxglove_json::camera_calibration(golden("camera_calibration.json")));
}

TEST(GoldenMessages, FoxgloveTransforms) {
  for (const messages::Transforms& all : {messages::foxglove_protobuf::frame_transform(golden("frame_transform.pb")),
                                          messages::foxglove_json::frame_transform(golden("frame_transform.json"))}) {
    ASSERT_EQ(all.transforms.size(), 1u);
    expect_transform(all.transforms[0]);
  }
  for (const messages::Transforms& all : {messages::foxglove_protobuf::frame_transforms(golden("frame_transforms.pb")),
                                          messages::foxglove_json::frame_transforms(golden("frame_transforms.json"))}) {
    ASSERT_EQ(all.transforms.size(), 2u);
    expect_transform(all.transforms[0]);
    EXPECT_EQ(all.transforms[1].child, "camera");
  }
}

TEST(GoldenMessages, FoxglovePose) {
  for (const messages::Pose& pose : {messages::foxglove_protobuf::pose_in_frame(golden("pose_in_frame.pb")),
                                     messages::foxglove_json::pose_in_frame(golden("pose_in_frame.json"))}) {
    expect_header(pose.header, "map");
    expect_motion(pose.pose);
  }
}

TEST(GoldenMessages, AreTheSameAsThoseThatTheTestsWrite) {
  EXPECT_EQ(ros_image(messages::ros::image(golden("image.cdr"))), golden("image.cdr"));
  EXPECT_EQ(ros_compressed_image(messages::ros::compressed_image(golden("compressed_image.cdr"))),
            golden("compressed_image.cdr"));
  EXPECT_EQ(ros_transforms(messages::ros::transforms(golden("transforms.cdr"))), golden("transforms.cdr"));
  EXPECT_EQ(ros_pose_stamped(messages::ros::pose_stamped(golden("pose_stamped.cdr"))), golden("pose_stamped.cdr"));
  // These types have values that are not read, so only the sizes are compared.
  EXPECT_EQ(ros_camera_info(messages::ros::camera_info(golden("camera_info.cdr"))).size(),
            golden("camera_info.cdr").size());
  EXPECT_EQ(ros_odometry(messages::ros::odometry(golden("odometry.cdr"))).size(), golden("odometry.cdr").size());
  EXPECT_EQ(ros_imu(messages::ros::imu(golden("imu.cdr"))).size(), golden("imu.cdr").size());
}

TEST(GoldenMessages, AreTheSameInTheOtherByteOrder) {
  expect_image(messages::ros::image(ros_image(messages::ros::image(golden("image.cdr")), ByteOrder::big)));
  expect_compressed_image(messages::ros::compressed_image(
      ros_compressed_image(messages::ros::compressed_image(golden("compressed_image.cdr")), ByteOrder::big)));
  expect_calibration(messages::ros::camera_info(
      ros_camera_info(messages::ros::camera_info(golden("camera_info.cdr")), ByteOrder::big)));
  expect_transform(
      messages::ros::transforms(ros_transforms(messages::ros::transforms(golden("transforms.cdr")), ByteOrder::big))
          .transforms.at(0));
  expect_motion(
      messages::ros::odometry(ros_odometry(messages::ros::odometry(golden("odometry.cdr")), ByteOrder::big)).pose);
  EXPECT_TRUE(messages::ros::imu(ros_imu(messages::ros::imu(golden("imu.cdr")), ByteOrder::big)).orientation);
}

TEST(MessageTypes, AreFoundBySchemaAndEncoding) {
  const messages::MessageType* const image = messages::find_message_type("sensor_msgs/msg/Image", "cdr");
  ASSERT_NE(image, nullptr);
  EXPECT_TRUE(std::holds_alternative<messages::RawImage>(image->decode(golden("image.cdr"))));
  EXPECT_EQ(messages::find_message_type("sensor_msgs/Image", "cdr"), image);
  EXPECT_EQ(messages::find_message_type("sensor_msgs/Image", "ros1"), nullptr);
  EXPECT_EQ(messages::find_message_type("sensor_msgs/ms/Image", "cdr"), nullptr);
  EXPECT_EQ(messages::encodings_of("foxglove.RawImage"), "json or protobuf");
  EXPECT_EQ(messages::encodings_of("foxglove.Log"), "");
}

}  // namespace
}  // namespace reorient
