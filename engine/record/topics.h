// SPDX-License-Identifier: MIT
// The topics of a frame's record, one row per topic: the names in recordings, live views and docs.
#pragma once

#include <array>
#include <cstdint>
#include <initializer_list>
#include <string_view>

namespace reorient {

enum class Topic {
  inputs,
  world,
  percepts,
  machines,
  commands,
  answer,
  events,
  application,
  // The following are filled only if an observer requests them.
  images,
  pose_particles,
  room,
  conditions,
  parameters,
  costs,
  feature_fits
};
inline constexpr int kTopicCount = 15;
constexpr int enum_count(Topic) { return kTopicCount; }

struct TopicInfo {
  Topic topic;
  std::string_view name;
  std::string_view description;
  bool always = true;        ///< filled in every frame; otherwise only if an observer requests it
  bool reproducible = true;  ///< the same for the same inputs, on every computer
};

inline constexpr std::array<TopicInfo, kTopicCount> kTopics{{
    {Topic::inputs, "inputs", "inputs: cameras, body, odometry, settings from outside"},
    {Topic::world, "world", "world that behaviors read: posture, pose, confidences"},
    {Topic::percepts, "percepts", "observations of the field per camera"},
    {Topic::machines, "machines", "states of all machines, changes of state, published flags"},
    {Topic::commands, "commands", "commands of behaviors with verdicts; pauses; the reorientation"},
    {Topic::answer, "answer", "requests to the robot, and which behavior has which part of the body"},
    {Topic::events, "events", "changes of posture, log lines, faults of scripts, reloads, changed parameters"},
    {Topic::application, "application", "values and actions of the application; empty if it declares none"},
    {Topic::images, "images", "the cameras' pixels", false},
    {Topic::pose_particles, "pose_particles", "the pose filter's particles, before a reorientation as well", false},
    {Topic::room, "room", "wall, background model, perceived tiles, evidence of each tile, the view filter's belief",
     false},
    {Topic::conditions, "conditions", "possible transitions: results of their conditions, and for how long", false},
    {Topic::parameters, "parameters", "every parameter with its value, range and origin", false},
    {Topic::costs, "costs", "computing time of each stage, and cost of each script", false, false},
    {Topic::feature_fits, "feature_fits", "how well each feature of the percepts fits the field at the believed pose",
     false},
}};

constexpr const TopicInfo& info(Topic topic) { return kTopics[static_cast<std::size_t>(topic)]; }

/// Some of the topics.
class Topics {
 public:
  constexpr Topics() = default;
  constexpr Topics(std::initializer_list<Topic> topics) {
    for (const Topic topic : topics) bits_ |= bit(topic);
  }
  static constexpr Topics all() {
    Topics topics;
    for (const TopicInfo& row : kTopics) topics.bits_ |= bit(row.topic);
    return topics;
  }
  static constexpr Topics always() {
    Topics topics;
    for (const TopicInfo& row : kTopics) topics.bits_ |= row.always ? bit(row.topic) : 0u;
    return topics;
  }

  constexpr bool has(Topic topic) const { return (bits_ & bit(topic)) != 0; }
  constexpr Topics operator|(Topics other) const {
    Topics both;
    both.bits_ = bits_ | other.bits_;
    return both;
  }
  constexpr Topics operator&(Topics other) const {
    Topics common;
    common.bits_ = bits_ & other.bits_;
    return common;
  }
  constexpr bool operator==(const Topics&) const = default;

  template <typename Archive>
  static void archive(Archive& archive, auto& self) {
    archive(self.bits_);
    if constexpr (Archive::kReads) self.bits_ &= (1u << kTopicCount) - 1u;
  }

 private:
  static constexpr std::uint32_t bit(Topic topic) { return 1u << static_cast<unsigned>(topic); }

  std::uint32_t bits_ = 0;
};

}  // namespace reorient
