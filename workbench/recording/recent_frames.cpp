// SPDX-License-Identifier: MIT
#include "workbench/recording/recent_frames.h"

#include <array>
#include <exception>
#include <new>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include <zstd.h>

#include "engine/record/input_bytes.h"
#include "geometry/bytes.h"
#include "workbench/recording/byte_blocks.h"
#include "workbench/recording/packed_image.h"
#include "workbench/run/batch_thread.h"
#include "workbench/views/viewer/viewer_messages.h"

namespace reorient {
namespace {

constexpr int kLevel = 1;  // the fastest of zstd: the frames are kept for less than a minute

std::vector<std::byte> uncompressed(std::span<const std::byte> bytes) {
  std::vector<std::byte> all(ZSTD_getFrameContentSize(bytes.data(), bytes.size()));
  const std::size_t size = ZSTD_decompress(all.data(), all.size(), bytes.data(), bytes.size());
  check_bytes(ZSTD_isError(size) == 0 && size == all.size(), "a kept frame is damaged");
  return all;
}

}  // namespace

struct RecentFrames::Item {
  FrameEntry entry;  // without its digests, which the thread adds
  std::vector<std::size_t> places;
  std::vector<std::byte> state;  // empty: not taken before this frame
  std::array<Image, 2> images;
};

/// Immutable, so that a replay reads it while the run continues.
struct RecentFrames::PackedFrame {
  std::uint64_t frame = 0;
  double time = 0.0;
  ByteBlocks::Kept kept;                    // all that follows
  std::span<const std::byte> entry, state;  // compressed
  std::array<std::span<const std::byte>, 2> images;

  bool has_state() const { return !state.empty(); }
  std::size_t bytes() const { return sizeof(PackedFrame) + kept.bytes.size(); }
};

/// Compresses frames. Its memory is reused from frame to frame.
class RecentFrames::Packer {
 public:
  std::unique_ptr<PackedFrame> pack(const Item& item) {
    auto frame = std::make_unique<PackedFrame>();
    frame->frame = item.entry.frame;
    frame->time = item.entry.time;
    packed_.clear();
    plain_.clear();
    write_frame_entry(item.entry, plain_);
    std::array<std::size_t, 4> ends{compress(plain_), compress(item.state)};
    for (std::size_t camera = 0; camera < item.images.size(); ++camera) {
      plain_.clear();
      if (item.entry.has_image[camera]) pack_image(item.images[camera].view(), plain_);
      ends[2 + camera] = compress(plain_);
    }
    frame->kept = blocks_.keep(packed_);
    const auto part = [&](std::size_t i) {
      const std::size_t begin = i == 0 ? 0 : ends[i - 1];
      return frame->kept.bytes.subspan(begin, ends[i] - begin);
    };
    frame->entry = part(0);
    frame->state = part(1);
    frame->images = {part(2), part(3)};
    return frame;
  }

 private:
  /// Appends the compressed bytes to `packed_`, nothing for none. Returns where they end.
  std::size_t compress(std::span<const std::byte> bytes) {
    if (bytes.empty()) return packed_.size();
    if (!context_) throw std::bad_alloc();
    const std::size_t begin = packed_.size(), bound = ZSTD_compressBound(bytes.size());
    packed_.resize(begin + bound);
    const std::size_t size =
        ZSTD_compressCCtx(context_.get(), packed_.data() + begin, bound, bytes.data(), bytes.size(), kLevel);
    if (ZSTD_isError(size) != 0)
      throw std::runtime_error(std::string("compression with zstd failed: ") + ZSTD_getErrorName(size));
    packed_.resize(begin + size);
    return packed_.size();
  }

  struct Free {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
  };

  const std::unique_ptr<ZSTD_CCtx, Free> context_{ZSTD_createCCtx()};
  std::vector<std::byte> plain_, packed_;
  ByteBlocks blocks_;
};

class RecentFrames::Player : public FrameSource {
 public:
  explicit Player(std::deque<std::shared_ptr<const PackedFrame>> frames) : frames_(std::move(frames)) {}

  bool next(RecordedFrame& frame) override {
    if (at_ >= frames_.size()) return false;
    // Released when it was read, so that a slow replay does not keep more and more frames that the run has forgotten.
    const std::shared_ptr<const PackedFrame> kept = std::move(frames_[at_++]);
    const PackedFrame& packed = *kept;
    read_frame_entry(uncompressed(packed.entry), frame.entry);
    for (std::size_t camera = 0; camera < frame.images.size(); ++camera)
      if (!packed.images[camera].empty()) unpack_image(uncompressed(packed.images[camera]), frame.images[camera]);
    frame.state = packed.has_state() ? uncompressed(packed.state) : std::vector<std::byte>();
    frame.follows = last_ && *last_ + 1 == packed.frame;
    last_ = packed.frame;
    return true;
  }

