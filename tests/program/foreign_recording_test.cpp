// SPDX-License-Identifier: MIT
// The commands that read recordings, over recordings that another tool wrote, passed on or filtered.
#include "tests/workbench/recording/foreign_recording.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/bytes.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/recording/raw_mcap.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/input_file.h"
#include "workbench/recording/frame_entry.h"
#include "workbench/recording/recording.h"

namespace reorient {
namespace {

using Bytes = std::vector<std::byte>;

/// A short recording, and what the commands print about it.
struct Original {
  Original() {
    file = (folder.path() / "original.mcap").string();
    const ProgramRun run =
        run_reorient({"run", "--seconds", "0.4", "--width", "160", "--no-pictures", "--log", "off", "--record", file});
    digest = digest_of(run);
    raw = raw_recording(file);
    world = run_reorient({"recording", "export", file, "--csv", "world"}).out;
    events = run_reorient({"recording", "export", file, "--csv", "events"}).out;
  }

  TemporaryFolder folder;
  std::string file, digest, world, events;
  RawRecording raw;
};

const Original& original() {
  static const Original original;
  return original;
}

constexpr int kFrames = 13;

class ForeignRecording : public testing::Test {
 protected:
  std::string file(const std::string& name) const { return (folder_.path() / name).string(); }
  /// Writes a recording as `shape` and returns its name.
  std::string write(const RawRecording& recording, const ForeignShape& shape = {}) const {
    const Bytes bytes = written_as(recording, shape);
    return folder_.write("foreign.mcap", std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()))
        .string();
  }

  /// The commands that need no engine, and the exact replay.
  void expect_same_as_original(const std::string& foreign) const {
    const ProgramRun info = run_reorient({"recording", "info", foreign});
    EXPECT_EQ(info.code, 0) << info.out << info.err;
    EXPECT_NE(info.out.find("13 frames, 0.00 to 0.40 s of the robot; 13 can be replayed exactly"), std::string::npos)
        << info.out;
    const ProgramRun world = run_reorient({"recording", "export", foreign, "--csv", "world"});
    EXPECT_EQ(world.code, 0) << world.err;
    EXPECT_EQ(world.out, original().world);
    EXPECT_EQ(world.err, "");
    const ProgramRun recovered = run_reorient({"recording", "recover", foreign, "--out", file("whole.mcap")});
    EXPECT_EQ(recovered.code, 0) << recovered.out << recovered.err;
    EXPECT_EQ(recovered.out, file("whole.mcap") + ": 13 frames, 0.00 to 0.40 s\n");
    const ProgramRun replayed = run_reorient({"replay", foreign});
    EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
    EXPECT_EQ(digest_of(replayed), original().digest);
  }

  /// The other commands that read recordings.
  void expect_other_commands_succeed(const std::string& foreign) const {
    EXPECT_EQ(run_reorient({"recording", "export", foreign, "--csv", "events"}).out, original().events);
    const ProgramRun cut = run_reorient({"recording", "cut", foreign, "--from", "0.2", "--out", file("part.mcap")});
    EXPECT_EQ(cut.code, 0) << cut.err;
    EXPECT_EQ(cut.out, file("part.mcap") + ": 7 frames, 0.20 to 0.40 s\n");
    const ProgramRun part = run_reorient({"replay", file("part.mcap")});
    EXPECT_EQ(part.code, 0) << part.out << part.err;
    const ProgramRun pictures =
        run_reorient({"recording", "pictures", foreign, "--at", "0.3", "--out", file("pictures")});
    EXPECT_EQ(pictures.code, 0) << pictures.err;
    EXPECT_EQ(pictures.out, "pictures of 0.30 s: " + file("pictures") + "/\n");
    const ProgramRun footage = run_reorient({"run", "--robot", "footage", foreign, "--no-pictures", "--log", "off"});
    EXPECT_NE(footage.out.find("13 frames"), std::string::npos) << footage.out << footage.err;
  }

