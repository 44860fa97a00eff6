// SPDX-License-Identifier: MIT
#include "robots/companion/frame_message.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>

#include "geometry/settable_pose.h"

namespace reorient {
namespace {

constexpr double kFarthest = 1e4;  // m; also limits summed angles, rad
constexpr std::uint32_t kBodyBits =
    REORIENT_HAS_HEAD | REORIENT_HAS_ATTITUDE | REORIENT_HAS_RATES | REORIENT_HAS_ACCELERATION | REORIENT_HAS_FOOT_LOAD;
constexpr std::uint32_t kFrameBits =
    REORIENT_HAS_TIME | REORIENT_HAS_BELIEF | REORIENT_HAS_TOLD_POSE | REORIENT_HAS_REFEREE | REORIENT_OTHER_HALF;

template <std::size_t Size>
bool are_within(const double (&values)[Size], double most) {
  return std::all_of(std::begin(values), std::end(values),
                     [most](double value) { return value >= -most && value <= most; });
}

/// Checks the sensor values that a frame and a sample have in common.
template <typename Body>
bool is_body_valid(const Body& body) {
  constexpr double kFastest = 200.0, kHardest = 2000.0, kHeaviest = 1000.0;
  const auto unless = [&](std::uint32_t what, bool sound) { return (body.has & what) == 0 || sound; };
  return unless(REORIENT_HAS_HEAD, are_within(body.head, kPi)) &&
         unless(REORIENT_HAS_ATTITUDE, are_within(body.attitude, 2.0 * kPi)) &&
         unless(REORIENT_HAS_RATES, are_within(body.rates, kFastest)) &&
         unless(REORIENT_HAS_ACCELERATION, are_within(body.acceleration, kHardest)) &&
         unless(REORIENT_HAS_FOOT_LOAD, std::abs(body.foot_load) <= kHeaviest);
}

template <typename Body>
BodySample sample_of(const Body& body, double time) {
  const auto has = [&](std::uint32_t what) { return (body.has & what) != 0; };
  BodySample sample;
  sample.time = time;
  if (has(REORIENT_HAS_HEAD)) sample.head = {body.head[0], body.head[1]};
  if (has(REORIENT_HAS_ATTITUDE)) sample.torso = {body.attitude[0], body.attitude[1]};
  if (has(REORIENT_HAS_RATES)) sample.angular_velocity = {body.rates[0], body.rates[1], body.rates[2]};
  if (has(REORIENT_HAS_ACCELERATION))
    sample.acceleration = {body.acceleration[0], body.acceleration[1], body.acceleration[2]};
  if (has(REORIENT_HAS_FOOT_LOAD)) sample.foot_load = body.foot_load;
  return sample;
}

/// Whether the three rows contain a rotation and a position.
bool is_camera_pose(const double (&pose)[12]) {
  constexpr double kTolerance = 1e-3;
  if (!are_within(pose, kFarthest)) return false;
  Eigen::Matrix3d rotation;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) rotation(row, column) = pose[4 * row + column];
  const Eigen::Matrix3d error = rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  return error.cwiseAbs().maxCoeff() < kTolerance && rotation.determinant() > 0.0;
}

}  // namespace

void read_frame(std::span<const std::byte> bytes, bool has_detector, FrameMessage& message) {
  message.frame = take_message<reorient_frame>(bytes, "frame");
  message.particles.clear();
  message.messages.clear();
  const reorient_frame& frame = message.frame;
  if (frame.particles > REORIENT_MOST_PARTICLES)
    throw BadMessage("frame: " + std::to_string(frame.particles) + " particles (expected at most 2000)");
  if (frame.messages > REORIENT_MOST_MESSAGES)
    throw BadMessage("frame: " + std::to_string(frame.messages) + " messages (expected at most 8)");
  if (frame.posture > REORIENT_GETTING_UP)
    throw BadMessage("frame: unknown posture " + std::to_string(frame.posture) + " (expected 0 to 4)");
  check_bits(frame.has, kBodyBits | kFrameBits, "frame: has");
  if (message.has(REORIENT_HAS_REFEREE)) check_choice(frame.penalized, 1, "frame: penalized");
  for (const reorient_image& image : frame.images) check_choice(image.present, 2, "frame: images: present");
  for (std::uint32_t i = 0; i < frame.particles; ++i) {
    const auto particle = take_message<reorient_particle>(bytes, "frame: particle");
    message.particles.push_back({Pose2(particle.x, particle.y, particle.rotation), particle.weight});
  }
  for (std::uint32_t i = 0; i < frame.messages; ++i) {
    const auto word = take_message<reorient_message>(bytes, "frame: message");
    if (word.length > REORIENT_LONGEST_TEXT)
      throw BadMessage("frame: message of " + std::to_string(word.length) + " bytes (expected at most 240)");
    message.messages.push_back({word.sender, std::string(word.text, word.length)});
  }
  message.percepts.clear();
  message.has_percepts = has_detector && !bytes.empty();
  if (message.has_percepts) read_percepts(bytes, message.percepts);
  if (!bytes.empty())
    throw BadMessage("frame: " + std::to_string(bytes.size()) + " bytes more than its particles and messages need");
}