  bool go_to(double time) override {
    std::optional<std::size_t> found;
    for (std::size_t i = 0; i < frames_.size(); ++i) {
      if (frames_[i] && frames_[i]->has_state() && (!found || frames_[i]->time <= time)) found = i;
    }
    if (!found) return false;
    for (std::size_t i = 0; i < *found; ++i) frames_[i].reset();
    at_ = *found;
    last_.reset();
    return true;
  }

  void add_damage(const RecordedFrame& frame, const std::string& what) override {
    throw BadBytes("frame " + std::to_string(frame.entry.frame) + ": " + what);
  }

 private:
  std::deque<std::shared_ptr<const PackedFrame>> frames_;  // nullptr: was read or passed
  std::size_t at_ = 0;
  std::optional<std::uint64_t> last_;
};

RecentFrames::RecentFrames(RecentFramesOptions options) : options_(options), thread_([this] { pack_items(); }) {}

RecentFrames::~RecentFrames() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  wake_.notify_one();
  thread_.join();
}

void RecentFrames::before(const FrameInputs& inputs, const FrameLoop& engine) {
  {
    const std::lock_guard lock(mutex_);
    item_.reset();
    if (waiting_.size() >= options_.most_waiting) {
      ++counts_.left_out;
      needs_state_ = true;
      return;
    }
    if (free_.empty()) {
      item_ = std::make_unique<Item>();
    } else {
      item_ = std::move(free_.back());
      free_.pop_back();
    }
  }
  Item& item = *item_;
  const std::optional<CameraFrame>* const cameras[] = {&inputs.observation.upper, &inputs.observation.lower};
  for (std::size_t camera = 0; camera < item.images.size(); ++camera) {
    const std::optional<CameraFrame>& seen = *cameras[camera];
    const bool has_image = seen && !seen->image.empty();
    item.entry.has_image[camera] = item.entry.image_is_exact[camera] = has_image;
    if (has_image) copy_pixels(seen->image, item.images[camera]);
  }
  item.entry.inputs.clear();
  write_inputs_without_pixels(inputs, item.entry.inputs);
  item.state.clear();
  const double now = engine.record().world.time;
  // A frame that was not shown, or a replay whose viewer seeks.
  const bool follows = last_frame_ && *last_frame_ == engine.record().world.frame;
  if (follows && !needs_state_ && now < next_state_) return;
  engine.save(item.state);
  next_state_ = now + options_.state_every;
  needs_state_ = false;
}

void RecentFrames::observe(const FrameRecord& frame, const SceneTruth& scene) {
  if (!item_) return;
  take_frame(frame, scene, item_->entry, item_->places);
  last_frame_ = frame.world.frame;
  {
    const std::lock_guard lock(mutex_);
    waiting_.push_back(std::move(item_));
  }
  wake_.notify_one();
}

/// Runs in the thread.
void RecentFrames::pack_items() {
  become_batch_thread(kLiveNiceness);
  Packer packer;
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
    if (ends_) return;
    std::unique_ptr<Item> item = std::move(waiting_.front());
    lock.unlock();
    std::shared_ptr<const PackedFrame> frame;
    try {
      digest_topics(item->entry.record, item->places, item->entry.digests);
      frame = packer.pack(*item);
    } catch (const std::exception&) {  // no memory is left; a replay continues with the next state
    }
    lock.lock();
    waiting_.pop_front();
    if (free_.size() < options_.most_waiting) free_.push_back(std::move(item));
    if (frame) {
      keep(std::move(frame));
    } else {
      ++counts_.left_out;
    }
  }
}

/// A replay begins with a state, so the frames up to the next one are forgotten together.
void RecentFrames::keep(std::shared_ptr<const PackedFrame> frame) {
  if (!kept_.empty() && frame->frame <= kept_.back()->frame) {  // a replay whose viewer seeks
    kept_.clear();
    counts_.bytes = 0;
  }
  counts_.bytes += frame->bytes();
  kept_.push_back(std::move(frame));
  const auto forget_first = [this] {
    counts_.bytes -= kept_.front()->bytes();
    kept_.pop_front();
  };
  while (counts_.bytes > options_.most_bytes && !kept_.empty()) {
    forget_first();
    while (!kept_.empty() && !kept_.front()->has_state()) forget_first();
  }
  counts_.frames = kept_.size();
  if (kept_.empty()) return;
  counts_.begin = kept_.front()->time;
  counts_.end = kept_.back()->time;
}

std::unique_ptr<FrameSource> RecentFrames::frames() const {
  const std::lock_guard lock(mutex_);
  return std::make_unique<Player>(kept_);
}

RecentFrames::Counts RecentFrames::counts() const {
  const std::lock_guard lock(mutex_);
  return counts_;
}

}  // namespace reorient
