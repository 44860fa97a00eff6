// SPDX-License-Identifier: MIT
// `reorient run --robot footage` and `experiment footage`, called as by a user, on images of the simulator that lie
// in a folder like real footage.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include "program/run/footage_arguments.h"
#include "program/run/venue.h"
#include "tests/paths.h"
#include "tests/program/footage/decoder.h"
#include "tests/program/footage/image_files.h"
#include "tests/program/footage/simulated_footage.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "tests/workbench/footage/ros_log_writer.h"
#include "workbench/files/body_file.h"

namespace reorient {
namespace {

using Words = std::vector<std::string>;

/// The frames of the folder, as the program reads them.
std::vector<FootageFrame> frames_of(const std::filesystem::path& source) {
  const RobotBody body = load_body(body_file({}));
  const auto footage = open_footage(source, {}, body);
  std::vector<FootageFrame> frames;
  for (FootageFrame frame; footage->next(frame);) frames.push_back(frame);
  return frames;
}

class Footage : public testing::Test {
 protected:
  static constexpr int kImages = 220;  // 44 s

  /// Rendered once for all tests, because it takes a while.
  static const std::filesystem::path& recorded() {
    static const TemporaryFolder folder;
    if (!std::filesystem::exists(folder.path() / "frames.csv")) write_simulated_footage(folder.path(), kImages);
    return folder.path();
  }

  void SetUp() override { need_decoder(); }

  ProgramRun run(const Words& more, const std::filesystem::path& source = recorded()) const {
    Words words{"run", "--robot", "footage", source.string(), "--no-pictures", "--log", "off"};
    if (std::find(more.begin(), more.end(), "--wall") == more.end()) words.insert(words.end(), {"--wall", "field"});
    words.insert(words.end(), more.begin(), more.end());
    return run_reorient(words);
  }

  /// A log of ROS 2 with compressed images.
  void write_log_of_files(const std::string& extension, const char* name) const {
    RosLogOptions options;
    options.start = 1000.0;  // numbers of this size hold nanoseconds
    options.format = extension.substr(1);
    int next = 0;
    options.encode = [&](const Image&) { return encoded(image_file(next++), extension); };
    const std::vector<std::byte> log = ros_log(frames_of(recorded()), options);
    folder_.write(name, {reinterpret_cast<const char*>(log.data()), log.size()});
  }
  static std::filesystem::path image_file(int number) {
    return recorded() / "images" / fmt::format("{:04}.png", number);
  }

  std::string file(const char* name) const { return (folder_.path() / name).string(); }

  /// A copy of the table with one thing changed; the images stay where they are.
  std::string table_with(const std::string& from, const std::string& to) const {
    std::ifstream in(recorded() / "frames.csv");
    std::ostringstream text;
    text << in.rdbuf();
    std::string all = text.str();
    const std::size_t place = all.find(from);
    EXPECT_NE(place, std::string::npos);
    all.replace(place, from.size(), to);
    return folder_.write((to.substr(to.find('/') + 1) + ".csv").c_str(), all).string();
  }

