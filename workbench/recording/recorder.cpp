// SPDX-License-Identifier: MIT
#include "workbench/recording/recorder.h"

#include <array>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <exception>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <system_error>
#include <utility>

#include <unistd.h>

#include "engine/record/input_bytes.h"
#include "engine/record/record_bytes.h"
#include "geometry/image.h"
#include "workbench/recording/recording_file.h"
#include "workbench/run/batch_thread.h"
#include "workbench/views/viewer/viewer_messages.h"

namespace reorient {
namespace {

std::vector<ViewTopic> view_topics(const ApplicationInterface& application) {
  std::vector<ViewTopic> topics;
  topics.reserve(kViewerTopics.size());
  for (const ViewerTopicInfo& row : kViewerTopics) {
    topics.push_back({std::string(row.name), "json", std::string(row.schema), "jsonschema",
                      schema_text(row.schema, application), row.lasts});
  }
  return topics;
}

}  // namespace

struct Recorder::Item {
  FrameEntry entry;                 // without its digests, which the thread adds
  std::vector<std::size_t> places;  // positions of the topics in entry.record
  bool begins_file = false;
  std::vector<std::byte> state;  // of the engine before the frame; empty: not recorded
  std::array<bool, 2> is_viewed{};
  std::array<Image, 2> images;   // valid if entry.image_is_exact or is_viewed
  std::vector<std::byte> extra;  // write_record() of kViewedTopics
  bool has_wall = false;         // the wall is shown, which is larger than the rest of the room

  bool has_pixels(std::size_t camera) const { return entry.image_is_exact[camera] || is_viewed[camera]; }
  std::size_t bytes() const {
    std::size_t all = entry.inputs.size() + entry.record.size() + state.size() + extra.size();
    for (std::size_t camera = 0; camera < images.size(); ++camera)
      all += has_pixels(camera) ? images[camera].bytes().size() : 0;
    return all;
  }
};

struct Recorder::Shared {
  explicit Shared(const RecorderOptions& options)
      : first_file(options.file),
        about(options.about),
        topics(view_topics(options.application)),
        file(std::make_unique<RecordingFile>(options.file, options.about, topics)),
        lock_of_first(file->share_lock()),
        viewer(options.jpeg_quality) {}
  ~Shared() {
    if (lock_of_first >= 0) close(lock_of_first);
  }
  Shared(const Shared&) = delete;
  Shared& operator=(const Shared&) = delete;

  // Used by the thread only.
  const std::filesystem::path first_file;
  const mcap::Texts about;
  const std::vector<ViewTopic> topics;
  std::unique_ptr<RecordingFile> file;
  const int lock_of_first;  // while further parts are written, no other run may replace the first
  std::uint64_t earlier_bytes = 0, earlier_frames = 0;  // of earlier files
  ViewerMessages viewer;
  std::vector<ViewMessage> views;

