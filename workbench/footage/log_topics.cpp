// SPDX-License-Identifier: MIT
#include "workbench/footage/log_topics.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>
#include <utility>

#include "robots/footage/messages/bad_message.h"

namespace reorient {
namespace {

using messages::Content;
using messages::in_quotes;

std::string_view folder_of(std::string_view topic) {
  const std::size_t slash = topic.rfind('/');
  return slash == std::string_view::npos ? std::string_view() : topic.substr(0, slash);
}

std::string_view last_part_of(std::string_view topic) { return topic.substr(topic.rfind('/') + 1); }

/// "/camera" of "/camera/image_raw" and of "/camera/image_raw/compressed".
std::string_view camera_namespace_of(std::string_view image) {
  return folder_of(last_part_of(image) == "compressed" ? folder_of(image) : image);
}

bool is_goal(std::string_view topic) {
  constexpr std::array<std::string_view, 3> kGoals{"goal", "goal_pose", "initialpose"};
  return std::find(kGoals.begin(), kGoals.end(), last_part_of(topic)) != kGoals.end();
}

bool fits(Content content, Content use) {
  const auto is_pose = [](Content one) { return one == Content::pose || one == Content::odometry; };
  return content == use || (is_pose(content) && is_pose(use));
}

template <typename Names>
std::string list_of(const Names& names) {
  constexpr std::size_t kMost = 20;
  std::string list;
  std::size_t count = 0;
  for (const auto& name : names) {
    if (count++ == kMost) return list + " and " + std::to_string(names.size() - kMost) + " more";
    if (!list.empty()) list += ", ";
    list += in_quotes(name);
  }
  return list;
}

class Chooser {
 public:
  explicit Chooser(const mcap::Contents& contents) {
    for (const mcap::Channel& channel : contents.channels) {
      if (contents.statistics && !contents.statistics->messages_of.contains(channel.id)) continue;
      const mcap::Schema* const schema = contents.schema(channel.schema);
      const std::string name = schema != nullptr ? schema->name : std::string();
      const messages::MessageType* const type = messages::find_message_type(name, channel.encoding);
      if (type != nullptr) {
        usable_.push_back({channel.id, channel.topic, type});
      } else if (const std::string encodings = messages::encodings_of(name); !encodings.empty()) {
        std::string line = channel.topic;
        line.append(" (").append(name).append(" in ").append(channel.encoding);
        line.append(", expected ").append(encodings).append(")");
        others_.push_back(std::move(line));
      }
    }
  }

  /// Names of topics, each once.
  std::set<std::string> topics_of(Content content) const {
    std::set<std::string> topics;
    for (const Usable& each : usable_)
      if (each.type->content == content) topics.insert(each.topic);
    return topics;
  }

  void use(const std::string& topic, Content use) {
    bool found = false;
    for (const Usable& each : usable_) {
      if (each.topic != topic || !fits(each.type->content, use)) continue;
      LogChannel& channel = chosen_.channels[each.id];
      channel.topic = messages::printable(topic);
      channel.type = each.type;
      channel.uses.push_back(use);
      channel.rectified = topic.find("image_rect") != std::string::npos;
      if (last_part_of(topic) == "tf_static") channel.validity = TransformTree::Validity::fixed;
      if (each.type->schema.starts_with("foxglove.")) channel.validity = TransformTree::Validity::lasting;
      if (!found)
        chosen_.lines.push_back(std::string(name_of(use)) + ": " + messages::printable(topic) + " (" +
                                std::string(each.type->schema) + ", " + std::string(each.type->encoding) + ")");
      found = true;
    }
    if (found) return;
    std::set<std::string> candidates;
    for (const Usable& each : usable_)
      if (fits(each.type->content, use)) candidates.insert(each.topic);
    throw BadFootage(std::string(name_of(use)) + " topic: expected " +
                     (candidates.empty() ? "one with such messages" : "one of " + list_of(candidates)) + ", found " +
                     in_quotes(topic) + others());
  }