bool is_odometry_valid(const reorient_frame& frame) { return are_within(frame.odometry, kFarthest); }

bool is_initial_pose_valid(const reorient_frame& frame) {
  return mistake_in_pose(frame.told_pose[0], frame.told_pose[1], frame.told_pose[2]).empty() &&
         frame.told_deviation[0] > 0.0 && frame.told_deviation[0] <= 20.0 && frame.told_deviation[1] > 0.0 &&
         frame.told_deviation[1] <= 10.0;
}

Pose2 pose_of(const double (&numbers)[3]) { return Pose2(numbers[0], numbers[1], numbers[2]); }

std::string error_in(const FrameMessage& message) {
  constexpr double kLatest = 1e10, kOldest = 1.0;  // s
  const reorient_frame& frame = message.frame;
  if (message.has(REORIENT_HAS_TIME) && !(std::abs(frame.time) <= kLatest))
    return "invalid time (expected -1e10 to 1e10 s)";
  if (!is_odometry_valid(frame)) return "invalid odometry (expected -1e4 to 1e4 m and rad)";
  if (!is_body_valid(frame))
    return "invalid head, attitude, rates, acceleration or foot_load: not finite, or out of range";
  if (message.has(REORIENT_HAS_BELIEF) && !(are_within(frame.belief, kFarthest) && are_within(frame.covariance, 1e6)))
    return "invalid belief (expected -1e4 to 1e4 m and rad, covariance -1e6 to 1e6)";
  const bool sound_particles = std::all_of(message.particles.begin(), message.particles.end(), [](const auto& one) {
    return one.pose.position.cwiseAbs().maxCoeff() <= kFarthest && std::abs(one.pose.rotation) <= kFarthest &&
           one.weight >= 0.0 && std::isfinite(one.weight);
  });
  if (!sound_particles)
    return "invalid particle (expected poses of -1e4 to 1e4 m and rad, finite weights of at least 0)";
  if (message.has(REORIENT_HAS_TOLD_POSE) && !is_initial_pose_valid(frame))
    return "invalid told_pose or told_deviation (expected -100 to 100 m, -200 pi to 200 pi rad, deviations above 0, at "
           "most 20 m and 10 rad)";
  for (std::size_t i = 0; i < std::size(frame.images); ++i) {
    const reorient_image& image = frame.images[i];
    if (image.present == 0) continue;
    const std::string which = "images[" + std::to_string(i) + "].";
    if (!(image.age >= 0.0 && image.age <= kOldest))
      return which + "age is " + std::to_string(image.age) + " s (expected 0 to 1: time is that of the newest image)";
    if (image.present == 2 && !is_camera_pose(image.pose))
      return which + "pose: expected a rotation matrix and a position";
  }
  return "";
}

reorient_sample read_sample(std::span<const std::byte> bytes) {
  const auto sample = take_message<reorient_sample>(bytes, "sample");
  if (!bytes.empty())
    throw BadMessage("sample: " + std::to_string(bytes.size()) + " bytes too many (expected " +
                     std::to_string(sizeof(sample)) + ")");
  check_bits(sample.has, kBodyBits | REORIENT_HAS_TIME, "sample: has");
  return sample;
}

bool is_valid(const reorient_sample& sample) { return std::isfinite(sample.time) && is_body_valid(sample); }

BodySample body_sample(const reorient_frame& frame, double time) { return sample_of(frame, time); }
BodySample body_sample(const reorient_sample& sample, double time) { return sample_of(sample, time); }

}  // namespace reorient
