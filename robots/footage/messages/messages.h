// SPDX-License-Identifier: MIT
// The messages of robot logs from which footage is built, as plain structs. ROS 2 and Foxglove have different names and
// formats for them; the decoders beside this file convert both to these structs.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <Eigen/Core>

namespace reorient::messages {

/// ns since any epoch.
using Time = std::int64_t;
inline constexpr Time kSecond = 1000000000;

using Bytes = std::vector<std::byte>;

struct Header {
  Time time = 0;      ///< time of the measurement; 0: unknown
  std::string frame;  ///< the coordinate frame of the data
};

/// sensor_msgs/Image, foxglove.RawImage.
struct RawImage {
  Header header;
  std::uint32_t width = 0, height = 0;  ///< pixels
  std::string encoding;                 ///< "rgb8" ...
  std::uint32_t step = 0;               ///< bytes from one row to the next
  Bytes data;
};

/// sensor_msgs/CompressedImage, foxglove.CompressedImage.
struct CompressedImage {
  Header header;
  std::string format;  ///< "jpeg", "png", or in ROS "rgb8; jpeg compressed bgr8"
  Bytes data;          ///< a whole image file
};

/// sensor_msgs/CameraInfo, foxglove.CameraCalibration.
struct CameraInfo {
  Header header;
  std::uint32_t width = 0, height = 0;  ///< pixels, image size for which K and P are valid
  std::string distortion_model;         ///< "plumb_bob" ...
  std::vector<double> d;                ///< distortion coefficients
  std::array<double, 9> k{};            ///< intrinsics of the raw image, by rows; k[0] = 0: not calibrated
  std::array<double, 12> p{};           ///< projection of the rectified image, by rows
  struct {
    std::uint32_t x_offset = 0, y_offset = 0, width = 0, height = 0;  ///< pixels; a width of 0: the whole image
  } region;                                                           ///< part of the sensor in the image
};

struct Quaternion {
  double x = 0.0, y = 0.0, z = 0.0, w = 1.0;
};

/// A motion as it was published. It may be invalid (not finite, or a quaternion of length 0).
struct Motion {
  Eigen::Vector3d translation = Eigen::Vector3d::Zero();  ///< m
  Quaternion rotation;
};

/// geometry_msgs/TransformStamped, foxglove.FrameTransform: header.frame is the parent.
struct Transform {
  Header header;
  std::string child;
  Motion parent_from_child;
};

/// Messages with more transforms are refused, because a transform may take only 2 bytes of a message.
inline constexpr std::size_t kMostTransforms = 100000;

/// tf2_msgs/TFMessage, foxglove.FrameTransform and FrameTransforms.
struct Transforms {
  std::vector<Transform> transforms;
};

/// geometry_msgs/PoseStamped and PoseWithCovarianceStamped, foxglove.PoseInFrame, nav_msgs/Odometry.
struct Pose {
  Header header;
  std::string child;  ///< the frame that has this pose; empty: not part of the message
  Motion pose;
};

/// sensor_msgs/Imu.
struct Imu {
  Header header;
  /// World from sensor; its yaw may have any offset. Empty: the sensor does not estimate it.
  std::optional<Quaternion> orientation;
};

using Message = std::variant<RawImage, CompressedImage, CameraInfo, Transforms, Pose, Imu>;

}  // namespace reorient::messages
