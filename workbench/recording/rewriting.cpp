#include "workbench/recording/rewriting.h"

#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

#include "engine/frame.h"
#include "workbench/recording/packed_image.h"
#include "workbench/recording/playback.h"
#include "workbench/recording/recording_file.h"

namespace reorient {
namespace {

class Copy {
 public:
  Copy(const std::filesystem::path& file, const mcap::Texts& about) : file_(file, about) {}

  void add(const RecordedFrame& frame, std::span<const std::byte> state) {
    const std::uint64_t time = nanoseconds(frame.entry.time);
    if (!state.empty()) file_.add(file_.states(), time, state);
    for (std::size_t camera = 0; camera < frame.images.size(); ++camera) {
      if (!frame.entry.image_is_exact[camera]) continue;
      const UnpackedImage& image = frame.images[camera];
      bytes_.clear();
      pack_image({image.yuyv.data(), image.width, image.height, 2 * image.width}, bytes_);
      file_.add(file_.images(camera), time, bytes_);
    }
    bytes_.clear();
    write_frame_entry(frame.entry, bytes_);
    file_.add(file_.frames(), time, bytes_);
    if (done_.frames++ == 0) done_.first_time = frame.entry.time;
    done_.last_time = frame.entry.time;
  }

  Rewritten finish() {
    file_.finish();
    return done_;
  }

 private:
  RecordingFile file_;
  std::vector<std::byte> bytes_;
  Rewritten done_;
};

/// The first frame from `from` on, with the state of the engine before it. False: there is none.
bool find_beginning(Recording& recording, double from, RecordedFrame& frame) {
  Playback playback(recording, from);
  if (!playback.next_stretch()) return false;
  FrameLoop engine(playback.state());
  FrameInputs inputs;
  while (playback.observe(inputs.observation)) {
    if (playback.frame().entry.time >= from) {
      frame = playback.frame();
      if (frame.state.empty()) engine.save(frame.state);
      const std::optional<CameraFrame>* const cameras[] = {&inputs.observation.upper, &inputs.observation.lower};
      for (std::size_t camera = 0; camera < frame.images.size(); ++camera) {
        if (!frame.entry.image_is_exact[camera]) continue;
        const ImageView& image = (*cameras[camera])->image;
        frame.images[camera].yuyv.assign(image.data,
                                         image.data + static_cast<std::ptrdiff_t>(image.stride) * image.height);
      }
      return true;
    }
    playback.add_to(inputs);
    engine.step(inputs);
  }
  // A gap before it: the next stretch begins with a state of its own.
  if (!playback.next_stretch()) return false;
  frame = playback.frame();
  return true;
}

}  // namespace

Rewritten recover_recording(Recording& recording, const std::filesystem::path& file) {
  Copy copy(file, recording.about());
  RecordedFrame frame;
  while (recording.next(frame)) copy.add(frame, frame.state);
  return copy.finish();
}

Rewritten cut_recording(Recording& recording, double from, double to, const std::filesystem::path& file) {
  RecordedFrame frame;
  if (!find_beginning(recording, from, frame) || frame.entry.time > to)
    throw std::runtime_error(
        "no frame between these times can be made again; 'reorient recording info' says which can");
  Copy copy(file, recording.about());
  copy.add(frame, frame.state);
  while (recording.next(frame) && frame.entry.time <= to) copy.add(frame, frame.state);
  return copy.finish();
}

}  // namespace reorient
