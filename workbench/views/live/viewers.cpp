// SPDX-License-Identifier: MIT
#include "workbench/views/live/viewers.h"

#include <algorithm>
#include <utility>

namespace reorient::live {
namespace {

Importance importance_of(std::size_t topic) {
  const auto which = static_cast<ViewerTopic>(topic);
  if (which == ViewerTopic::upper_image || which == ViewerTopic::lower_image) return Importance::image;
  return kViewerTopics[topic].lasts || moment_topics().test(topic) ? Importance::lasting : Importance::data;
}

std::optional<Bulk> bulk_of(std::size_t topic) {
  switch (static_cast<ViewerTopic>(topic)) {
    case ViewerTopic::upper_image:
    case ViewerTopic::upper_annotations:
      return Bulk::upper;
    case ViewerTopic::lower_image:
    case ViewerTopic::lower_annotations:
      return Bulk::lower;
    case ViewerTopic::pose_particles:
      return Bulk::particles;
    case ViewerTopic::wall:
      return Bulk::wall;
    default:
      return std::nullopt;
  }
}

/// Whether a message of the topic is not made for each frame, so that the next frame does not replace it.
bool is_rare(std::size_t topic) {
  return kViewerTopics[topic].lasts || static_cast<ViewerTopic>(topic) == ViewerTopic::pose_particles;
}

}  // namespace

void Viewers::set_application(const ApplicationInterface& application) {
  const std::lock_guard lock(mutex_);
  application_ = application;
}

ApplicationInterface Viewers::application() const {
  const std::lock_guard lock(mutex_);
  return application_;
}

ViewerId Viewers::add(Mailbox mailbox) {
  const std::lock_guard lock(mutex_);
  viewers_[next_].mailbox = std::move(mailbox);
  ++gone_.viewers;
  update_flags();
  return next_++;
}

void Viewers::remove(ViewerId id) {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(id);
  if (found == viewers_.end()) return;
  count(*found->second.mailbox, gone_);
  viewers_.erase(found);
  update_flags();
}

void Viewers::count(const ViewerMailbox& mailbox, Counts& counts) {
  const FrameCounts left_out = mailbox.left_out();
  counts.dropped += mailbox.dropped();
  counts.left_out.frames += left_out.frames;
  counts.left_out.images += left_out.images;
}

void Viewers::update_flags() {
  ViewerTopics topics;
  bool watches = false;
  for (const auto& [id, viewer] : viewers_) {
    for (std::size_t topic = 0; topic < viewer.subscriptions.size(); ++topic)
      if (viewer.subscriptions[topic]) topics.set(topic);
    watches = watches || viewer.watches_all || !viewer.watched.empty();
  }
  subscribed_ = topics.to_ulong();
  any_ = !viewers_.empty();
  any_watches_ = watches;
}

void Viewers::send_data(const Viewer& viewer, std::size_t topic, std::uint64_t time,
                        const std::shared_ptr<const std::string>& message) {
  const auto head = message_data_head(*viewer.subscriptions[topic], time);
  viewer.mailbox->add_data({WebSocketType::binary, {head.begin(), head.end()}, message}, importance_of(topic));
}

std::string Viewers::subscribe(ViewerId id, const Subscribe::One& one) {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(id);
  if (found == viewers_.end()) return "";
  Viewer& viewer = found->second;
  const std::optional<std::size_t> topic = topic_of(one.channel);
  if (!topic) return "subscribe: unknown channel " + std::to_string(one.channel);
  if (viewer.subscriptions[*topic])
    return "subscribe: channel " + std::to_string(one.channel) + " has a subscription of this viewer already";
  if (std::find(viewer.subscriptions.begin(), viewer.subscriptions.end(), one.id) != viewer.subscriptions.end())
    return "subscribe: subscription " + std::to_string(one.id) + " is in use; choose another id";
  viewer.subscriptions[*topic] = one.id;
  update_flags();
  const bool lasts = kViewerTopics[*topic].lasts;
  const std::uint64_t still_at = still_at_.load(std::memory_order_relaxed);
  const Last& last = last_[*topic];
  if (last.message && (lasts || last.time == still_at)) send_data(viewer, *topic, last.time, last.message);
  if (lasts) has_new_subscriber_ = true;
  if (still_at != kMoving) has_late_subscriber_ = true;
  return "";
}

std::string Viewers::unsubscribe(ViewerId id, std::uint32_t subscription) {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(id);
  if (found == viewers_.end()) return "";
  auto& all = found->second.subscriptions;
  const auto own = std::find(all.begin(), all.end(), subscription);
  if (own == all.end()) return "unsubscribe: unknown subscription " + std::to_string(subscription);
  own->reset();
  std::erase_if(found->second.frame, [&](const FrameMessage& one) { return one.subscription == subscription; });
  found->second.mailbox->forget(subscription);
  update_flags();
  return "";
}

void Viewers::watch(ViewerId id, const WatchParameters& watched) {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(id);
  if (found == viewers_.end()) return;
  Viewer& viewer = found->second;
  if (watched.names.empty()) {
    viewer.watches_all = watched.begins;
    viewer.watched.clear();
  }
  constexpr std::size_t kMost = 10'000;
  for (const std::string& name : watched.names) {
    if (!watched.begins) {
      viewer.watched.erase(name);
    } else if (viewer.watched.size() < kMost) {
      viewer.watched.insert(name);
    }
  }
  update_flags();
}

void Viewers::publish(ViewerTopic topic, std::uint64_t time, std::string message) {
  const auto index = static_cast<std::size_t>(topic);
  const auto shared = std::make_shared<const std::string>(std::move(message));
  const std::lock_guard lock(mutex_);
  const bool is_of_frame = !moment_topics().test(index);
  if (is_of_frame) last_[index] = {time, shared};
  for (auto& [id, viewer] : viewers_) {
    if (!viewer.subscriptions[index]) continue;
    if (is_of_frame) {
      viewer.frame.push_back(
          {*viewer.subscriptions[index], shared, importance_of(index), bulk_of(index), is_rare(index)});
    } else {
      send_data(viewer, index, time, shared);
    }
  }
}

void Viewers::end_frame(std::uint64_t time) {
  const std::lock_guard lock(mutex_);
  for (auto& [id, viewer] : viewers_)
    if (!viewer.frame.empty()) viewer.mailbox->add_frame(time, std::exchange(viewer.frame, {}));
}

void Viewers::send(ViewerId id, std::string text) {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(id);
  if (found != viewers_.end()) found->second.mailbox->add_control(std::move(text));
}

void Viewers::send(ViewerId id, std::vector<std::byte> binary) {
  const std::lock_guard lock(mutex_);
  const auto found = viewers_.find(id);
  if (found != viewers_.end())
    found->second.mailbox->add_control(Outgoing{WebSocketType::binary, std::move(binary), nullptr});
}

void Viewers::send_all(const std::vector<std::byte>& binary) {
  const std::lock_guard lock(mutex_);
  for (const auto& [id, viewer] : viewers_)
    viewer.mailbox->add_control(Outgoing{WebSocketType::binary, binary, nullptr});
}

void Viewers::send_changes(const std::vector<Parameter>& now) {
  const std::lock_guard lock(mutex_);
  const bool is_first = values_.empty();
  std::vector<Parameter> changed;
  for (const Parameter& parameter : now) {
    const auto [last, is_new] = values_.try_emplace(parameter.name, parameter.value);
    if (!is_new && last->second == parameter.value) continue;
    last->second = parameter.value;
    changed.push_back(parameter);
  }
  if (is_first) return;  // no viewer knows other values
  for (const auto& [id, viewer] : viewers_) {
    std::vector<Parameter> watched = changed;
    const std::set<std::string>& names = viewer.watched;
    if (!viewer.watches_all)
      std::erase_if(watched, [&names](const Parameter& one) { return names.count(one.name) == 0; });
    if (!watched.empty()) viewer.mailbox->add_control(parameter_values(watched, std::nullopt));
  }
}

Viewers::Counts Viewers::counts() const {
  const std::lock_guard lock(mutex_);
  Counts counts = gone_;
  for (const auto& [id, viewer] : viewers_) count(*viewer.mailbox, counts);
  return counts;
}

}  // namespace reorient::live
