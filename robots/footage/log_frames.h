// SPDX-License-Identifier: MIT
// Builds frames of footage from the messages of a robot log: images, calibration, transforms, poses, odometry and
// attitude, recorded independently of each other. Transforms and poses are interpolated at the time of each image.
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

/// The rotation from optical axes (x right, y down, z forward) to body axes (x forward, y left, z up).
Isometry3 body_from_optical();

struct LogFrameOptions {
  std::string field_frame = "map";
  std::string odometry_frame = "odom";
  std::string base_frame = "base_link";  ///< of the robot; x forward
  std::string camera_frame;              ///< empty: the frame that each image names, or else its calibration
  CameraAxes camera_axes = CameraAxes::optical;

  std::optional<CameraModel> camera;          ///< instead of the log's calibration
  std::optional<Isometry3> base_from_camera;  ///< of the camera with body axes; instead of the log's transforms
  double base_height = 0.0;                   ///< m, of the base above the ground, if the log has planar poses
  bool prefer_pose_topic = false;             ///< over the transform from the base frame to the field frame

  MotionLimits limits;
  double wait = 0.5;  ///< s that an image waits for messages recorded after it; also the largest delay of a message
  ImageDecoder decode_image;  ///< of compressed images
};

/// Statistics of a log's messages.
struct LogCounts {
  std::uint64_t images = 0;
  std::uint64_t frames = 0;
  std::uint64_t without_camera_pose = 0;  ///< images without a transform from the camera to the base
  std::uint64_t without_calibration = 0;  ///< images before the first camera info
  std::uint64_t out_of_order = 0;         ///< images that are not later than the previous frame
  std::uint64_t invalid_motions = 0;      ///< transforms and poses that are not rigid motions
};

/// A decoded message and its origin.
struct LogMessage {
  std::string where;            ///< "/camera/image, message 12", for errors and names
  messages::Time log_time = 0;  ///< time of recording
  messages::Content content{};  ///< type of its data
  TransformTree::Validity validity = TransformTree::Validity::limited;  ///< of transforms
  bool rectified = false;                                               ///< of an image: whether it is undistorted
  messages::Message message;
};

/// The robot frame has its origin on the ground below the base frame, and z up. Position and yaw of the base become the
/// frame's pose; height, roll and pitch become part of robot_from_camera. They come from the pose in the field, or else
/// from the odometry. A pose with zero roll and pitch counts as planar. Then the attitude comes from the Imu, and a
/// height of 0 is replaced by `base_height`.
///
/// The torso's attitude comes from the Imu, or else from roll and pitch of the pose.
///
/// An image is skipped and counted if the log has no calibration yet, if it has no transform from its camera to the
/// base, or if the image comes too late. If no image has a time, the time of recording is used.
class LogFrames {
 public:
  explicit LogFrames(LogFrameOptions options) : options_(std::move(options)) {}

  /// Adds a message. Messages must come in the order of their log times.
  void add(LogMessage message);
  /// Ends the input, so that images no longer wait for messages.
  void finish() { finished_ = true; }

  /// Builds the next frame. False: it needs further messages, or all images are used. Throws BadFootage.
  bool next(FootageFrame& frame);

  const LogCounts& counts() const { return counts_; }
  /// Why the log gave no frame, for an error message; empty if it gave frames.
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
  struct Posed {  // motion from a pose topic
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