  /// `without`: a remedy if the topic is missing.
  [[noreturn]] void fail(Content content, const std::set<std::string>& candidates,
                         std::string_view without = "") const {
    if (candidates.empty())
      throw BadFootage("expected a topic with " + std::string(name_of(content)) + " messages, found none" + others() +
                       std::string(without));
    throw BadFootage("expected the name of one " + std::string(name_of(content)) + " topic, because there are " +
                     std::to_string(candidates.size()) + ": " + list_of(candidates));
  }

  ChosenTopics take() { return std::move(chosen_); }
  void add_line(std::string line) { chosen_.lines.push_back(std::move(line)); }

 private:
  struct Usable {
    std::uint16_t id;
    std::string topic;
    const messages::MessageType* type;
  };

  std::string others() const { return others_.empty() ? "" : "; not readable: " + list_of(others_); }

  std::vector<Usable> usable_;
  std::vector<std::string> others_;
  ChosenTopics chosen_;
};

void choose_camera_info(Chooser& chooser, const std::string& image) {
  const std::set<std::string> all = chooser.topics_of(Content::camera_info);
  std::set<std::string> candidates;
  for (const std::string& topic : all)
    if (folder_of(topic) == camera_namespace_of(image)) candidates.insert(topic);
  if (candidates.empty()) candidates = all;
  if (candidates.size() != 1)
    chooser.fail(Content::camera_info, candidates, "; --fov-degrees describes a camera without distortion");
  chooser.use(*candidates.begin(), Content::camera_info);
}

}  // namespace

bool ChosenTopics::has(Content content) const {
  return std::any_of(channels.begin(), channels.end(), [&](const auto& each) {
    const std::vector<Content>& uses = each.second.uses;
    return std::find(uses.begin(), uses.end(), content) != uses.end();
  });
}

ChosenTopics choose_topics(const mcap::Contents& contents, const LogTopics& wanted, bool needs_camera_info) {
  Chooser chooser(contents);
  std::string image = wanted.image.value_or("");
  if (image.empty()) {
    const std::set<std::string> images = chooser.topics_of(Content::image);
    if (images.size() != 1) chooser.fail(Content::image, images);
    image = *images.begin();
  }
  chooser.use(image, Content::image);

  if (wanted.camera_info && !wanted.camera_info->empty()) {
    chooser.use(*wanted.camera_info, Content::camera_info);
  } else if (needs_camera_info) {
    choose_camera_info(chooser, image);
  }

  const std::set<std::string> all_transforms = chooser.topics_of(Content::transforms);
  const std::vector<std::string> transforms =
      wanted.transforms.value_or(std::vector<std::string>(all_transforms.begin(), all_transforms.end()));
  for (const std::string& topic : transforms) chooser.use(topic, Content::transforms);

  const auto choose = [&](Content content, const std::optional<std::string>& name, bool may_be_several) {
    if (name) {
      if (!name->empty()) chooser.use(*name, content);
      return;
    }
    std::set<std::string> candidates = chooser.topics_of(content);
    if (content == Content::odometry && wanted.pose) candidates.erase(*wanted.pose);
    if (content == Content::pose) std::erase_if(candidates, [](const std::string& topic) { return is_goal(topic); });
    if (candidates.size() == 1) {
      chooser.use(*candidates.begin(), content);
    } else if (candidates.size() > 1 && may_be_several) {
      chooser.add_line(std::string(name_of(content)) + ": none of " + list_of(candidates));
    } else if (candidates.size() > 1) {
      chooser.fail(content, candidates);
    }
  };
  choose(Content::pose, wanted.pose, !transforms.empty());
  choose(Content::odometry, wanted.odometry, false);
  choose(Content::imu, wanted.imu, false);
  return chooser.take();
}

}  // namespace reorient
