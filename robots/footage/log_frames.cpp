// SPDX-License-Identifier: MIT
#include "robots/footage/log_frames.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/pinned_math.h"
#include "robots/footage/camera_info.h"
#include "robots/footage/messages/bad_message.h"
#include "robots/footage/raw_image.h"

namespace reorient {
namespace {

using messages::Content;
using messages::Time;

constexpr std::size_t kMostWaitingBytes = 256u << 20;
constexpr std::size_t kMostCalibrations = 1000;

bool same_calibration(const messages::CameraInfo& a, const messages::CameraInfo& b) {
  return a.width == b.width && a.height == b.height && a.distortion_model == b.distortion_model && a.d == b.d &&
         a.k == b.k && a.p == b.p && a.region.x_offset == b.region.x_offset && a.region.y_offset == b.region.y_offset &&
         a.region.width == b.region.width && a.region.height == b.region.height;
}

/// Converts with only one rounding error, because times since 1970 in ns have more digits than a double.
double seconds_of(Time time) {
  const Time whole = time / messages::kSecond, rest = time % messages::kSecond;
  return static_cast<double>(whole) + static_cast<double>(rest) / 1e9;
}

/// Position and yaw of a motion.
Pose2 planar_part(const Isometry3& motion) {
  return {motion.translation().x(), motion.translation().y(), direction_of({motion(0, 0), motion(1, 0)})};
}

/// Roll and pitch, from the direction of gravity in the rotated frame.
TorsoAttitude attitude_of(const Eigen::Matrix3d& rotation) {
  const Eigen::Vector3d up = rotation.row(2).transpose();
  return {pinned::atan2(up.y(), up.z()), pinned::atan2(-up.x(), pinned::hypot(up.y(), up.z()))};
}

Eigen::Matrix3d rotation_of(const TorsoAttitude& attitude) {
  return rotation_about_y(attitude.pitch) * rotation_about_x(attitude.roll);
}

std::string_view frame_of(const messages::Message& message) {
  if (const auto* const raw = std::get_if<messages::RawImage>(&message)) return raw->header.frame;
  if (const auto* const compressed = std::get_if<messages::CompressedImage>(&message)) return compressed->header.frame;
  return {};
}

}  // namespace

Isometry3 body_from_optical() {
  Isometry3 rotation = Isometry3::Identity();
  rotation.linear() << 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0;
  return rotation;
}

void LogFrames::add(LogMessage message) {
  newest_log_time_ = std::max(newest_log_time_, message.log_time);
  switch (message.content) {
    case Content::image:
      add_image(std::move(message));
      break;
    case Content::camera_info:
      if (auto* const info = std::get_if<messages::CameraInfo>(&message.message)) {
        if (!calibrations_.empty() && same_calibration(calibrations_.back().info, *info)) break;
        if (calibrations_.size() == kMostCalibrations) calibrations_.erase(calibrations_.begin());
        calibrations_.push_back({message.log_time, std::move(*info)});
      }
      break;
    case Content::transforms:
      if (const auto* const all = std::get_if<messages::Transforms>(&message.message)) {
        for (const messages::Transform& each : all->transforms)
          if (!transforms_.add(each, message.validity)) ++counts_.invalid_motions;
      }
      break;
    case Content::pose:
      if (const auto* const pose = std::get_if<messages::Pose>(&message.message)) add_pose(*pose, pose_);
      break;
    case Content::odometry:
      if (const auto* const pose = std::get_if<messages::Pose>(&message.message)) add_pose(*pose, odometry_);
      break;
    case Content::imu:
      if (const auto* const imu = std::get_if<messages::Imu>(&message.message)) {
        if (!imu->orientation) break;
        messages::Pose pose{imu->header, {}, {}};
        pose.child = std::exchange(pose.header.frame, {});
        pose.pose.rotation = *imu->orientation;
        add_pose(pose, attitude_);
      }
      break;
  }
}

void LogFrames::add_image(LogMessage&& message) {
  ++counts_.images;
  WaitingImage waiting{0, std::move(message), 0};
  if (const auto* const raw = std::get_if<messages::RawImage>(&waiting.message.message)) {
    waiting.time = raw->header.time;
    waiting.bytes = raw->data.size();
  } else if (const auto* const compressed = std::get_if<messages::CompressedImage>(&waiting.message.message)) {
    waiting.time = compressed->header.time;
    waiting.bytes = compressed->data.size();
  }
  images_have_times_ |= waiting.time != 0;
  waiting_bytes_ += waiting.bytes;
  const auto it = std::upper_bound(waiting_.begin(), waiting_.end(), waiting.time,
                                   [](Time time, const WaitingImage& other) { return time < other.time; });
  waiting_.insert(it, std::move(waiting));
}

void LogFrames::add_pose(const messages::Pose& pose, Posed& posed) {
  const std::optional<Isometry3> motion = isometry_of(pose.pose);
  if (!motion) {
    ++counts_.invalid_motions;
    return;
  }
  posed.frame = plain_frame(pose.header.frame);
  posed.child = plain_frame(pose.child);
  posed.motion.add(pose.header.time, *motion);
}

bool LogFrames::next(FootageFrame& frame) {
  const auto wait = static_cast<Time>(1e9 * options_.wait);
  while (!waiting_.empty()) {
    const bool waits = newest_log_time_ - waiting_.front().message.log_time < wait;
    if (!finished_ && waits && waiting_bytes_ <= kMostWaitingBytes) return false;
    WaitingImage image = std::move(waiting_.front());
    waiting_.pop_front();
    waiting_bytes_ -= image.bytes;
    if (!images_have_times_) image.time = image.message.log_time;
    try {
      if (is_late(image) || !make_frame(image, frame)) continue;
    } catch (const BadFootage& bad) {
      throw BadFootage(image.message.where + ": " + bad.what());
    }
    last_frame_ = image.time;
    ++counts_.frames;
    return true;
  }
  return false;
}

bool LogFrames::is_late(const WaitingImage& image) {
  if (!last_frame_ || image.time > *last_frame_) return false;
  constexpr Time kLatest = 10 * messages::kSecond;  // an earlier time means that a clock was set, not a late message
  if (image.time < *last_frame_ - kLatest) {
    throw BadFootage("expected increasing times, found a time " +
                     std::to_string((*last_frame_ - image.time) / messages::kSecond) + " s before the previous frame");
  }
  ++counts_.out_of_order;
  return true;
}

std::string LogFrames::camera_frame_of(const WaitingImage& waiting) const {
  if (!options_.camera_frame.empty()) return options_.camera_frame;
  const std::string_view frame = frame_of(waiting.message.message);
  if (frame.empty() && !calibrations_.empty()) return calibrations_.back().info.header.frame;
  return std::string(frame);
}

std::optional<Isometry3> LogFrames::base_from_camera(const WaitingImage& waiting) const {
  if (options_.base_from_camera) return options_.base_from_camera;
  std::optional<Isometry3> motion =
      transforms_.find(options_.base_frame, camera_frame_of(waiting), waiting.time, options_.limits);
  if (motion && options_.camera_axes == CameraAxes::optical) *motion = *motion * body_from_optical().inverse();
  return motion;
}

std::optional<Isometry3> LogFrames::posed_at(const Posed& posed, Time time) const {
  std::optional<Isometry3> motion = posed.motion.at(time, options_.limits);
  if (!motion || posed.child.empty() || posed.child == plain_frame(options_.base_frame)) return motion;
  // The pose of another part of the robot. If the log does not connect it to the base, use it as the base's pose.
  const auto child_from_base = transforms_.find(posed.child, options_.base_frame, time, options_.limits);
  if (child_from_base) motion = *motion * *child_from_base;
  return motion;
}

std::optional<Isometry3> LogFrames::field_from_base(Time time) const {
  std::optional<Isometry3> from_topic = posed_at(pose_, time);
  if (from_topic && !pose_.frame.empty() && pose_.frame != plain_frame(options_.field_frame)) {
    const auto field_from_frame = transforms_.find(options_.field_frame, pose_.frame, time, options_.limits);
    if (field_from_frame) from_topic = *field_from_frame * *from_topic;
  }
  if (from_topic && options_.prefer_pose_topic) return from_topic;
  const auto from_transforms = transforms_.find(options_.field_frame, options_.base_frame, time, options_.limits);
  return from_transforms ? from_transforms : from_topic;
}

std::optional<Isometry3> LogFrames::odometry_from_base(Time time) const {
  std::optional<Isometry3> from_topic = posed_at(odometry_, time);
  if (from_topic) return from_topic;
  return transforms_.find(options_.odometry_frame, options_.base_frame, time, options_.limits);
}

std::optional<TorsoAttitude> LogFrames::attitude_at(Time time) const {
  const std::optional<Isometry3> world_from_base = posed_at(attitude_, time);
  if (!world_from_base) return std::nullopt;
  return attitude_of(world_from_base->linear());
}

bool LogFrames::set_camera(const WaitingImage& waiting, int width, int height, FootageFrame& frame) const {
  if (options_.camera) {
    frame.camera = camera_at(*options_.camera, width, height);
    return true;
  }
  if (calibrations_.empty()) return false;
  const auto later = std::find_if(calibrations_.begin(), calibrations_.end(),
                                  [&](const Calibration& each) { return each.log_time > waiting.message.log_time; });
  const Calibration& newest = later == calibrations_.begin() ? *later : *std::prev(later);
  frame.camera = camera_of(newest.info, width, height, waiting.message.rectified);
  return true;
}

bool LogFrames::make_frame(WaitingImage& waiting, FootageFrame& frame) {
  const Time time = waiting.time;
  const std::optional<Isometry3> mount = base_from_camera(waiting);
  if (!mount) {
    ++counts_.without_camera_pose;
    missing_camera_frame_ = camera_frame_of(waiting);
    return false;
  }
  if (!options_.camera && calibrations_.empty()) {
    ++counts_.without_calibration;
    return false;
  }
  frame = FootageFrame{};
  frame.time = seconds_of(time);
  frame.name = waiting.message.where;
  if (const auto* const raw = std::get_if<messages::RawImage>(&waiting.message.message)) {
    frame.image = image_of(*raw);
  } else if (const auto* const compressed = std::get_if<messages::CompressedImage>(&waiting.message.message)) {
    if (!options_.decode_image)
      throw BadFootage("expected an uncompressed image, found the format " + messages::in_quotes(compressed->format));
    frame.image = options_.decode_image(compressed->data, waiting.message.where);
  }
  set_camera(waiting, frame.image.width(), frame.image.height(), frame);

  const std::optional<Isometry3> in_field = field_from_base(time), in_odometry = odometry_from_base(time);
  const std::optional<TorsoAttitude> attitude = attitude_at(time);
  if (in_field) frame.pose = planar_part(*in_field);
  if (in_odometry) frame.odometry = planar_part(*in_odometry);

  const std::optional<Isometry3>& spatial = in_field ? in_field : in_odometry;
  TorsoAttitude tilt;
  double height = 0.0;
  if (spatial) {
    tilt = attitude_of(spatial->linear());
    height = spatial->translation().z();
  }
  constexpr double kLevel = 1e-9;  // rad
  if (std::abs(tilt.roll) < kLevel && std::abs(tilt.pitch) < kLevel) {
    if (height == 0.0) height = options_.base_height;
    if (attitude) tilt = *attitude;
  }
  frame.torso = attitude ? *attitude : tilt;
  Isometry3 robot_from_base = Isometry3::Identity();
  robot_from_base.linear() = rotation_of(tilt);
  robot_from_base.translation().z() = height;
  frame.robot_from_camera = robot_from_base * *mount;
  return true;
}

std::string LogFrames::reason_of_no_frame() const {
  if (counts_.frames > 0) return {};
  if (counts_.images == 0) return "expected images, found none";
  if (counts_.without_camera_pose > 0) {
    const std::string names = transforms_.names();
    return "expected transforms from camera frame " + messages::in_quotes(missing_camera_frame_) + " to base frame " +
           messages::in_quotes(options_.base_frame) + " at the images' times, found " +
           (names.empty() ? "no transforms" : "the frames " + names);
  }
  return "expected camera info, found none";
}

}  // namespace reorient
