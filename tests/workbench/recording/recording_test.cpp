// SPDX-License-Identifier: MIT
// A recorded run is replayed bit by bit from its file only.
#include <algorithm>
#include <array>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "engine/record/record_bytes.h"
#include "geometry/random.h"
#include "tests/engine/eventful_run.h"
#include "tests/temporary_folder.h"
#include "tests/waiting.h"
#include "tests/workbench/recording/replayed.h"
#include "workbench/files/input_file.h"
#include "workbench/recording/packed_image.h"
#include "workbench/recording/recorder.h"

namespace reorient {
namespace {

constexpr int kFrames = 600;

const std::vector<Bytes>& run() {
  static const std::vector<Bytes> all = eventful_run(kFrames);
  return all;
}

class RecordedRun : public testing::Test {
 protected:
  RecorderOptions options() const {
    RecorderOptions options;
    options.file = folder_.path() / "run.mcap";
    options.state_every = 5.0;
    options.about = {{"version", "test"}};
    return options;
  }

  /// The digests of the run. With options, the run is recorded.
  std::string record(const std::optional<RecorderOptions>& options) {
    std::optional<Recorder> recorder;
    if (options) recorder.emplace(*options, [this](const std::string& line) { reports_.push_back(line); });
    FrameLoop engine(eventful_setup());
    RecordDigest digest;
    SceneTruth scene;
    std::uint64_t given = 0;
    for (const Bytes& bytes : run()) {
      const StoredInputs stored(bytes);
      const FrameInputs& inputs = stored.inputs();
      if (recorder) recorder->before(inputs, engine);
      const FrameRecord& frame =
          engine.step(inputs, Topics{Topic::images} | (recorder ? recorder->wanted() : Topics()));
      scene.truth = GroundTruth{Pose2(0.001 * static_cast<double>(frame.world.frame), 0.0, 0.0), false, false};
      if (recorder) {
        recorder->observe(frame, scene);
        // Frames come faster than on a robot, so the thread of the recorder may be delayed.
        constexpr std::uint64_t kMostBehind = 60;
        ++given;
        await([&] { return !reports_.empty() || recorder->counts().frames + kMostBehind >= given; });
      }
      digest.add(frame);
    }
    if (recorder) {
      recorder->end();
      counts_ = recorder->counts();
    }
    return digest.digest().hex();
  }

  Replayed replayed(double from = 0.0, InputSource* what_if = nullptr) const { return replay(file(), from, what_if); }

  std::filesystem::path file() const { return folder_.path() / "run.mcap"; }

