// SPDX-License-Identifier: MIT
#include "workbench/recording/rewriting.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/frame.h"
#include "workbench/files/atomic_file.h"
#include "workbench/recording/recording_file.h"
#include "workbench/recording/replay.h"

namespace reorient {
namespace {

class Copy {
 public:
  Copy(const Recording& recording, const std::filesystem::path& file)
      : beside_(file), file_(std::in_place, beside_.path(), recording.about(), recording.view_topics()) {}

  void add(const RecordedFrame& frame) {
    file_->add(frame.entry, frame.state, {frame.images[0].view(), frame.images[1].view()}, frame.views);
    if (done_.frames++ == 0) done_.first_time = frame.entry.time;
    done_.last_time = frame.entry.time;
  }

  Rewritten finish(const Recording::Losses& losses) {
    done_.losses = losses;
    file_->finish();
    file_.reset();
    beside_.end();
    return done_;
  }

 private:
  FileInTheMaking beside_;
  std::optional<RecordingFile> file_;
  Rewritten done_;
};

/// Stops at the first frame at or after a time, and stores the state of the engine before it and the last lasting
/// messages for viewers.
struct Beginning : Observer {
  Beginning(const Playback& source, const std::vector<ViewTopic>& view_topics, double begin)
      : playback(source), topics(view_topics), from(begin) {}

  void before(const FrameInputs& /*inputs*/, const FrameLoop& engine) override {
    if (frame) return;
    const RecordedFrame& now = playback.frame();
    for (const ViewMessage& view : now.views) {
      if (topics[view.topic].lasts) lasting[view.topic] = view;
    }
    if (now.entry.time < from) return;
    frame = now;
    if (frame->state.empty()) engine.save(frame->state);
    for (auto& [topic, view] : lasting) {
      const auto is_same = [topic = topic](const ViewMessage& other) { return other.topic == topic; };
      if (std::any_of(now.views.begin(), now.views.end(), is_same)) continue;
      view.time = nanoseconds(now.entry.time);
      frame->views.push_back(std::move(view));
    }
  }
  void observe(const FrameRecord& /*frame*/, const SceneTruth& /*scene*/) override {}

  const Playback& playback;
  const std::vector<ViewTopic>& topics;
  double from;                                 // s of the robot
  std::map<std::size_t, ViewMessage> lasting;  // by topic
  std::optional<RecordedFrame> frame;
};

std::optional<RecordedFrame> beginning_of(Recording& recording, double from) {
  Replay replay(recording, from);
  Beginning beginning(replay.playback(), recording.view_topics(), from);
  while (!beginning.frame && replay.next_stretch() != nullptr)
    replay.run({}, {&beginning}, [&] { return beginning.frame.has_value(); });
  return std::move(beginning.frame);
}

}  // namespace

Rewritten recover_recording(Recording& recording, const std::filesystem::path& file) {
  recording.require_this_format();
  recording.read_views();
  Copy copy(recording, file);
  RecordedFrame frame;
  while (recording.next(frame)) copy.add(frame);
  return copy.finish(recording.losses());
}

Rewritten cut_recording(Recording& recording, double from, double to, const std::filesystem::path& file, Views views) {
  if (views == Views::kept) recording.read_views();
  std::optional<RecordedFrame> first = beginning_of(recording, from);
  if (!first || first->entry.time > to)
    throw std::runtime_error(
        "no frame between these times can be replayed ('reorient recording info' lists those that can)");
  Copy copy(recording, file);
  copy.add(*first);
  const Recording::Losses before = recording.losses();
  Recording::Losses losses = before;
  RecordedFrame frame = std::move(*first);
  bool is_over = false;
  while (!(is_over = !recording.next(frame)) && frame.entry.time <= to) {
    copy.add(frame);
    losses = recording.losses();
  }
  if (is_over) losses = recording.losses();
  losses.frames -= before.frames;
  losses.images -= before.images;
  return copy.finish(losses);
}

}  // namespace reorient