  TemporaryFolder folder_;
};

TEST_F(Footage, DoesNotFlipARightPose) {
  const ProgramRun right = run({"--belief", "right", "--belief-at", "25"});
  EXPECT_EQ(right.code, 0) << right.out << right.err;
  EXPECT_NE(right.out.find("0 flips"), std::string::npos) << right.out;
  EXPECT_NE(right.out.find("the footage is over after 220 images"), std::string::npos) << right.out;
}

TEST_F(Footage, ShowsAMirroredPoseThatIsThenFlipped) {
  const ProgramRun mirrored = run({"--belief", "mirrored", "--belief-at", "25", "--json", file("run.json")});
  EXPECT_EQ(mirrored.code, 0) << mirrored.out << mirrored.err;
  const auto json = nlohmann::json::parse(std::ifstream(file("run.json")));
  EXPECT_EQ(json["flips"], 1);
  EXPECT_EQ(json["correct"], true);
  EXPECT_NEAR(json["belief_wrong_at_seconds"].get<double>(), 25.0, 0.3);
  EXPECT_LT(json["corrected_after_seconds"].get<double>(), 10.0);
}

TEST_F(Footage, MayBeLiftedAndPlacedMirrored) {
  const ProgramRun lifted = run({"--belief", "mirrored", "--belief-at", "25", "--lifted"});
  EXPECT_EQ(lifted.code, 0) << lifted.out << lifted.err;
  EXPECT_NE(lifted.out.find("1 flip,"), std::string::npos) << lifted.out;
}

TEST_F(Footage, IsRecordedAndReplayedToTheSameDigest) {
  const ProgramRun recorded_run = run({"--record", file("run.mcap"), "--belief", "mirrored", "--belief-at", "25"});
  const ProgramRun replayed = run_reorient({"replay", file("run.mcap")});
  EXPECT_EQ(replayed.code, 0) << replayed.err;
  EXPECT_EQ(digest_of(replayed), digest_of(recorded_run));
}

TEST_F(Footage, EndsAtAMissingImageAndKeepsTheFramesBefore) {
  const std::string table = table_with("images/0100.png", "images/none.png");
  for (const char* const wall : {"auto", "6", "field"}) {
    const ProgramRun ended = run({"--frames", table, "--wall", wall, "--record", file("run.mcap")});
    EXPECT_EQ(ended.code, kBadInput) << wall;
    EXPECT_NE(ended.err.find("images/none.png: expected the image of"), std::string::npos) << wall << ended.err;
    EXPECT_NE(ended.out.find("wrong: the footage could not be read to its end"), std::string::npos)
        << wall << ended.out;
    const ProgramRun replayed = run_reorient({"replay", file("run.mcap")});
    EXPECT_EQ(replayed.code, 0) << wall;
    EXPECT_EQ(digest_of(replayed), digest_of(ended)) << wall;
    EXPECT_NE(replayed.out.find("100 frames"), std::string::npos) << wall << replayed.out;
  }
}

TEST_F(Footage, EndsAtATruncatedImage) {
  const std::vector<std::byte> jpeg = encoded(image_file(0), ".jpg");
  ASSERT_FALSE(jpeg.empty());
  const auto table = [&](std::size_t bytes, const std::string& tail) {
    folder_.write("cut.jpg", std::string(reinterpret_cast<const char*>(jpeg.data()), bytes) + tail);
    return run({}, folder_.write("cut.csv", "image,time_s,x_m,y_m,rotation_rad\ncut.jpg,0,0,0,0\n"));
  };
  EXPECT_EQ(table(jpeg.size(), "").code, 0);
  EXPECT_EQ(table(jpeg.size(), std::string(7, '\0')).code, 0) << "some cameras pad their files";
  for (const std::size_t left_out : {std::size_t{2}, jpeg.size() / 4, jpeg.size() / 2}) {
    const ProgramRun cut = table(jpeg.size() - left_out, "");
    EXPECT_EQ(cut.code, kBadInput) << left_out;
    EXPECT_NE(cut.err.find("cut.jpg: expected a whole JPEG"), std::string::npos) << cut.err;
  }
  std::ostringstream png;
  png << std::ifstream(image_file(0), std::ios::binary).rdbuf();
  folder_.write("cut.jpg", png.str().substr(0, png.str().size() / 2));
  EXPECT_EQ(run({}, folder_.path() / "cut.csv").code, kBadInput) << "half of a PNG";
}

TEST_F(Footage, ReportsThatABeliefChangesAfterTheEnd) {
  const ProgramRun late = run({"--belief", "mirrored", "--belief-at", "500"});
  EXPECT_EQ(late.code, kBadInput);
  EXPECT_NE(late.err.find("--belief-at 500: expected a moment of the footage, which lasts 43.8 s"), std::string::npos)
      << late.err;
  EXPECT_EQ(run({"--belief", "mirrored", "--belief-at", "500", "--seconds", "2"}).code, 0) << "it was ended before";
}

TEST_F(Footage, RunsToItsEndUnlessLimited) {
  std::string slow = "image,time_s,x_m,y_m,rotation_rad\n";
  for (int i = 0; i < 12; ++i) slow += fmt::format("{},{},0,0,0\n", image_file(i).string(), 100 * i);
  const std::string table = folder_.write("slow.csv", slow).string();
  const ProgramRun whole = run({}, table);
  EXPECT_NE(whole.out.find("right: the footage is over after 12 images"), std::string::npos) << whole.out;
  const ProgramRun part = run({"--seconds", "250"}, table);
  EXPECT_NE(part.out.find("right: ended after 4 images, as set by --seconds"), std::string::npos) << part.out;
}

TEST_F(Footage, WithoutAPoseIsNotJudgedAndReportsUnusedColumns) {
  const ProgramRun lost =
      run({"--json", file("run.json"), "--frames", table_with("x_m,y_m,rotation_rad", "pos_east,pos_north,theta")});
  EXPECT_EQ(lost.code, 0) << lost.out << lost.err;
  EXPECT_NE(lost.err.find("beginning at an unknown position; columns that are not used: pos_east, pos_north, theta"),
            std::string::npos)
      << lost.err;
  EXPECT_NE(lost.out.find("not judged: the footage is over after 220 images; the footage has no true pose"),
            std::string::npos)
      << lost.out;
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(file("run.json")))["correct"], nullptr);
}