  TemporaryFolder folder_;
};

/// Each shape occurs; neighbors differ in all of their properties.
std::vector<ForeignShape> spread_of_shapes() {
  const std::vector<ForeignShape> all = all_foreign_shapes();
  constexpr std::size_t kStep = 37;
  std::vector<ForeignShape> some;
  for (std::size_t i = 0; i < all.size(); i += kStep) some.push_back(all[i]);
  return some;
}

class ForeignShapes : public ForeignRecording, public testing::WithParamInterface<ForeignShape> {};

TEST_P(ForeignShapes, AreReadLikeTheOriginal) {
  const std::string foreign = write(original().raw, GetParam());
  expect_same_as_original(foreign);
  expect_other_commands_succeed(foreign);
}

INSTANTIATE_TEST_SUITE_P(Some, ForeignShapes, testing::ValuesIn(spread_of_shapes()),
                         [](const auto& shape) { return shape.param.name(); });

TEST_F(ForeignRecording, OfAnyShapeIsReadLikeTheOriginal) {
  const std::vector<ForeignShape> all = all_foreign_shapes();
  EXPECT_GE(all.size(), 416u) << "as many as the conformance data of the MCAP project";
  for (const ForeignShape& shape : all) {
    SCOPED_TRACE(shape.name());
    expect_same_as_original(write(original().raw, shape));
  }
}

/// A short recording of a robot that knows its room, the test that is made of it, and the rating of the room.
class ForeignRecordingOfAKnownRoom : public ForeignRecording {
 protected:
  ForeignRecordingOfAKnownRoom() : scripts_(copy_scripts(folder_.path())) {
    const std::string model = file("room.model"), recording = file("foreign.mcap");
    run_reorient({"run", "trial", "--set", "trial.event=none", "--set", "trial.learn=30", "--seconds", "12", "--width",
                  "160", "--no-pictures", "--log", "off", "--model", model});
    run_reorient({"run", "--seconds", "0.4", "--width", "160", "--no-pictures", "--log", "off", "--model", model,
                  "--record", recording});
    raw_ = raw_recording(recording);
    test_ = recorded_test(recording);
    rating_ = rating(recording);
  }

  /// The text of the test that `record-test` writes, and the digest of its recording.
  std::string recorded_test(const std::string& recording) const {
    const ProgramRun made =
        run_reorient({"record-test", recording, "--from", "0.1", "--name", "made", "--scripts", scripts_.string()});
    EXPECT_EQ(made.code, 0) << made.err;
    EXPECT_EQ(made.err, "");
    const std::filesystem::path test = scripts_ / "tests/made_test.lua";
    const std::filesystem::path part = scripts_ / "tests/recordings/made.mcap";
    const ProgramRun replayed = run_reorient({"replay", part.string()});
    EXPECT_EQ(replayed.code, 0) << replayed.out << replayed.err;
    std::string text = made.out + read_input(test, "a test") + digest_of(replayed);
    std::filesystem::remove(test);
    std::filesystem::remove(part);
    // The size of the part depends on what else the recording contains.
    const std::size_t size = text.find(" frames, "), end = text.find(" MB", size);
    return text.erase(size, end - size);
  }
  static std::string rating(const std::string& recording) {
    const ProgramRun rated = run_reorient({"room", "rate", recording, "--trials", "4", "--banner", "0"});
    EXPECT_EQ(rated.err, "");
    return rated.out;
  }

