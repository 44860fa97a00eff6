// SPDX-License-Identifier: MIT
#include "robots/footage/transform_tree.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "robots/footage/messages/bad_message.h"

namespace reorient {
namespace {

using messages::Time;

double seconds_between(Time from, Time to) { return 1e-9 * static_cast<double>(to - from); }

Isometry3 interpolated(const Isometry3& before, const Isometry3& after, double fraction) {
  const Eigen::Quaterniond first(before.linear());
  Eigen::Quaterniond second(after.linear());
  if (first.dot(second) < 0.0) second.coeffs() = -second.coeffs();  // take the shorter rotation
  const Eigen::Quaterniond between((1.0 - fraction) * first.coeffs() + fraction * second.coeffs());
  Isometry3 motion = Isometry3::Identity();
  motion.linear() = between.normalized().toRotationMatrix();
  motion.translation() = (1.0 - fraction) * before.translation() + fraction * after.translation();
  return motion;
}

}  // namespace

std::optional<Eigen::Matrix3d> rotation_of(const messages::Quaternion& quaternion) {
  const Eigen::Quaterniond rotation(quaternion.w, quaternion.x, quaternion.y, quaternion.z);
  const double length = rotation.norm();
  constexpr double kTolerance = 0.1;  // messages are often of single precision, or rounded as text
  if (!std::isfinite(length) || std::abs(length - 1.0) > kTolerance) return std::nullopt;
  return rotation.normalized().toRotationMatrix();
}

std::optional<Isometry3> isometry_of(const messages::Motion& motion) {
  const std::optional<Eigen::Matrix3d> rotation = rotation_of(motion.rotation);
  constexpr double kFarthest = 1e8;  // m; map coordinates may cover a whole country
  if (!rotation || !motion.translation.allFinite()) return std::nullopt;
  if (motion.translation.cwiseAbs().maxCoeff() > kFarthest) return std::nullopt;
  Isometry3 isometry = Isometry3::Identity();
  isometry.linear() = *rotation;
  isometry.translation() = motion.translation;
  return isometry;
}

void MotionTrack::add(Time time, const Isometry3& motion) {
  constexpr Time kHistory = 30 * messages::kSecond;
  constexpr std::size_t kMost = 100000;
  if (samples_.empty() || samples_.back().time < time) {
    samples_.push_back({time, motion});
    while (samples_.size() > kMost || samples_.front().time < time - kHistory) samples_.pop_front();
    return;
  }
  const auto it = std::lower_bound(samples_.begin(), samples_.end(), time,
                                   [](const Sample& sample, Time wanted) { return sample.time < wanted; });
  if (it->time == time) {
    it->motion = motion;
  } else {
    samples_.insert(it, {time, motion});
    if (samples_.size() > kMost) samples_.pop_front();
  }
}

std::optional<Isometry3> MotionTrack::at(Time time, const MotionLimits& limits) const {
  const auto after = std::lower_bound(samples_.begin(), samples_.end(), time,
                                      [](const Sample& sample, Time wanted) { return sample.time < wanted; });
  const bool has_after = after != samples_.end(), has_before = after != samples_.begin();
  if (has_after && after->time == time) return after->motion;
  const auto before = has_before ? std::prev(after) : samples_.end();
  if (has_before && has_after) {
    const double gap = seconds_between(before->time, after->time);
    if (gap <= limits.max_gap)
      return interpolated(before->motion, after->motion, seconds_between(before->time, time) / gap);
  }
  const double age_before = has_before ? seconds_between(before->time, time) : limits.max_age + 1.0;
  const double age_after = has_after ? seconds_between(time, after->time) : limits.max_age + 1.0;
  if (std::min(age_before, age_after) > limits.max_age) return std::nullopt;
  return age_before <= age_after ? before->motion : after->motion;
}

std::optional<Isometry3> MotionTrack::latest(Time time) const {
  if (samples_.empty()) return std::nullopt;
  const auto after = std::upper_bound(samples_.begin(), samples_.end(), time,
                                      [](Time wanted, const Sample& sample) { return wanted < sample.time; });
  return after == samples_.begin() ? after->motion : std::prev(after)->motion;
}

std::string_view plain_frame(std::string_view name) {
  if (name.starts_with('/')) name.remove_prefix(1);
  return name;
}

bool TransformTree::add(const messages::Transform& transform, Validity validity) {
  constexpr std::size_t kMostFrames = 10000;
  const std::string parent(plain_frame(transform.header.frame)), child(plain_frame(transform.child));
  const std::optional<Isometry3> motion = isometry_of(transform.parent_from_child);
  if (!motion || parent.empty() || child.empty() || parent == child) return false;
  if (edges_.size() >= kMostFrames && !edges_.contains(child))
    throw BadFootage("expected at most 10000 coordinate frames, found more");
  Edge& edge = edges_[child];
  if (edge.parent != parent || validity == Validity::fixed) edge.parent_from_child.clear();
  edge.parent = parent;
  edge.validity = validity;
  edge.parent_from_child.add(transform.header.time, *motion);
  return true;
}

std::optional<Isometry3> TransformTree::find(std::string_view target, std::string_view source, Time time,
                                             const MotionLimits& limits) const {
  struct Ancestor {
    std::string_view frame;
    Isometry3 from_start;  // this frame from the first one
  };
  const auto ancestors_of = [&](std::string_view frame) {
    constexpr std::size_t kDeepest = 1000;  // a longer chain is a cycle
    std::vector<Ancestor> all{{frame, Isometry3::Identity()}};
    while (all.size() < kDeepest) {
      const auto it = edges_.find(all.back().frame);
      if (it == edges_.end()) break;
      const Edge& edge = it->second;
      std::optional<Isometry3> motion;
      if (edge.validity != Validity::fixed) motion = edge.parent_from_child.at(time, limits);
      if (!motion && edge.validity != Validity::limited) motion = edge.parent_from_child.latest(time);
      if (!motion) break;
      all.push_back({edge.parent, *motion * all.back().from_start});
    }
    return all;
  };
  const std::vector<Ancestor> of_source = ancestors_of(plain_frame(source));
  for (const Ancestor& common : ancestors_of(plain_frame(target))) {
    const auto it = std::find_if(of_source.begin(), of_source.end(),
                                 [&](const Ancestor& each) { return each.frame == common.frame; });
    if (it != of_source.end()) return common.from_start.inverse() * it->from_start;
  }
  return std::nullopt;
}

std::string TransformTree::names() const {
  std::set<std::string_view> names;
  for (const auto& [child, edge] : edges_) {
    names.insert(child);
    names.insert(edge.parent);
  }
  constexpr std::size_t kMost = 20;
  std::string all;
  std::size_t count = 0;
  for (const std::string_view name : names) {
    if (count++ == kMost) return all + " and " + std::to_string(names.size() - kMost) + " more";
    if (!all.empty()) all += ", ";
    all += messages::in_quotes(name);
  }
  return all;
}

}  // namespace reorient
