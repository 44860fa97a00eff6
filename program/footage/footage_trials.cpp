// SPDX-License-Identifier: MIT
#include "program/footage/footage_trials.h"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "engine/parameters/counted.h"
#include "engine/record/digest.h"
#include "engine/script/script_texts.h"
#include "geometry/bytes.h"
#include "workbench/run/run_loop.h"

namespace reorient {
namespace {

class MemorySource : public FootageSource {
 public:
  explicit MemorySource(std::shared_ptr<const std::vector<FootageFrame>> frames) : frames_(std::move(frames)) {}
  bool next(FootageFrame& frame) override {
    if (next_ == frames_->size()) return false;
    frame = (*frames_)[next_++];
    return true;
  }

 private:
  std::shared_ptr<const std::vector<FootageFrame>> frames_;
  std::size_t next_ = 0;
};

/// Keeps the engine's state before each start.
class StartStates : public Observer {
 public:
  explicit StartStates(std::vector<FootageTrials::Start>& starts) : starts_(starts) {}

  void before(const FrameInputs& inputs, const FrameLoop& engine) override {
    if (next_ == starts_.size() || frame_++ != starts_[next_].frame) return;
    starts_[next_].time = inputs.observation.time;
    engine.save(starts_[next_++].state);
  }
  void observe(const FrameRecord& frame, const SceneTruth& /*scene*/) override {
    const RoomStatus status = frame.world.room_status;
    if (!room_learned_at_ && (status == RoomStatus::usable || status == RoomStatus::symmetric))
      room_learned_at_ = frame.world.time;
  }
  std::optional<double> room_learned_at() const { return room_learned_at_; }
  bool are_all_kept() const { return next_ == starts_.size(); }