  std::filesystem::path scripts_;
  RawRecording raw_;
  std::string test_, rating_;
};

TEST_F(ForeignRecordingOfAKnownRoom, OfAnyShapeMakesTheSameTestAndRating) {
  EXPECT_NE(test_.find("test(\"made continues as recorded\""), std::string::npos) << test_;
  EXPECT_NE(rating_.find("verdict: works\n"), std::string::npos) << rating_;
  for (const ForeignShape& shape : all_foreign_shapes()) {
    SCOPED_TRACE(shape.name());
    const std::string foreign = write(raw_, shape);
    EXPECT_EQ(recorded_test(foreign), test_);
    EXPECT_EQ(rating(foreign), rating_);
  }
}

TEST_F(ForeignRecording, WithoutImagesGivesItsTablesAndSaysWhatIsMissing) {
  RawRecording without = original().raw;
  without.remove(kImageTopics[0]);
  const std::string foreign = write(without);
  const ProgramRun world = run_reorient({"recording", "export", foreign, "--csv", "world"});
  EXPECT_EQ(world.code, 0) << world.err;
  EXPECT_EQ(world.out, original().world);
  EXPECT_EQ(world.err, "") << "a table needs no image";
  const ProgramRun info = run_reorient({"recording", "info", foreign});
  EXPECT_EQ(info.code, 1);
  EXPECT_NE(info.out.find("13 frames, 0.00 to 0.40 s of the robot; 0 can be replayed exactly"), std::string::npos)
      << info.out;
  EXPECT_NE(info.out.find("damaged at 0.00 s: frame 1: an image of this frame is missing\n"), std::string::npos)
      << info.out;
  EXPECT_NE(info.out.find("13 frames without a recorded image\n"), std::string::npos) << info.out;
  const ProgramRun replayed = run_reorient({"replay", foreign});
  EXPECT_EQ(replayed.code, 2);
  EXPECT_NE(replayed.err.find(foreign + ": at 0.00 s: frame 1: an image of this frame is missing\n"), std::string::npos)
      << replayed.err;
  const ProgramRun recovered = run_reorient({"recording", "recover", foreign, "--out", file("whole.mcap")});
  EXPECT_EQ(recovered.code, 1);
  EXPECT_EQ(recovered.out, file("whole.mcap") + ": 13 frames, 0.00 to 0.40 s; 13 frames without a recorded image\n");
  const ProgramRun again = run_reorient({"recording", "info", file("whole.mcap")});
  EXPECT_EQ(again.code, 0) << "the recovered file does not promise these images: " << again.out;
}

TEST_F(ForeignRecording, WithoutOneImageIsReplayedUpToThere) {
  RawRecording without = original().raw;
  const RawRecording::Message* const lost = without.of(kImageTopics[0]).at(5);
  std::erase_if(without.messages, [&, time = lost->time, channel = lost->channel](const auto& message) {
    return message.time == time && message.channel == channel;
  });
  ForeignShape uncounted;
  uncounted.summary = ForeignShape::Summary::none;
  const ProgramRun recovered =
      run_reorient({"recording", "recover", write(without, uncounted), "--out", file("whole.mcap")});
  EXPECT_EQ(recovered.code, 1);
  EXPECT_EQ(recovered.out, file("whole.mcap") + ": 13 frames, 0.00 to 0.40 s; 1 frame without a recorded image\n");
  const std::string foreign = write(without);
  const ProgramRun replayed = run_reorient({"replay", foreign});
  EXPECT_EQ(replayed.code, 1) << replayed.err;
  EXPECT_TRUE(replayed.out.starts_with("5 of 13 frames, up to 0.13 s, replayed in ")) << replayed.out;
  EXPECT_NE(replayed.err.find("at 0.17 s: frame 6: an image of this frame is missing"), std::string::npos)
      << replayed.err;
  const ProgramRun world = run_reorient({"recording", "export", foreign, "--csv", "world"});
  EXPECT_EQ(world.out, original().world);
  EXPECT_EQ(world.code, 0) << world.err;
}

/// A message that is no frame of ours on the topic of the frames.
TEST_F(ForeignRecording, WithAnOddMessageLosesOnlyThatFrame) {
  const std::vector<Bytes> odd{{}, Bytes(3), Bytes(40, std::byte{0x7B}), Bytes(5000, std::byte{0xFF})};
  for (const Bytes& data : odd) {
    for (const ForeignShape::Layout layout : {ForeignShape::Layout::chunks, ForeignShape::Layout::loose}) {
      RawRecording recording = original().raw;
      recording.of(kFrameTopic).at(6)->data = data;
      ForeignShape shape;
      shape.layout = layout;
      const std::string foreign = write(recording, shape);
      SCOPED_TRACE(shape.name() + ", " + std::to_string(data.size()) + " bytes");
      const ProgramRun world = run_reorient({"recording", "export", foreign, "--csv", "world"});
      EXPECT_EQ(world.code, 1);
      EXPECT_EQ(std::count(world.out.begin(), world.out.end(), '\n'), 1 + kFrames - 1);
      EXPECT_NE(world.err.find("reorient: " + foreign + ": at byte "), std::string::npos) << world.err;
      EXPECT_NE(world.err.find(": /reorient/frame at 0.20 s: "), std::string::npos) << world.err;
      EXPECT_NE(world.err.find(foreign + ": 1 frame lost\n"), std::string::npos) << world.err;
      const ProgramRun recovered = run_reorient({"recording", "recover", foreign, "--out", file("whole.mcap")});
      EXPECT_EQ(recovered.code, 1);
      EXPECT_EQ(recovered.out, file("whole.mcap") + ": 12 frames, 0.00 to 0.40 s; 1 frame lost\n");
      const ProgramRun replayed = run_reorient({"replay", foreign});
      EXPECT_EQ(replayed.code, 1);
      EXPECT_TRUE(replayed.out.starts_with("6 of 13 frames, up to 0.17 s, ")) << replayed.out;
      const ProgramRun info = run_reorient({"recording", "info", foreign});
      EXPECT_EQ(info.code, 1);
      EXPECT_NE(info.out.find("12 frames, "), std::string::npos) << info.out;
      EXPECT_NE(info.out.find("\n1 frame lost\n"), std::string::npos) << info.out;
    }
  }
}

TEST_F(ForeignRecording, WithoutAnyReadableFrameFailsInEveryCommand) {
  RawRecording recording = original().raw;
  for (RawRecording::Message* const message : recording.of(kFrameTopic)) message->data.assign(9, std::byte{1});
  for (const ForeignShape::Summary summary : {ForeignShape::Summary::full, ForeignShape::Summary::none}) {
    ForeignShape shape;
    shape.summary = summary;
    const std::string foreign = write(recording, shape);
    SCOPED_TRACE(shape.name());
    EXPECT_EQ(run_reorient({"recording", "info", foreign}).code, 1);
    EXPECT_EQ(run_reorient({"recording", "export", foreign, "--csv", "world"}).code, 1);
    EXPECT_EQ(run_reorient({"replay", foreign}).code, 2);
    const ProgramRun recovered = run_reorient({"recording", "recover", foreign, "--out", file("whole.mcap")});
    EXPECT_EQ(recovered.code, 1);
    EXPECT_EQ(recovered.out, file("whole.mcap") + ": 0 frames, 0.00 to 0.00 s; 13 frames lost\n");
  }
  RawRecording filtered = original().raw;
  filtered.remove(kFrameTopic);
  filtered.channels.push_back({99, 0, "/other", "json", {}});
  Bytes bytes;
  {
    // The generator orders by frames, so write them by hand.
    mcap::RawMcap file;
    file.magic();
    file.header();
    for (const mcap::Channel& channel : filtered.channels) file.channel(channel);
    file.end();
    bytes = file.bytes();
  }
  folder_.write("filtered.mcap", std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  const ProgramRun info = run_reorient({"recording", "info", file("filtered.mcap")});
  EXPECT_EQ(info.code, 2);
  EXPECT_NE(info.err.find("found no frames of reorient (topic /reorient/frame)"), std::string::npos) << info.err;
}

TEST_F(ForeignRecording, WithTheStateFilteredOutGivesTables) {
  RawRecording recording = original().raw;
  recording.remove(kStateTopic);
  const std::string foreign = write(recording);
  EXPECT_EQ(run_reorient({"recording", "export", foreign, "--csv", "world"}).out, original().world);
  const ProgramRun replayed = run_reorient({"replay", foreign});
  EXPECT_EQ(replayed.code, 2);
  EXPECT_NE(replayed.err.find("expected frames that can be replayed from there, found none"), std::string::npos)
      << replayed.err;
  const ProgramRun live = run_reorient({"replay", foreign, "--live", "0"});
  EXPECT_EQ(live.code, 2);
  EXPECT_NE(live.err.find("expected frames that can be replayed from there, found none"), std::string::npos);
  EXPECT_EQ(live.err.find("live view: http"), std::string::npos) << "no link to a view that ends at once";
  EXPECT_EQ(run_reorient({"recording", "recover", foreign, "--out", file("whole.mcap")}).code, 0);
}

TEST_F(ForeignRecording, WithAnInvalidStateIsSkippedUpToTheNextOne) {
  RawRecording recording = original().raw;
  RawRecording::Message* const state = recording.of(kStateTopic).at(0);
  state->data.resize(100);
  state->data[0] = std::byte{96};
  state->data[1] = state->data[2] = state->data[3] = std::byte{0};
  const std::string foreign = write(recording);
  const ProgramRun replayed = run_reorient({"replay", foreign});
  EXPECT_EQ(replayed.code, 2) << replayed.out;
  EXPECT_NE(replayed.err.find(foreign + ": at 0.00 s: frame 1: the state of the engine: "), std::string::npos)
      << replayed.err;
}

/// 96 MB for viewers that hardly need space in the file.
TEST_F(ForeignRecording, WithHugeMessagesForViewersNeedsBoundedMemory) {
  RawRecording recording = original().raw;
  RawRecording::Message view = *recording.of("/world").at(0);
  view.data.assign(std::size_t{1} << 20, std::byte{' '});
  view.time = recording.messages.front().time;
  recording.messages.insert(recording.messages.begin(), 96, view);
  const std::string foreign = write(recording);
  EXPECT_LT(std::filesystem::file_size(foreign), 10u << 20);
  Recording read(foreign);
  read.read_views();
  RecordedFrame frame;
  int frames = 0;
  std::size_t most = 0;
  for (; read.next(frame); ++frames) {
    std::size_t bytes = 0;
    for (const ViewMessage& message : frame.views) bytes += message.data.size();
    most = std::max(most, bytes);
  }
  EXPECT_EQ(frames, kFrames);
  EXPECT_LE(most, Recording::kMostViewBytes);
  EXPECT_GT(most, Recording::kMostViewBytes / 2);
  ASSERT_EQ(read.damages().size(), 1u);
  EXPECT_NE(read.damages()[0].find("/world at 0.00 s: a frame has too many messages for viewers"), std::string::npos)
      << read.damages()[0];
}

}  // namespace
}  // namespace reorient
