// SPDX-License-Identifier: MIT
// `reorient calibrate --footage`, called as by a user: on images of the simulator whose recorded camera poses are wrong
// by a known offset, and on real footage.
#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <spdlog/fmt/fmt.h>

#include "geometry/angle.h"
#include "localization/calibration/offset_fit.h"
#include "program/calibrate/footage_images.h"
#include "program/run/footage_arguments.h"
#include "program/run/venue.h"
#include "tests/paths.h"
#include "tests/program/footage/decoder.h"
#include "tests/program/footage/simulated_footage.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "workbench/files/body_file.h"
#include "workbench/files/calibration_file.h"

namespace reorient {
namespace {

using Words = std::vector<std::string>;

struct KnownOffset {
  std::uint64_t seed;
  double tilt, pan, roll;  // degrees
  double height;           // cm
  CameraOffset offset() const { return {from_degrees(tilt), from_degrees(pan), from_degrees(roll), 0.01 * height}; }
};
void PrintTo(const KnownOffset& known, std::ostream* out) {
  *out << fmt::format("seed {}: {} down, {} to the left, {} roll, {} cm", known.seed, known.tilt, known.pan, known.roll,
                      known.height);
}

class FootageCalibration : public testing::Test {
 protected:
  void SetUp() override { need_decoder(); }

  ProgramRun calibrate(const Words& more = {}) const {
    Words words{"calibrate",  "--footage", source(), "--out", file("offset.toml"),
                "--pictures", file("out"), "--log",  "off"};
    words.insert(words.end(), more.begin(), more.end());
    return run_reorient(words);
  }
  std::string source() const { return file("footage"); }
  std::string file(const char* name) const { return (folder_.path() / name).string(); }

  void expect_recovered(const KnownOffset& known) const {
    write_offset_footage(source(), {.seed = known.seed, .offset = known.offset()});
    const ProgramRun found = calibrate();
    ASSERT_EQ(found.code, 0) << found.out << found.err;
    EXPECT_NE(found.out.find("by field lines"), std::string::npos) << found.out;
    const CameraOffset offset = load_calibration(file("offset.toml")).offsets[0];
    EXPECT_NEAR(to_degrees(offset.tilt), known.tilt, 0.3) << found.out;
    EXPECT_NEAR(to_degrees(offset.pan), known.pan, 0.3) << found.out;
    EXPECT_NEAR(to_degrees(offset.roll), known.roll, 0.3) << found.out;
    EXPECT_NEAR(100.0 * offset.height, known.height, 1.0) << found.out;
    for (const char* const picture : {"calibration_footage_before.png", "calibration_footage_after.png"})
      EXPECT_TRUE(std::filesystem::exists(folder_.path() / "out" / picture)) << picture;
  }