TEST_F(Footage, IsJudgedByTheLastPoseIfTheLastImageHasNone) {
  std::string text = "image,time_s,x_m,y_m,rotation_rad\n";
  for (int i = 0; i < 4; ++i) text += fmt::format("{},{},0,0,0\n", image_file(i).string(), i);
  text += image_file(4).string() + ",4,,,\n";
  const ProgramRun judged = run({"--json", file("run.json")}, folder_.write("gap.csv", text));
  EXPECT_NE(judged.out.find("right: the footage is over after 5 images\n"), std::string::npos) << judged.out;
  EXPECT_EQ(nlohmann::json::parse(std::ifstream(file("run.json")))["correct"], true);
}

TEST_F(Footage, ReportsTrialsThatBeginBeforeTheRoomIsLearned) {
  const ProgramRun tried = run_reorient({"experiment", "footage", recorded().string(), "--wall", "field", "--learn",
                                         "1", "--watch", "5", "--starts", "2", "--out", file("out")});
  ASSERT_EQ(tried.code, 0) << tried.err;
  EXPECT_NE(tried.out.find(": 1 of 2 starts come before the room was learned (at "), std::string::npos) << tried.out;
}

TEST_F(Footage, IsRefusedIfTheCommandOrTheTableIsInvalid) {
  const std::pair<Words, const char*> cases[] = {
      {{"--belief", "upside down"}, "--belief: expected right, mirrored, degrees"},
      {{"--belief", "mirrored:x"}, "--belief: expected right, mirrored, degrees"},
      {{"--belief", "270"},
       "--belief: expected right, mirrored, degrees from -180 to 180, or mirrored:DEGREES, found '270'"},
      {{"--lifted"}, "--lifted: expected together with --belief, found alone"},
      {{"--column", "time"}, "--column: expected NAME=HEADER or NAME=HEADER:UNIT, as in time=stamp:ns, found 'time'"},
      {{"--column", "tume=t"}, "unknown column 'tume' (did you mean 'time'?)"},
      {{"--column", "time=stamp"}, "frames.csv:1: expected a column 'stamp' for time"},
      {{"--column", "x_m=x"}, "--column: unknown column 'x_m' (expected image, time, x, y"},
      {{"--column", "pitch=pitch_rad:deg"}, "'pitch_rad': expected the unit of its name, 'rad', found 'deg'"},
      {{"--frames", table_with("pitch_rad", "pich_deg")}, "found 'pich_deg' (did you mean 'pitch_deg'?)"},
      {{"--frames", table_with(",rotation_rad", ",roation_rad")}, "found 'roation_rad' (did you mean 'rotation_rad'?)"},
      {{"--frames", table_with("pitch_rad", "pitch")}, "found 'pitch' (did you mean 'pitch_rad'?)"},
      {{"--frames", "/nowhere.csv"}, "/nowhere.csv: expected a table, found nothing of that name"},
      {{"--room", "hall.hdr"}, "--room: expected --robot simulator, found --robot footage"},
      {{"--width", "320"}, "--width: expected --robot simulator, found --robot footage"},
      {{"--wall", "far"}, "--wall: expected auto, field or a radius of 1 to 200 m, found 'far'"},
      {{"--images-per-second", "0"}, "--images-per-second"},
      {{"--set", "wall.radios=3"}, "wall.radios"},
  };
  for (const auto& [words, what] : cases) {
    const ProgramRun refused = run(words);
    EXPECT_EQ(refused.code, kBadInput) << what;
    EXPECT_NE(refused.err.find(what), std::string::npos) << refused.err << "\nexpected: " << what;
    EXPECT_EQ(std::count(refused.err.begin(), refused.err.end(), '\n'), 1) << refused.err;
  }
  const ProgramRun nothing = run_reorient({"run", "--robot", "footage"});
  EXPECT_EQ(nothing.code, kBadInput);
  EXPECT_NE(nothing.err.find("--robot footage: expected a source"), std::string::npos) << nothing.err;
  const ProgramRun unused = run_reorient({"run", "--images-per-second", "5"});
  EXPECT_NE(unused.err.find("--images-per-second: expected --robot footage, found --robot simulator"),
            std::string::npos)
      << unused.err;
}