  TemporaryFolder folder_;
  std::vector<std::string> reports_;
  Recorder::Counts counts_;
};

TEST_F(RecordedRun, EqualsAnUnrecordedRunAndIsReplayedFrameByFrame) {
  const std::string digest = record(std::nullopt);
  EXPECT_EQ(record(options()), digest);
  EXPECT_EQ(counts_.frames, static_cast<std::uint64_t>(kFrames));
  EXPECT_EQ(counts_.images_left_out, 0u);
  EXPECT_TRUE(reports_.empty());
  const Replayed again = replayed();
  EXPECT_EQ(again.frames, static_cast<std::uint64_t>(kFrames));
  EXPECT_EQ(again.different, 0u);
  EXPECT_EQ(again.stretches, 1u);
  EXPECT_EQ(again.digest, digest);
}

/// A few frames do not fill a chunk. They still reach the file, while the recorder waits for the next frame.
TEST_F(RecordedRun, IsInItsFileIfNoFrameFollows) {
  constexpr std::size_t kFew = 5;
  Recorder recorder(options(), [this](const std::string& line) { reports_.push_back(line); });
  FrameLoop engine(eventful_setup());
  for (std::size_t i = 0; i < kFew; ++i) {
    const StoredInputs stored(run().at(i));
    recorder.before(stored.inputs(), engine);
    recorder.observe(engine.step(stored.inputs(), Topics{Topic::images} | recorder.wanted()), {});
  }
  const auto frames_in_file = [this] {
    std::size_t frames = 0;
    try {
      Recording recording(file());
      for (RecordedFrame frame; recording.next(frame);) ++frames;
    } catch (const std::runtime_error&) {  // the head of the file is not written yet
    }
    return frames;
  };
  EXPECT_TRUE(await([&] { return frames_in_file() == kFew; })) << frames_in_file();
  EXPECT_TRUE(reports_.empty());
}

TEST_F(RecordedRun, CanBeReplayedFromAnyOfItsStates) {
  record(options());
  for (const double from : {0.0, 4.9, 5.1, 9.0, 11.0, 1e9}) {
    const Replayed again = replayed(from);
    EXPECT_EQ(again.different, 0u) << from;
    const int states = std::min(static_cast<int>(from / 5.0), 3);
    EXPECT_NEAR(static_cast<double>(again.frames), kFrames - 150.0 * states, 3.0) << from;
  }
}

TEST_F(RecordedRun, ThatWasTruncatedIsReplayedUpToItsEnd) {
  record(options());
  const auto size = static_cast<double>(std::filesystem::file_size(file()));
  std::uint64_t before = 1000;
  for (const double share : {0.9, 0.5, 0.2}) {
    std::filesystem::resize_file(file(), static_cast<std::uintmax_t>(share * size));
    const Replayed again = replayed();
    EXPECT_EQ(again.different, 0u);
    EXPECT_EQ(again.damages.size(), 1u);
    EXPECT_GT(again.frames, 0u);
    EXPECT_LT(again.frames, before);
    before = again.frames;
  }
}

TEST_F(RecordedRun, ContinuesAtTheNextStateAfterDamage) {
  record(options());
  {
    const mcap::FileSource source(file());
    const std::vector<mcap::ChunkPlace> chunks = mcap::read_contents(source).chunks;
    // States are at 5 and 10 s. The ends of chunks depend on time: if a chunk ends at a state, no frame is skipped.
    constexpr std::uint64_t kBetween = 7'500'000'000;
    const auto chunk = std::find_if(chunks.rbegin(), chunks.rend(),
                                    [](const mcap::ChunkPlace& place) { return place.end_time < kBetween; });
    ASSERT_NE(chunk, chunks.rend());
    std::fstream damaged(file(), std::ios::in | std::ios::out | std::ios::binary);
    damaged.seekp(static_cast<std::streamoff>(chunk->data));
    damaged << "this is no chunk";
  }
  const Replayed again = replayed();
  EXPECT_EQ(again.different, 0u);
  // The lost chunk, and the frame whose image was in it while the frame itself is in the next chunk.
  EXPECT_GE(again.damages.size(), 1u);
  EXPECT_LE(again.damages.size(), 2u);
  EXPECT_EQ(again.stretches, 2u);
  EXPECT_GT(again.skipped, 0u);
  EXPECT_LT(again.frames, static_cast<std::uint64_t>(kFrames));
}

TEST_F(RecordedRun, IsReadOnBehindADamageAnywhere) {
  // A frame may be split between two chunks, one of which is lost. A damaged index loses no frame.
  record(options());
  const std::string whole = read_input(file(), "a file");
  Random random(5);
  int lossy = 0;
  for (int i = 0; i < 60; ++i) {
    std::string damaged = whole;
    const std::size_t place = 5000 + random.below(whole.size() / 2);
    damaged.replace(place, 16, "this is no chunk");
    Recording recording(std::make_unique<mcap::MemorySource>(std::as_bytes(std::span(damaged))));
    RecordedFrame frame;
    int frames = 0;
    ASSERT_NO_THROW({
      while (recording.next(frame)) ++frames;
    }) << "damaged at byte "
       << place;
    EXPECT_GT(frames, kFrames / 2) << "damaged at byte " << place;
    EXPECT_TRUE(frames == kFrames || !recording.damages().empty()) << "damaged at byte " << place;
    lossy += frames < kFrames;
  }
  EXPECT_GT(lossy, 30);
}

/// An erased block of a flash memory destroys even the head of a chunk.
TEST_F(RecordedRun, IsReadAfterEachChunkThatIsLostWithItsHead) {
  record(options());
  const std::string whole = read_input(file(), "a file");
  std::vector<std::size_t> heads;
  {
    const Recording recording(file());
    for (const mcap::ChunkPlace& chunk : recording.contents().chunks) heads.push_back(chunk.where);
  }
  ASSERT_GT(heads.size(), 5u);
  const auto read_without = [&](std::size_t first, std::size_t second) {
    std::string damaged = whole;
    for (const std::size_t head : {heads[first], heads[second]}) damaged.replace(head, 16, "this is no chunk");
    SCOPED_TRACE(std::to_string(first) + " and " + std::to_string(second));
    Recording recording(std::make_unique<mcap::MemorySource>(std::as_bytes(std::span(damaged))));
    RecordedFrame frame;
    std::uint64_t last = 0;
    int frames = 0, gaps = 0;
    ASSERT_NO_THROW({
      while (recording.next(frame)) {
        if (frames++ > 0) {
          EXPECT_GT(frame.entry.frame, last);
          EXPECT_EQ(frame.follows, frame.entry.frame == last + 1);
          gaps += frame.follows ? 0 : 1;
        }
        last = frame.entry.frame;
      }
    });
    EXPECT_LT(frames, kFrames);
    EXPECT_GT(frames, 0);
    EXPECT_LE(gaps, first == second ? 1 : 2);
    EXPECT_FALSE(recording.damages().empty());
  };
  for (std::size_t i = 0; i < heads.size(); ++i) read_without(i, i);
  for (std::size_t i = 0; i + 1 < heads.size(); ++i) read_without(i, i + 1);
  for (std::size_t i = 0; i + 2 < heads.size(); i += 2) read_without(i, i + 2);
}

TEST_F(RecordedRun, WithRotationIsManyRecordingsThatCanAllBeReplayed) {
  RecorderOptions rotated = options();
  rotated.rotate_seconds = 6.0;
  record(rotated);
  EXPECT_EQ(counts_.files, 4);
  std::uint64_t frames = 0;
  for (const char* const name : {"run.mcap", "run.2.mcap", "run.3.mcap", "run.4.mcap"}) {
    const Replayed again = replay(folder_.path() / name);
    EXPECT_EQ(again.different, 0u) << name;
    EXPECT_EQ(again.stretches, 1u) << name;
    EXPECT_TRUE(again.damages.empty()) << name;
    frames += again.frames;
  }
  EXPECT_EQ(frames, static_cast<std::uint64_t>(kFrames));
  rotated.rotate_seconds = 0.0;
  rotated.rotate_bytes = 1;  // a new file after each write to the disk
  rotated.file = folder_.path() / "small.mcap";
  record(rotated);
  EXPECT_GT(counts_.files, 1);
}

TEST_F(RecordedRun, WithoutImagesCanBeReadButNotReplayed) {
  RecorderOptions without = options();
  without.images_every = 0;
  record(without);
  EXPECT_EQ(replayed().frames, 0u);
  Recording recording(file());
  RecordedFrame frame;
  int frames = 0;
  while (recording.next(frame)) {
    EXPECT_FALSE(frame.entry.is_exact());
    EXPECT_EQ(read_record(frame.entry.record).world.frame, frame.entry.frame);
    ++frames;
  }
  EXPECT_EQ(frames, kFrames);
}

struct OneChange : InputSource {
  explicit OneChange(ParameterChange what) : change(std::move(what)) {}
  void add_to(FrameInputs& inputs) override {
    if (!std::exchange(is_done, true)) inputs.parameter_changes.push_back(change);
  }
  ParameterChange change;
  bool is_done = false;
};

TEST_F(RecordedRun, ReportsTheFirstDifference) {
  record(options());
  OneChange change({"head_scan.speed", "0.5", ParameterOrigin::live, ""});
  const Replayed again = replayed(0.0, &change);
  ASSERT_TRUE(again.first_action);
  EXPECT_EQ(again.first_action->what, "head (yaw, pitch in rad, rad/s)");
  EXPECT_NE(again.first_action->recorded, again.first_action->replayed);
  EXPECT_GT(again.different, 0u);
}

TEST_F(RecordedRun, ContinuesWithoutARecordingOnAFullDisk) {
  std::signal(SIGPIPE, SIG_IGN);  // as the program does
  // A pipe without a reader simulates it.
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  const int reader = open(file().c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  RecorderOptions slow = options();
  slow.most_waiting = 4u << 20;
  std::optional<Recorder> recorder;
  recorder.emplace(slow, [this](const std::string& line) { reports_.push_back(line); });
  FrameLoop engine(eventful_setup());
  for (const Bytes& bytes : run()) {  // would not end if a frame waited for the disk
    const StoredInputs stored(bytes);
    recorder->before(stored.inputs(), engine);
    recorder->observe(engine.step(stored.inputs()), {});
  }
  // First the images for viewers are omitted, then the exact images, then everything.
  ASSERT_EQ(reports_.size(), 3u);
  EXPECT_NE(reports_[0].find("it lacks images for viewers"), std::string::npos) << reports_[0];
  EXPECT_NE(reports_[1].find("cannot be replayed exactly"), std::string::npos) << reports_[1];
  EXPECT_NE(reports_[2].find("the recording ends here: the disk is too slow"), std::string::npos) << reports_[2];
  EXPECT_GT(recorder->counts().images_left_out, 0u);
  EXPECT_GT(recorder->counts().views_left_out, recorder->counts().images_left_out);
  close(reader);  // now writing fails, and the thread ends
  recorder.reset();
}

constexpr double kPatience = 60.0;  // s, of a test whose computer is busy

TEST_F(RecordedRun, LetsARobotWithoutRealTimeWaitForTheDiskButNotForever) {
  std::signal(SIGPIPE, SIG_IGN);
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  const int reader = open(file().c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  RecorderOptions slow = options();
  slow.most_waiting = 4u << 20;
  Recorder recorder(slow, [this](const std::string& line) { reports_.push_back(line); });
  EXPECT_TRUE(recorder.wait_for_thread(0.0)) << "there is nothing to write yet";
  FrameLoop engine(eventful_setup());
  bool is_behind = false;
  for (const Bytes& bytes : run()) {
    const StoredInputs stored(bytes);
    recorder.before(stored.inputs(), engine);
    recorder.observe(engine.step(stored.inputs()), {});
    is_behind = is_behind || !recorder.wait_for_thread(0.0);
  }
  EXPECT_TRUE(is_behind);
  EXPECT_FALSE(recorder.wait_for_thread(0.0)) << "the disk does not respond";
  close(reader);  // now writing fails, and the thread ends
  EXPECT_TRUE(recorder.wait_for_thread(kPatience));
}

TEST_F(RecordedRun, IsNotReplacedByASecondRunUntilItsEnd) {
  RecorderOptions parts = options();
  parts.rotate_seconds = 5.0;
  std::optional<Recorder> first(std::in_place, parts, [](const std::string& line) { ADD_FAILURE() << line; });
  FrameLoop engine(eventful_setup());
  const auto step = [&](const Bytes& bytes) {
    const StoredInputs stored(bytes);
    first->before(stored.inputs(), engine);
    first->observe(engine.step(stored.inputs()), {});
  };
  for (int i = 0; i < 200; ++i) step(run()[static_cast<std::size_t>(i)]);
  // Also while a further part is written.
  ASSERT_TRUE(await([&] { return std::filesystem::exists(folder_.path() / "run.2.mcap"); }));
  for (const char* name : {"run.mcap", "run.2.mcap"}) {
    RecorderOptions second = options();
    second.file = folder_.path() / name;
    try {
      const Recorder recorder(second, [](const std::string&) {});
      ADD_FAILURE() << name << " is replaced";
    } catch (const std::runtime_error& error) {
      EXPECT_EQ(std::string(error.what()), (folder_.path() / name).string() +
                                               ": expected a file that no other process writes, found a recording in "
                                               "progress; name another file");
    }
  }
  first->end();
  const Recorder::Counts counts = first->counts();
  EXPECT_EQ(counts.frames, 200u);
  EXPECT_EQ(counts.files, 2);
  first.reset();
  int frames = 0;
  for (const char* name : {"run.mcap", "run.2.mcap"}) {
    Recording recording(folder_.path() / name);
    for (RecordedFrame frame; recording.next(frame);) ++frames;
  }
  EXPECT_EQ(frames, 200);
  const Recorder again(options(), [](const std::string&) {});  // the lock ends with the recorder
}

TEST_F(RecordedRun, IsReportedAsLostIfItsFileWasRemoved) {
  std::optional<Recorder> recorder(std::in_place, options(),
                                   [this](const std::string& line) { reports_.push_back(line); });
  FrameLoop engine(eventful_setup());
  for (int i = 0; i < 30; ++i) {
    const StoredInputs stored(run()[static_cast<std::size_t>(i)]);
    recorder->before(stored.inputs(), engine);
    recorder->observe(engine.step(stored.inputs()), {});
  }
  std::filesystem::remove(file());
  folder_.write("run.mcap", "another program's");
  recorder->end();
  ASSERT_EQ(reports_.size(), 1u);
  EXPECT_EQ(reports_[0], "the recording is lost: " + file().string() +
                             ": expected the recording of this run, found that another program removed, replaced or "
                             "changed the file");
  EXPECT_EQ(recorder->counts().frames, 0u);
  EXPECT_EQ(recorder->counts().bytes, 0u);
  EXPECT_EQ(read_input(file(), "a file"), "another program's");
}

TEST_F(RecordedRun, DoesNotOverwriteAFileWithTheNameOfAFurtherPart) {
  folder_.write("run.2.mcap", "a part of another run");
  RecorderOptions parts = options();
  parts.rotate_seconds = 5.0;
  record(parts);
  ASSERT_EQ(reports_.size(), 1u);
  EXPECT_NE(reports_[0].find("the recording ends here: "), std::string::npos) << reports_[0];
  EXPECT_NE(reports_[0].find("run.2.mcap: the file cannot be written: File exists"), std::string::npos) << reports_[0];
  EXPECT_EQ(read_input(folder_.path() / "run.2.mcap", "a file"), "a part of another run");
  EXPECT_EQ(counts_.files, 1);
  EXPECT_GT(counts_.frames, 100u);
}

TEST_F(RecordedRun, OnADiskThatHangsEndsTheFileAfterItsRecorderIsDestroyed) {
  std::signal(SIGPIPE, SIG_IGN);
  ASSERT_EQ(mkfifo(file().c_str(), 0600), 0);
  const int reader = open(file().c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  {
    RecorderOptions hasty = options();
    hasty.patience = 0.05;
    FrameLoop engine(eventful_setup());
    Recorder recorder(hasty, [this](const std::string& line) { reports_.push_back(line); });
    for (const Bytes& bytes : run()) {
      const StoredInputs stored(bytes);
      recorder.before(stored.inputs(), engine);
      recorder.observe(engine.step(stored.inputs()), {});
    }
  }
  ASSERT_FALSE(reports_.empty());
  EXPECT_NE(reports_.back().find("the recording lacks its end"), std::string::npos) << reports_.back();
  const std::size_t lines = reports_.size();
  // Now the disk responds.
  std::string taken;
  ASSERT_EQ(fcntl(reader, F_SETFL, 0), 0);
  std::array<char, 1 << 16> piece{};
  for (ssize_t got = 0; (got = read(reader, piece.data(), piece.size())) > 0;)
    taken.append(piece.data(), static_cast<std::size_t>(got));
  close(reader);
  EXPECT_TRUE(taken.ends_with("MCAP0\r\n")) << taken.size() << " bytes";
  EXPECT_EQ(reports_.size(), lines);
}

TEST_F(RecordedRun, OnAFullDiskEndsWithOneLine) {
  RecorderOptions full = options();
  full.file = "/dev/full";
  if (!std::filesystem::exists(full.file)) GTEST_SKIP() << "this system has no /dev/full";
  EXPECT_THROW(record(full), std::runtime_error) << "its head cannot be written";
}

TEST(Recording, RejectsFilesThatAreNotRecordings) {
  TemporaryFolder folder;
  for (const char* const text : {"", "something else", "\x89MCAP0\r\n", "\x89MCAP0\r\n and then nothing of use"})
    EXPECT_THROW(Recording(folder.write("no.mcap", text)), std::runtime_error) << text;
  EXPECT_THROW(Recording("/nowhere.mcap"), std::runtime_error);
  EXPECT_THROW(Recording(folder.path()), std::runtime_error);
}

RC_GTEST_PROP(PackedImage, KeepsTheSamePixels, ()) {
  const int width = 2 * *rc::gen::inRange(1, 40), height = *rc::gen::inRange(1, 30), gap = *rc::gen::inRange(0, 9);
  const auto pixels = *rc::gen::container<std::vector<std::uint8_t>>(
      static_cast<std::size_t>((2 * width + gap) * height), rc::gen::arbitrary<std::uint8_t>());
  std::vector<std::byte> bytes;
  const ImageView image{pixels.data(), width, height, 2 * width + gap};
  pack_image(image, bytes);
  Image unpacked;
  unpack_image(bytes, unpacked);
  RC_ASSERT(unpacked.width() == width && unpacked.height() == height);
  for (int y = 0; y < height; ++y) RC_ASSERT(std::equal(image.row(y), image.row(y) + 2 * width, unpacked.row(y)));
  const auto cut = *rc::gen::inRange<std::size_t>(0, bytes.size());
  RC_ASSERT_THROWS_AS(unpack_image(std::span(bytes).first(cut), unpacked), BadBytes);
}

}  // namespace
}  // namespace reorient