  std::mutex mutex;  // protects all members below
  std::condition_variable wake, written, over;
  std::deque<std::unique_ptr<Item>> queue;
  std::vector<std::unique_ptr<Item>> free;
  std::size_t waiting = 0;  // bytes in the queue
  bool ends = false;
  bool is_over = false;          // the thread has ended
  std::uint64_t file_bytes = 0;  // of the file numbered counts.files, so far
  std::string trouble;           // why the recording ended
  Counts counts;
};

Recorder::Recorder(RecorderOptions options, std::function<void(const std::string&)> tell)
    : options_(std::move(options)),
      report_(std::move(tell)),
      shared_(std::make_shared<Shared>(options_)),
      thread_([shared = shared_] { write_items(*shared); }) {}

Recorder::~Recorder() { end(); }

void Recorder::before(const FrameInputs& inputs, const FrameLoop& engine) {
  std::size_t waiting = 0;
  std::uint64_t file_bytes = 0;
  {
    const std::lock_guard lock(shared_->mutex);
    item_.reset();
    if (shared_->trouble.empty() && !shared_->ends) {
      if (shared_->free.empty()) shared_->free.push_back(std::make_unique<Item>());
      item_ = std::move(shared_->free.back());
      shared_->free.pop_back();
    }
    waiting = shared_->waiting;
    if (shared_->counts.files == files_begun_) file_bytes = shared_->file_bytes;
  }
  wanted_ = {};
  if (!item_) return report_trouble();
  Item& item = *item_;
  const double now = engine.record().world.time;
  // If the disk is slow, first the images for viewers are omitted, then the exact images, before the recording ends.
  const bool is_slow = waiting > options_.most_waiting / 2;
  const bool has_views = options_.jpeg_quality > 0 && waiting <= options_.most_waiting / 4;
  const std::uint64_t frame = engine.record().world.frame;
  const bool has_images = options_.images_every > 0 && frame % static_cast<std::uint64_t>(options_.images_every) == 0;
  const std::optional<CameraFrame>* const cameras[] = {&inputs.observation.upper, &inputs.observation.lower};
  for (std::size_t camera = 0; camera < item.images.size(); ++camera) {
    const std::optional<CameraFrame>& seen = *cameras[camera];
    item.entry.has_image[camera] = seen && !seen->image.empty();
    item.entry.image_is_exact[camera] = item.entry.has_image[camera] && has_images && !is_slow;
    item.is_viewed[camera] = item.entry.has_image[camera] && has_views;
    if (item.has_pixels(camera)) {
      copy_pixels(seen->image, item.images[camera]);
    } else {
      item.images[camera] = Image();  // memory that bytes() does not count must be freed
    }
  }
  item.entry.inputs.clear();
  write_inputs_without_pixels(inputs, item.entry.inputs);
  item.state.clear();
  const bool begins_again = is_broken_ && options_.images_every == 1 && waiting < options_.most_waiting / 4;
  item.begins_file = frames_ > 0 && ((options_.rotate_bytes > 0 && file_bytes >= options_.rotate_bytes) ||
                                     (options_.rotate_seconds > 0.0 && now - file_began_ >= options_.rotate_seconds));
  if (frames_ == 0 || item.begins_file) file_began_ = now;
  files_begun_ += item.begins_file ? 1 : 0;
  if (frames_ == 0 || item.begins_file || now >= next_state_ || begins_again) {
    engine.save(item.state);
    next_state_ = now + options_.state_every;
    is_broken_ = false;
  }
  is_broken_ = is_broken_ || !item.entry.is_exact();
  choose_views(item);

  const bool sees = item.entry.has_image[0] || item.entry.has_image[1];
  const bool lacks_view = sees && options_.jpeg_quality > 0 && !has_views;
  const bool lacks_image = has_images && is_slow && !item.entry.is_exact();
  if (!lacks_view && !lacks_image) return;
  const std::lock_guard lock(shared_->mutex);
  Counts& counts = shared_->counts;
  counts.views_left_out += lacks_view ? 1 : 0;
  counts.images_left_out += lacks_image ? 1 : 0;
  if (lacks_image && counts.exact_until < 0.0) counts.exact_until = now;
}

void Recorder::choose_views(const Item& item) {
  const auto is_due = [this](std::uint64_t every) { return every > 0 && frames_ % every == 0; };
  const bool begins = !item.state.empty();
  wanted_ = {Topic::costs, Topic::feature_fits};
  if (is_due(static_cast<std::uint64_t>(options_.particles_every))) wanted_ = wanted_ | Topics{Topic::pose_particles};
  if (is_due(kConditionsEvery)) wanted_ = wanted_ | Topics{Topic::conditions};
  if (begins || is_due(kRoomEvery)) wanted_ = wanted_ | Topics{Topic::room};
  item_->has_wall = begins || is_due(kWallEvery);
  if (begins || is_due(kParametersEvery)) wanted_ = wanted_ | Topics{Topic::parameters};
  ++frames_;
}

void Recorder::observe(const FrameRecord& frame, const SceneTruth& scene) {
  if (!item_) return;
  take_frame(frame, scene, item_->entry, item_->places);
  item_->extra.clear();
  write_record(frame, item_->extra, wanted_);  // other observers may need more topics
  const std::size_t bytes = item_->bytes();
  bool is_slow = false, lacks_views = false;
  {
    const std::lock_guard lock(shared_->mutex);
    if (shared_->waiting + bytes > options_.most_waiting) {
      shared_->trouble = "the recording ends here: the disk is too slow";
      shared_->wake.notify_one();
      return;
    }
    is_slow = shared_->counts.images_left_out > 0;
    lacks_views = shared_->counts.views_left_out > 0;
    shared_->waiting += bytes;
    shared_->queue.push_back(std::move(item_));
  }
  shared_->wake.notify_one();
  if (lacks_views && !std::exchange(reported_missing_views_, true))
    report_("the disk or the processor is too slow for the recording: it lacks images for viewers");
  if (is_slow && !std::exchange(reported_slow_, true))
    report_(
        "the disk or the processor is too slow for the recording: it lacks exact images, so later frames cannot be "
        "replayed exactly");
}

void Recorder::report_trouble() {
  if (has_reported_) return;
  std::string trouble;
  {
    const std::lock_guard lock(shared_->mutex);
    trouble = shared_->trouble;
  }
  if (trouble.empty()) return;
  has_reported_ = true;
  report_(trouble);
}

bool Recorder::wait_for_thread(double seconds) {
  std::unique_lock lock(shared_->mutex);
  return shared_->written.wait_for(lock, std::chrono::duration<double>(seconds), [this] {
    return shared_->waiting <= options_.most_waiting / 8 || shared_->is_over;
  });
}

void Recorder::end() {
  if (!thread_.joinable()) return;
  bool is_over = false;
  {
    std::unique_lock lock(shared_->mutex);
    shared_->ends = true;
    shared_->wake.notify_one();
    is_over = shared_->over.wait_for(lock, std::chrono::duration<double>(options_.patience),
                                     [this] { return shared_->is_over; });
    if (!is_over && shared_->trouble.empty())
      shared_->trouble = "the recording lacks its end: the disk does not respond";
  }
  if (is_over) {
    thread_.join();
  } else {
    thread_.detach();
  }
  report_trouble();
}

Recorder::Counts Recorder::counts() const {
  const std::lock_guard lock(shared_->mutex);
  return shared_->counts;
}

/// Runs in the thread. It writes all queued data, also after an error in a frame.
void Recorder::write_items(Shared& shared) {
  become_batch_thread();
  int files = 1;
  bool is_gone = false;  // the last file: removed by this thread, or by another program
  const auto write = [&](Item& item) {
    if (item.begins_file) {
      std::filesystem::path name = shared.first_file;
      name.replace_extension("." + std::to_string(files + 1) + shared.first_file.extension().string());
      shared.file->finish();
      // The user did not name it, so it may belong to another run.
      auto next = std::make_unique<RecordingFile>(name, shared.about, shared.topics, RecordingFile::Existing::stays);
      shared.earlier_bytes += shared.file->size();
      shared.earlier_frames += shared.file->frames();
      shared.file = std::move(next);
      ++files;
    }
    digest_topics(item.entry.record, item.places, item.entry.digests);
    const FrameRecord frame = read_record(item.entry.record), extra = read_record(item.extra);
    ViewedFrame viewed{frame, extra, item.entry.scene, {}, !item.state.empty()};
    viewed.topics.set(static_cast<std::size_t>(ViewerTopic::wall), item.has_wall);
    for (std::size_t camera = 0; camera < item.images.size(); ++camera)
      if (item.is_viewed[camera]) viewed.images[camera] = item.images[camera].view();
    shared.views.clear();
    shared.viewer.add(viewed, [&](ViewerTopic topic, std::string_view message) {
      const auto bytes = std::as_bytes(std::span(message));
      shared.views.push_back(
          {static_cast<std::size_t>(topic), nanoseconds(item.entry.time), {bytes.begin(), bytes.end()}});
    });
    shared.file->add(item.entry, item.state, {item.images[0].view(), item.images[1].view()}, shared.views);
  };

  const auto count = [&] {
    shared.file_bytes = is_gone ? 0 : shared.file->size();
    shared.counts.bytes = shared.earlier_bytes + shared.file_bytes;
    shared.counts.frames = shared.earlier_frames + (is_gone ? 0 : shared.file->frames());
    shared.counts.files = files;
  };

  std::unique_lock lock(shared.mutex);
  while (true) {
    shared.wake.wait_for(lock, RecordingFile::kFlushEvery,
                         [&] { return !shared.queue.empty() || shared.ends || !shared.trouble.empty(); });
    std::unique_ptr<Item> item;
    if (!shared.queue.empty()) {
      item = std::move(shared.queue.front());
      shared.queue.pop_front();
    } else if (shared.ends || !shared.trouble.empty()) {
      break;
    }
    lock.unlock();
    std::string trouble;
    try {
      if (item) write(*item);
      shared.file->keep_up();
    } catch (const std::exception& error) {
      trouble = error.what();
    }
    lock.lock();
    count();
    if (item) {
      shared.waiting -= item->bytes();
      constexpr std::size_t kMostFree = 8;  // do not keep the memory of a backlog that is over
      if (shared.free.size() < kMostFree) shared.free.push_back(std::move(item));
      shared.written.notify_one();
    }
    if (trouble.empty()) continue;
    shared.trouble = "the recording ends here: " + trouble;
    shared.queue.clear();
    shared.waiting = 0;
  }
  lock.unlock();
  std::string trouble;
  try {
    shared.file->finish();
  } catch (const std::exception& error) {  // the data before it is readable
    trouble = "the recording lacks its end: ";
    trouble += error.what();
  }
  try {
    shared.file->require_in_place();
  } catch (const std::exception& error) {
    trouble = "the recording is lost: ";
    trouble += error.what();
    is_gone = true;
  }
  if (!is_gone && files > 1 && shared.file->frames() == 0) {  // an additional file without any frame
    std::error_code failed;
    is_gone = std::filesystem::remove(shared.file->path(), failed);
  }
  files -= is_gone && files > 1 ? 1 : 0;
  lock.lock();
  count();
  if (!trouble.empty() && shared.trouble.empty()) shared.trouble = std::move(trouble);
  shared.is_over = true;
  shared.written.notify_one();
  shared.over.notify_one();
}

}  // namespace reorient
