// SPDX-License-Identifier: MIT
#include "workbench/footage/mcap_log.h"

#include <algorithm>
#include <limits>
#include <set>
#include <utility>

#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/topics.h"

namespace reorient {
namespace {

constexpr double kDefaultCameraHeight = 0.5;  // m

std::unique_ptr<mcap::Source> opened(const std::filesystem::path& file) {
  try {
    return std::make_unique<mcap::FileSource>(file);
  } catch (const std::runtime_error& error) {
    throw BadFootage(error.what());
  }
}

messages::Time time_of(std::uint64_t nanoseconds) {
  constexpr std::uint64_t kLatest = std::numeric_limits<messages::Time>::max() / 2;
  return static_cast<messages::Time>(std::min(nanoseconds, kLatest));
}

}  // namespace

McapLog::McapLog(const std::filesystem::path& file, McapLogOptions options)
    : McapLog(opened(file), file.string(), std::move(options)) {}

McapLog::McapLog(std::unique_ptr<mcap::Source> source, std::string name, McapLogOptions options)
    : source_(std::move(source)), name_(std::move(name)) {
  try {
    open(std::move(options));
  } catch (const std::runtime_error& error) {
    throw BadFootage(name_ + ": " + error.what());
  }
}

void McapLog::open(McapLogOptions options) {
  mcap::Contents contents = mcap::read_contents(*source_);
  if (contents.damage) {
    damage_ = contents.damage->what();
    const auto is_behind = [&](const mcap::ChunkPlace& place) { return place.where >= contents.damage->where; };
    std::erase_if(contents.chunks, is_behind);
    std::erase_if(contents.loose, is_behind);
  }
  mcap::read_topics_in_chunks(*source_, contents);
  topics_ = choose_topics(contents, options.topics, !options.frames.camera);

  std::set<std::uint16_t> channels;
  for (const auto& [id, channel] : topics_.channels) channels.insert(id);
  messages_.emplace(*source_, contents.places(), std::move(channels));

  if (options.topics.pose && !options.topics.pose->empty()) options.frames.prefer_pose_topic = true;
  if (!options.frames.base_from_camera && !topics_.has(messages::Content::transforms)) {
    Isometry3 mount = Isometry3::Identity();
    mount.translation().z() = kDefaultCameraHeight;
    options.frames.base_from_camera = mount;
    topics_.lines.emplace_back("transform: none; the camera is level, 0.5 m above the base frame");
  }
  frames_.emplace(std::move(options.frames));
}

void McapLog::read_message() {
  try {
    mcap::Message message;
    if (!messages_->next(message)) {
      ended_ = true;
      frames_->finish();
      return;
    }
    const LogChannel& channel = topics_.channels.at(message.channel);
    LogMessage decoded;
    decoded.where = channel.topic + ", message " + std::to_string(++message_counts_[message.channel]);
    decoded.log_time = time_of(message.time);
    decoded.validity = channel.validity;
    decoded.rectified = channel.rectified;
    try {
      decoded.message = channel.type->decode(message.data);
    } catch (const BadFootage& bad) {
      throw BadFootage(decoded.where + ": " + bad.what());
    }
    for (std::size_t i = 0; i + 1 < channel.uses.size(); ++i) {
      LogMessage copy = decoded;
      copy.content = channel.uses[i];
      frames_->add(std::move(copy));
    }
    decoded.content = channel.uses.back();
    frames_->add(std::move(decoded));
  } catch (const std::runtime_error& error) {  // damage, a bad message, or the disk
    ended_ = true;
    damage_ = error.what();
    frames_->finish();
  }
}

bool McapLog::next(FootageFrame& frame) {
  if (!failure_.empty()) throw BadFootage(failure_);
  try {
    while (!frames_->next(frame)) {
      if (!ended_) {
        read_message();
        continue;
      }
      if (!damage_.empty()) throw BadFootage(damage_);
      if (const std::string reason = frames_->reason_of_no_frame(); !reason.empty()) throw BadFootage(reason);
      return false;
    }
    return true;
  } catch (const BadFootage& bad) {
    failure_ = name_ + ": " + bad.what();
    throw BadFootage(failure_);
  }
}

}  // namespace reorient