  TemporaryFolder folder_;
};

TEST_F(FootageCalibration, FindsTheCameraOffsetByLinesAndRunsWithIt) {
  expect_recovered({1, 8.0, 2.0, -3.0, 5.0});
  const Words run{"run",       "--robot", "footage",       source(), "--wall", "field",
                  "--seconds", "2",       "--no-pictures", "--log",  "off"};
  Words corrected = run;
  corrected.insert(corrected.end(), {"--camera-offset", file("offset.toml")});
  const ProgramRun before = run_reorient(run), after = run_reorient(corrected);
  EXPECT_EQ(after.code, 0) << after.err;
  EXPECT_NE(digest_of(before), digest_of(after));
}

TEST_F(FootageCalibration, FindsTiltAndRollByEdgesAndReportsWhatEdgesCannotShow) {
  write_offset_footage(source(), {.seed = 2, .offset = KnownOffset{2, 5.0, 0.0, -3.0, 0.0}.offset()});
  const ProgramRun found = calibrate({"--by", "edges"});
  ASSERT_EQ(found.code, 0) << found.out << found.err;
  EXPECT_NE(found.out.find("pan: not observable from edges"), std::string::npos) << found.out;
  EXPECT_NE(found.out.find("height: not observable from edges"), std::string::npos) << found.out;
  const CameraOffset offset = load_calibration(file("offset.toml")).offsets[0];
  EXPECT_NEAR(to_degrees(offset.tilt), 5.0, 1.0) << found.out;
  EXPECT_NEAR(to_degrees(offset.roll), -3.0, 0.5) << found.out;
  EXPECT_EQ(offset.pan, 0.0);
  EXPECT_EQ(offset.height, 0.0);
}

TEST_F(FootageCalibration, IsRefusedInOneLine) {
  write_offset_footage(source(), {.images = 3, .width = 160, .offset = {}});
  const std::pair<Words, const char*> cases[] = {
      {{}, "expected at least 8 images, found 3"},
      {{"--at", "0,0,0"}, "--at and --footage: expected one, found both"},
      {{"--by", "stars"}, "--by"},
      {{"--fov-degrees", "1"}, "--fov-degrees"},
  };
  for (const auto& [words, what] : cases) {
    const ProgramRun refused = calibrate(words);
    EXPECT_EQ(refused.code, kBadInput) << what;
    EXPECT_NE(refused.err.find(what), std::string::npos) << refused.err << "\nexpected: " << what;
  }
  const ProgramRun missing = run_reorient({"calibrate", "--by", "lines", "--at", "0,0,0"});
  EXPECT_NE(missing.err.find("--by: expected together with --footage, found alone"), std::string::npos) << missing.err;
  const ProgramRun unknown =
      run_reorient({"run", "--robot", "footage", source(), "--camera-offset", file("missing.toml")});
  EXPECT_EQ(unknown.code, kBadInput);
  EXPECT_NE(unknown.err.find("missing.toml"), std::string::npos) << unknown.err;
}

class ManyOffsets : public FootageCalibration, public testing::WithParamInterface<KnownOffset> {};

TEST_P(ManyOffsets, AreFoundByLines) { expect_recovered(GetParam()); }

INSTANTIATE_TEST_SUITE_P(Footage, ManyOffsets,
                         testing::Values(KnownOffset{11, 8.0, 0.0, 3.0, 5.0}, KnownOffset{12, -8.0, 0.0, -3.0, -5.0},
                                         KnownOffset{13, 8.0, 4.0, 3.0, -5.0}, KnownOffset{14, -8.0, -4.0, 3.0, 5.0},
                                         KnownOffset{15, 0.0, 0.0, 0.0, 0.0}, KnownOffset{16, 2.5, -6.0, 1.0, 2.0}));

/// Real footage of a walking NAO, in a room without a field.
class RealFootageCalibration : public DecodedSharedDataTest {
 protected:
  RealFootageCalibration() : DecodedSharedDataTest("footage") {}
};

struct HeldOutMedians {
  double before, after;  // rad
};

HeldOutMedians medians_of(const std::vector<EdgeView>& views) {
  const EdgeMounting mounting = mounting_from_edges(every_second(views, 1));
  const std::vector<EdgeView> others = every_second(views, 0);
  const EdgeAngles angles = edge_angles(others, corrected(others, mounting.recorded, mounting.estimate.offset));
  return {weighted_median(angles.before), weighted_median(angles.after)};
}

// The recorded roll of single images is wrong there, and is left out.
TEST_F(RealFootageCalibration, ReducesTheAngleOfVerticalEdgesOnUnusedImages) {
  FootageArguments arguments;
  arguments.fov_degrees = 60.97;
  const auto source = open_footage(folder() / "nao-canteen-01", arguments, load_body(body_file({})));
  const std::vector<EdgeView> views = edge_views(images_for_calibration(*source));
  EXPECT_EQ(mounting_from_edges(every_second(views, 1)).recorded, (RecordedAttitude{.roll = false}));
  const HeldOutMedians medians = medians_of(views);
  EXPECT_LT(medians.after, 0.6 * medians.before);
}

}  // namespace
}  // namespace reorient