 private:
  std::vector<FootageTrials::Start>& starts_;
  std::size_t next_ = 0;
  std::size_t frame_ = 0;
  std::optional<double> room_learned_at_;
};

}  // namespace

FootageInMemory::FootageInMemory(FootageSource& source) {
  constexpr std::size_t kMost = std::size_t{4} << 30;  // bytes
  auto frames = std::make_shared<std::vector<FootageFrame>>();
  std::size_t bytes = 0;
  for (FootageFrame frame; source.next(frame);) {
    bytes += frame.image.bytes().size();
    if (bytes > kMost)
      throw BadFootage(
          fmt::format("expected images of at most {} MB altogether, found more after {}; make them "
                      "smaller, or fewer",
                      kMost >> 20, counted(frames->size(), "image")));
    frames->push_back(std::move(frame));
  }
  frames_ = std::move(frames);
}

std::unique_ptr<FootageSource> FootageInMemory::source() const { return std::make_unique<MemorySource>(frames_); }

FootageTrials::FootageTrials(const FootageSetup& setup, const FootageTrialOptions& options, PreparedFootage prepared)
    : setup_(setup),
      options_(options),
      footage_(*open_footage(setup.source, setup.footage, prepared.frame.body)),
      body_(prepared.frame.body),
      wall_(std::move(prepared.wall)) {
  FrameSetup& frame = prepared.frame;
  const auto knows_no_pose = [](const FootageFrame& one) { return !one.pose && !one.heading; };
  const auto& frames = footage_.frames();
  if (const auto lost = std::find_if(frames.begin(), frames.end(), knows_no_pose); lost != frames.end())
    throw BadFootage(setup.source.string() +
                     ": expected a pose with each image, since trials are judged by it, found none with image " +
                     lost->name);
  choose_starts();
  Digest digest;
  digest.add(std::string_view(REORIENT_VERSION));
  for (const FootageFrame& one : frames) {
    std::vector<std::byte> bytes;
    ByteWriter out(bytes);
    out(one.time, one.camera, one.robot_from_camera, one.torso, one.pose, one.odometry, one.heading);
    digest.add(bytes);
    digest.add(std::as_bytes(std::span(one.image.bytes())));
  }
  std::vector<std::byte> bytes;
  ByteWriter out(bytes);
  out(frame.field, frame.body, frame.seed, frame.room_awareness, frame.behaviors, frame.parameters,
      setup.footage.images_per_second, options.starts, options.learn, options.watch, options.hold, options.turned_by);
  digest.add(bytes);
  digest.add(content_hash(frame.scripts));
  origin_ = digest.value();
  live_through(std::move(frame));
}

std::vector<double> FootageTrials::times() const {
  std::vector<double> times;
  times.reserve(footage_.size());
  const auto& frames = footage_.frames();
  for (std::size_t i = 0; i < frames.size(); ++i)
    times.push_back(setup_.footage.images_per_second ? static_cast<double>(i) / *setup_.footage.images_per_second
                                                     : frames[i].time - frames.front().time);
  return times;
}

void FootageTrials::choose_starts() {
  const std::vector<double> all = times();
  const double needed = options_.watch + options_.hold;
  const auto first = std::lower_bound(all.begin(), all.end(), options_.learn);
  const auto last = std::upper_bound(first, all.end(), all.empty() ? 0.0 : all.back() - needed);
  const auto candidates = static_cast<std::size_t>(last - first), wanted = static_cast<std::size_t>(options_.starts);
  if (candidates < wanted)
    throw std::runtime_error(fmt::format(
        "{}: expected {} at which a trial can start, found {}: {:.1f} s are learned before, {:.1f} s watched "
        "behind, and the footage lasts {:.1f} s",
        setup_.source.string(), counted(wanted, "image"), candidates, options_.learn, needed,
        all.empty() ? 0.0 : all.back()));
  for (std::size_t i = 0; i < wanted; ++i) {
    const std::size_t frame = static_cast<std::size_t>(first - all.begin()) + i * candidates / wanted;
    starts_.push_back({frame, footage_.frames()[frame].name, all[frame], {}});
  }
}

void FootageTrials::live_through(FrameSetup frame) {
  FrameLoop engine(std::move(frame));
  auto robot = std::make_unique<FootageRobot>(footage_.source(), robot_options_of(setup_));
  RobotInstance instance{std::move(robot), body_, RobotInstance::Clock::simulated, nullptr, nullptr};
  StartStates states(starts_);
  RunParts parts{instance, engine, nullptr, nullptr, {}, {&states}, [&] { return states.are_all_kept(); }, 0.0, false};
  RunLoop(std::move(parts)).run();
  room_learned_at_ = states.room_learned_at();
}

TrialResult FootageTrials::run(std::size_t start, const FootageCase& one) const {
  const Start& from = starts_[start];
  FrameLoop engine(std::span<const std::byte>(from.state));
  FootageOptions options = robot_options_of(setup_);
  options.skipped = from.frame;
  options.change = one.change;
  options.change->at = from.time;
  auto robot = std::make_unique<FootageRobot>(footage_.source(), options);
  const GroundTruthSource* const truth = robot.get();
  RobotInstance instance{std::move(robot), body_, RobotInstance::Clock::simulated, nullptr, truth};
  Measurement measurement;
  measurement.limit = options_.watch;
  measurement.hold = options_.hold;
  TrialObserver observer(measurement);
  RunParts parts{instance, engine, nullptr, nullptr, {}, {&observer}, [&] { return observer.is_over(); }, 0.0, false};
  RunLoop(std::move(parts)).run();
  TrialResult result = observer.result();
  result.seed = start + 1;
  return result;
}

int FootageTrials::images_within(std::size_t start, double seconds) const {
  constexpr double kTolerance = 1e-6;  // s
  const std::vector<double> all = times();
  const auto first = all.begin() + static_cast<std::ptrdiff_t>(starts_[start].frame);
  return static_cast<int>(std::upper_bound(first, all.end(), starts_[start].time + seconds + kTolerance) - first);
}

}  // namespace reorient
