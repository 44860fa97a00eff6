#include "workbench/recording/rewriting.h"

#include <optional>
#include <stdexcept>
#include <utility>

#include "engine/frame.h"
#include "workbench/recording/recording_file.h"
#include "workbench/recording/replay.h"

namespace reorient {
namespace {

class Copy {
 public:
  Copy(const std::filesystem::path& file, const mcap::Texts& about) : file_(file, about) {}

  void add(const RecordedFrame& frame) {
    file_.add(frame.entry, frame.state, {frame.images[0].view(), frame.images[1].view()});
    if (done_.frames++ == 0) done_.first_time = frame.entry.time;
    done_.last_time = frame.entry.time;
  }

  Rewritten finish() {
    file_.finish();
    return done_;
  }

 private:
  RecordingFile file_;
  Rewritten done_;
};

/// Stops at the first frame from a time on, with the state of the engine before it.
struct Beginning : Observer {
  Beginning(const Playback& source, double begin) : playback(source), from(begin) {}

  void before(const FrameInputs& /*inputs*/, const FrameLoop& engine) override {
    if (frame || playback.frame().entry.time < from) return;
    frame = playback.frame();
    if (frame->state.empty()) engine.save(frame->state);
  }
  void observe(const FrameRecord& /*frame*/, const StageRecord& /*stage*/) override {}

  const Playback& playback;
  double from;  // s of the robot
  std::optional<RecordedFrame> frame;
};

std::optional<RecordedFrame> beginning_of(Recording& recording, double from) {
  Replay replay(recording, from);
  Beginning beginning(replay.playback(), from);
  while (!beginning.frame && replay.next_stretch() != nullptr)
    replay.run({}, {&beginning}, [&] { return beginning.frame.has_value(); });
  return std::move(beginning.frame);
}

}  // namespace

Rewritten recover_recording(Recording& recording, const std::filesystem::path& file) {
  Copy copy(file, recording.about());
  RecordedFrame frame;
  while (recording.next(frame)) copy.add(frame);
  return copy.finish();
}

Rewritten cut_recording(Recording& recording, double from, double to, const std::filesystem::path& file) {
  std::optional<RecordedFrame> first = beginning_of(recording, from);
  if (!first || first->entry.time > to)
    throw std::runtime_error(
        "no frame between these times can be made again; 'reorient recording info' says which can");
  Copy copy(file, recording.about());
  copy.add(*first);
  RecordedFrame frame = std::move(*first);
  while (recording.next(frame) && frame.entry.time <= to) copy.add(frame);
  return copy.finish();
}

}  // namespace reorient