TEST_F(Footage, RunsTrialsAtManyTimes) {
  const Words words{"experiment",   "footage",  recorded().string(), "--wall", "field", "--learn",   "20",
                    "--watch",      "10",       "--starts",          "4",      "--out", file("out"), "--json",
                    file("r.json"), "--report", file("report")};
  const ProgramRun tried = run_reorient(words);
  ASSERT_EQ(tried.code, 0) << tried.err;
  const auto rows = nlohmann::json::parse(std::ifstream(file("r.json")));
  ASSERT_EQ(rows.size(), 6u);
  for (const auto& row : rows) {
    EXPECT_EQ(row["trials"], 4);
    EXPECT_EQ(row["false_flips"], 0) << row["start"] << row["pose"];
    if (row["pose"] == "mirrored") {
      EXPECT_EQ(row["failed"], 0.0) << row["start"];
    }
  }
  EXPECT_TRUE(std::filesystem::exists(file("report/index.html")));
  // Finished trials are not run again, and the output is the same.
  const ProgramRun again = run_reorient(words);
  EXPECT_EQ(again.out, tried.out);
}

TEST_F(Footage, GivesATrialTheSameResultAsAWholeRun) {
  const ProgramRun tried =
      run_reorient({"experiment", "footage", recorded().string(), "--wall", "field", "--learn", "20", "--watch", "10",
                    "--starts", "1", "--out", file("out"), "--json", file("r.json")});
  ASSERT_EQ(tried.code, 0) << tried.err;
  const auto rows = nlohmann::json::parse(std::ifstream(file("r.json")));
  const ProgramRun alone = run({"--belief", "mirrored", "--belief-at", "20", "--json", file("run.json")});
  const auto json = nlohmann::json::parse(std::ifstream(file("run.json")));
  double flipped_at = -1.0;
  for (const auto& command : json["commands"])
    if (command["command"] == "flip_pose" && flipped_at < 0.0) flipped_at = command["time"];
  for (const auto& row : rows) {
    if (row["start"] == "told" && row["pose"] == "mirrored") {
      EXPECT_NEAR(row["outcomes"][0]["corrected_after_s"].get<double>(), flipped_at - 20.0, 0.11);
    }
  }
}

TEST_F(Footage, PrintsForEachFailedTrialTheCommandThatShowsIt) {
  // Nothing flips the pose here, so each mirrored pose stays.
  const std::string scripts = std::string(kSourceFolder) + "/scripts";
  const ProgramRun tried =
      run_reorient({"experiment", "footage", recorded().string(), "--wall", "field", "--learn", "20", "--watch", "5",
                    "--starts", "2", "--behaviors", "background_training", "--scripts", scripts, "--out", file("out")});
  ASSERT_EQ(tried.code, 0) << tried.err;
  EXPECT_NE(tried.out.find("Failed trials. A command shows"), std::string::npos);
  EXPECT_NE(tried.out.find("\n  20 s, image images/0100.png: not found; evidence "), std::string::npos) << tried.out;
  EXPECT_NE(tried.out.find("\n0 of 6 mirrored poses were found (0.0 %); 0 of 6 right poses were flipped (0.0 %)\n"),
            std::string::npos)
      << tried.out;
  const std::size_t begin = tried.out.find("    reorient run --robot footage ");
  ASSERT_NE(begin, std::string::npos) << tried.out;
  const std::string command = tried.out.substr(begin, tried.out.find('\n', begin) - begin);
  EXPECT_NE(command.find(" --behaviors background_training --scripts " + scripts + " --belief mirrored --belief-at 20"),
            std::string::npos)
      << command;
  std::istringstream split(command);
  Words words;
  for (std::string word; split >> word;) words.push_back(word);
  words.erase(words.begin());  // reorient
  words.insert(words.end(), {"--out", file("shown"), "--json", file("run.json")});
  const ProgramRun shown = run_reorient(words);
  EXPECT_EQ(shown.code, 1) << "the mirrored pose stays\n" << shown.out << shown.err;
  const auto json = nlohmann::json::parse(std::ifstream(file("run.json")));
  for (const auto& request : json["commands"]) EXPECT_NE(request["command"], "flip_pose");
}

