// SPDX-License-Identifier: MIT
// Writes frames of footage as a log of ROS 2 in MCAP, as rosbag2 would record it: for tests that feed what they know,
// for example frames of the simulator, through the reader of logs.
//
//   topic                          type                                content
//   /camera/image_raw              sensor_msgs/msg/Image               where `encode` is empty
//   /camera/image_raw/compressed   sensor_msgs/msg/CompressedImage     where it is not
//   /camera/camera_info            sensor_msgs/msg/CameraInfo
//   /tf                            tf2_msgs/msg/TFMessage              map -> odom -> base_link -> camera_optical_frame
//   /odom                          nav_msgs/msg/Odometry               where a frame has odometry
//   /imu                           sensor_msgs/msg/Imu                 where `with_imu` is set
//
// A frame without a pose has no map -> odom; one without odometry has map -> base_link.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "robots/footage/footage.h"
#include "tests/robots/footage/ros_messages.h"
#include "workbench/recording/mcap/writer.h"

namespace reorient {

struct RosLogOptions {
  double start = 1700000000.0;  ///< s, added to the times of frames
  double base_height = 0.3;     ///< m, of base_link above the ground; its roll and pitch are the frame's torso attitude
  ByteOrder order = ByteOrder::little;
  /// Of raw images: yuv422_yuy2, without loss, or mono8.
  std::string encoding = "yuv422_yuy2";
  /// An image as a file of `format`; empty: raw images.
  std::function<std::vector<std::byte>(const Image&)> encode;
  std::string format = "png";
  bool with_imu = false;
};

class RosLogWriter {
 public:
  /// `sink` takes the bytes of the file in their order.
  explicit RosLogWriter(mcap::Writer::Sink sink, RosLogOptions options = {});

  /// Messages of one frame. Times must increase.
  void add(const FootageFrame& frame);
  /// Writes the summary. Nothing may follow.
  void finish() { writer_.finish(); }

 private:
  void add_image(const FootageFrame& frame, const messages::Header& header, std::uint64_t log_time);
  void add_transforms(const FootageFrame& frame, messages::Time time, std::uint64_t log_time);

  RosLogOptions options_;
  mcap::Writer writer_;
  std::uint16_t image_ = 0, camera_info_ = 0, transforms_ = 0, odometry_ = 0, imu_ = 0;  // channels
};

/// A whole log of `frames`.
std::vector<std::byte> ros_log(const std::vector<FootageFrame>& frames, const RosLogOptions& options = {});

}  // namespace reorient
