// SPDX-License-Identifier: MIT
// Builds frames of footage from the messages of a robot log: images, calibration, transforms, poses, odometry and
// attitude that were recorded independently of each other. Transforms and poses are interpolated at each image's time.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "robots/footage/footage.h"
#include "robots/footage/messages/message_types.h"
#include "robots/footage/messages/messages.h"
#include "robots/footage/transform_tree.h"

namespace reorient {

/// Decodes a whole image file (JPEG, PNG). `where` names it in errors. Throws BadFootage.
using ImageDecoder = std::function<Image(std::span<const std::byte> file, const std::string& where)>;

/// Axes of the frame that an image message names.
enum class CameraAxes {
  optical,  ///< x right, y down, z forward: what ROS and Foxglove define
  body,     ///< x forward, y left, z up
};

/// Axes x right, y down, z forward in axes x forward, y left, z up.
Isometry3 body_from_optical();

struct LogFrameOptions {
  std::string field_frame = "map";
  std::string odometry_frame = "odom";
  std::string base_frame = "base_link";  ///< of the robot; x forward
  std::string camera_frame;              ///< empty: the frame that each image names, else its calibration
  CameraAxes camera_axes = CameraAxes::optical;

  std::optional<CameraModel> camera;          ///< instead of the log's calibration
  std::optional<Isometry3> base_from_camera;  ///< our camera frame; instead of the log's transforms
  double base_height = 0.0;                   ///< m, of the base above the ground where the log has planar poses
  bool prefer_pose_topic = false;             ///< to the transform from the base frame to the field frame

  MotionLimits limits;
  double wait = 0.5;  ///< s that an image waits for messages that were recorded after it; bounds their disorder, too
  ImageDecoder decode_image;  ///< of compressed images
};

/// What became of a log's messages.
struct LogCounts {
  std::uint64_t images = 0;
  std::uint64_t frames = 0;
  std::uint64_t without_camera_pose = 0;  ///< images without a transform from the camera to the base
  std::uint64_t without_calibration = 0;  ///< images before the first camera info
  std::uint64_t out_of_order = 0;         ///< images that are not later than the frame before
  std::uint64_t invalid_motions = 0;      ///< transforms and poses that are no rigid motion
};

/// A decoded message and where it comes from.
struct LogMessage {
  std::string where;            ///< "/camera/image, message 12", for errors and names
  messages::Time log_time = 0;  ///< when it was recorded
  messages::Content content{};  ///< what it is used for
  TransformTree::Validity validity = TransformTree::Validity::limited;  ///< of transforms
  bool rectified = false;                                               ///< of an image: it is undistorted
  messages::Message message;
};

/// The robot frame has its origin on the ground below the base frame, and z up. Position and yaw of the base become the
/// frame's pose; height, roll and pitch become part of robot_from_camera. These come from the pose in the field, else
/// from the odometry. A pose without any roll and pitch counts as planar: then the attitude comes from the Imu, and
/// where the height is 0 as well, it is `base_height`.
///
/// The torso's attitude is that of the Imu, else roll and pitch of the pose.
///
/// An image is left out, and counted, where the log has no calibration yet or no transform from its camera to the base,
/// and where it comes too late. Images without a time have that of their recording, if no image has a time.
class LogFrames {
 public:
  explicit LogFrames(LogFrameOptions options) : options_(std::move(options)) {}

  /// Messages in the order of their log times.
  void add(LogMessage message);
  /// There are no further messages: no image waits any longer.
  void finish() { finished_ = true; }

  /// The next frame. False: it depends on further messages, or there are none. Throws BadFootage.
  bool next(FootageFrame& frame);

  const LogCounts& counts() const { return counts_; }
  /// Why there is no frame, for an error message; empty: there were frames.
  std::string reason_of_no_frame() const;

 private:
  struct WaitingImage {
    messages::Time time;
    LogMessage message;
    std::size_t bytes;
  };
  struct Calibration {
    messages::Time log_time;
    messages::CameraInfo info;
  };
  struct Posed {  // a pose topic
    std::string frame, child;
    MotionTrack motion;
  };

  void add_image(LogMessage&& message);
  bool is_late(const WaitingImage& image);
  void add_pose(const messages::Pose& pose, Posed& posed);
  bool make_frame(WaitingImage& waiting, FootageFrame& frame);
  bool set_camera(const WaitingImage& waiting, int width, int height, FootageFrame& frame) const;
  std::string camera_frame_of(const WaitingImage& waiting) const;
  std::optional<Isometry3> base_from_camera(const WaitingImage& waiting) const;
  std::optional<Isometry3> posed_at(const Posed& posed, messages::Time time) const;
  std::optional<Isometry3> field_from_base(messages::Time time) const;
  std::optional<Isometry3> odometry_from_base(messages::Time time) const;
  std::optional<TorsoAttitude> attitude_at(messages::Time time) const;

  LogFrameOptions options_;
  LogCounts counts_;
  bool finished_ = false;
  messages::Time newest_log_time_ = 0;
  bool images_have_times_ = false;
  std::optional<messages::Time> last_frame_;

  std::deque<WaitingImage> waiting_;  // by time
  std::size_t waiting_bytes_ = 0;
  std::vector<Calibration> calibrations_;
  TransformTree transforms_;
  Posed pose_, odometry_, attitude_;
  std::string missing_camera_frame_;
};

}  // namespace reorient