TEST_F(Footage, HasTheSameDigestInAnyFormat) {
  const Words what{"--belief", "mirrored", "--belief-at", "25"};
  const std::string digest = digest_of(run(what));
  ASSERT_NE(digest, "");
  // A recording of this program.
  Words words = what;
  words.insert(words.end(), {"--record", file("run.mcap")});
  EXPECT_EQ(digest_of(run(words)), digest);
  EXPECT_EQ(digest_of(run(what, file("run.mcap"))), digest);
  // A video with the same table.
  std::vector<std::filesystem::path> images;
  images.reserve(kImages);
  for (int i = 0; i < kImages; ++i) images.push_back(image_file(i));
  ASSERT_TRUE(write_lossless_video(images, file("walk.mkv")));
  words = what;
  words.insert(words.end(), {"--frames", (recorded() / "frames.csv").string()});
  EXPECT_EQ(digest_of(run(words, file("walk.mkv"))), digest);
  // A log of ROS 2, raw images.
  RosLogOptions log_options;
  log_options.start = 1000.0;  // numbers of this size hold nanoseconds
  const std::vector<std::byte> log = ros_log(frames_of(recorded()), log_options);
  folder_.write("log.mcap", {reinterpret_cast<const char*>(log.data()), log.size()});
  const std::vector<FootageFrame> in_table = frames_of(recorded()), in_log = frames_of(file("log.mcap"));
  ASSERT_EQ(in_table.size(), in_log.size());
  for (std::size_t i = 0; i < in_log.size(); ++i) {
    EXPECT_EQ(in_table[i].image.bytes(), in_log[i].image.bytes()) << i;
    EXPECT_LT((in_table[i].pose->position - in_log[i].pose->position).norm(), 1e-12);
    EXPECT_LT((in_table[i].robot_from_camera.matrix() - in_log[i].robot_from_camera.matrix()).norm(), 1e-12);
    EXPECT_LT((in_table[i].odometry->position - in_log[i].odometry->position).norm(), 1e-12);
    EXPECT_LT((in_table[i].camera.focal - in_log[i].camera.focal).norm(), 1e-12) << i;
    EXPECT_LT((in_table[i].camera.center - in_log[i].camera.center).norm(), 1e-12) << i;
    EXPECT_EQ(in_table[i].camera.k1, in_log[i].camera.k1) << i;
    EXPECT_NEAR(in_table[i].time + 1000.0, in_log[i].time, 1e-9) << i;
    EXPECT_NEAR(in_table[i].torso.pitch, in_log[i].torso.pitch, 1e-12) << i;
  }
  const ProgramRun of_log = run(what, file("log.mcap"));
  EXPECT_EQ(digest_of(of_log), digest) << of_log.out << of_log.err;
  // The same with compressed images.
  write_log_of_files(".png", "png.mcap");
  EXPECT_EQ(digest_of(run(what, file("png.mcap"))), digest);
}

TEST_F(Footage, OfLossyImagesShowsTheSameWithinThreeFrames) {
  const auto flipped_at = [&](const std::filesystem::path& source) {
    const ProgramRun mirrored = run({"--belief", "mirrored", "--belief-at", "25", "--json", file("run.json")}, source);
    EXPECT_EQ(mirrored.code, 0) << mirrored.out << mirrored.err;
    const auto json = nlohmann::json::parse(std::ifstream(file("run.json")));
    return json["corrected_after_seconds"].get<double>();
  };
  write_log_of_files(".jpg", "jpeg.mcap");
  EXPECT_NEAR(flipped_at(file("jpeg.mcap")), flipped_at(recorded()), 0.61);
}

/// Real footage of a walking NAO.
class RealFootage : public DecodedSharedDataTest {
 protected:
  RealFootage() : DecodedSharedDataTest("footage") {}
};

TEST_F(RealFootage, FindsMirroredPoses) {
  const TemporaryFolder out;
  const ProgramRun tried =
      run_reorient({"experiment", "footage", (folder() / "nao-canteen-01").string(), "--fov-degrees", "60.97",
                    "--images-per-second", "5", "--learn", "14", "--watch", "8", "--starts", "20", "--out",
                    (out.path() / "out").string(), "--json", (out.path() / "r.json").string()});
  ASSERT_EQ(tried.code, 0) << tried.err;
  const auto rows = nlohmann::json::parse(std::ifstream(out.path() / "r.json"));
  for (const auto& row : rows) {
    if (row["start"] == "told" && row["pose"] == "mirrored") {
      EXPECT_LE(row["failed"], 0.1);
    }
    if (row["start"] == "told" && row["pose"] == "right") {
      EXPECT_LE(row["false_flips"], 1);
    }
  }
}

}  // namespace
}  // namespace reorient
