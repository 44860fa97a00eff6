// SPDX-License-Identifier: MIT
// Decodes messages of ROS 2 in CDR. Each function throws BadFootage with the byte and the field at which a message
// violates its type. Bytes after the last field are ignored, because some middlewares pad messages.
#pragma once

#include <cstddef>
#include <span>

#include "robots/footage/messages/messages.h"

namespace reorient::messages::ros {

RawImage image(std::span<const std::byte> message);                    ///< sensor_msgs/msg/Image
CompressedImage compressed_image(std::span<const std::byte> message);  ///< sensor_msgs/msg/CompressedImage
CameraInfo camera_info(std::span<const std::byte> message);            ///< sensor_msgs/msg/CameraInfo
Transforms transforms(std::span<const std::byte> message);             ///< tf2_msgs/msg/TFMessage
Pose pose_stamped(std::span<const std::byte> message);                 ///< geometry_msgs/msg/PoseStamped
/// geometry_msgs/msg/PoseWithCovarianceStamped
Pose pose_with_covariance_stamped(std::span<const std::byte> message);
Pose odometry(std::span<const std::byte> message);  ///< nav_msgs/msg/Odometry
Imu imu(std::span<const std::byte> message);        ///< sensor_msgs/msg/Imu

}  // namespace reorient::messages::ros
