// SPDX-License-Identifier: MIT
// `reorient look`, called as by a user, on images of the simulator that lie in a folder like real footage.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "geometry/angle.h"
#include "robots/footage/frames_table.h"
#include "tests/paths.h"
#include "tests/program/footage/decoder.h"
#include "tests/program/footage/image_files.h"
#include "tests/program/footage/simulated_footage.h"
#include "tests/program/program_run.h"
#include "tests/robots/exif_block.h"
#include "tests/temporary_folder.h"
#include "workbench/field_images/recoloring.h"
#include "workbench/footage/decoder_library.h"
#include "workbench/footage/open_footage.h"

namespace reorient {
namespace {

using Words = std::vector<std::string>;

class Look : public testing::Test {
 protected:
  static const std::filesystem::path& recorded() {
    static const TemporaryFolder folder;
    constexpr int kImages = 60;
    if (!std::filesystem::exists(folder.path() / "frames.csv")) write_simulated_footage(folder.path(), kImages);
    return folder.path();
  }

  void SetUp() override { need_decoder(); }

  ProgramRun look(Words words) const {
    words.insert(words.begin(), "look");
    words.insert(words.end(),
                 {"--out", (folder_.path() / "out").string(), "--json", (folder_.path() / "o.json").string()});
    return run_reorient(words);
  }
  nlohmann::json seen() const { return nlohmann::json::parse(std::ifstream(folder_.path() / "o.json")); }

  TemporaryFolder folder_;
};

TEST_F(Look, ShowsWhatIsSeenInEachImageOfAFolder) {
  const ProgramRun run = look({recorded().string(), "--every", "4"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto images = seen();
  ASSERT_EQ(images.size(), 15u);
  std::size_t line_points = 0;
  for (const auto& image : images) {
    EXPECT_EQ(image["pitch"]["source"], "recorded");
    EXPECT_EQ(image["line_points"].size(), image["counts"]["line_points"].get<std::size_t>());
    EXPECT_EQ(image["camera"]["width"], 160);
    line_points += image["line_points"].size();
  }
  EXPECT_GT(line_points, 100u);
  EXPECT_FALSE(std::filesystem::is_empty(folder_.path() / "out"));
}

/// The images of a simulated walk as single files, so that their table is not used.
struct WalkImages {
  std::vector<std::string> files;
  std::vector<FrameRow> rows;
};

WalkImages walk_images(const std::filesystem::path& folder, int images, int width, double head_pitch,
                       double lens_blur = 0.0) {
  write_simulated_footage(folder, images, width, head_pitch, lens_blur);
  std::ifstream in(folder / "frames.csv");
  std::ostringstream text;
  text << in.rdbuf();
  WalkImages walk{{}, parse_frames(text.str(), "frames.csv")};
  for (const FrameRow& row : walk.rows) walk.files.push_back((folder / row.image).string());
  return walk;
}

/// The searched pitches that are known, and those of them within 1.5 degrees of the recorded one.
struct FoundPitches {
  int known = 0, right = 0;
};

FoundPitches found_pitches(const nlohmann::json& images, const std::vector<FrameRow>& rows) {
  FoundPitches found;
  EXPECT_EQ(images.size(), rows.size());
  if (images.size() != rows.size()) return found;
  for (std::size_t i = 0; i < images.size(); ++i) {
    const auto& pitch = images[i]["pitch"];
    EXPECT_EQ(pitch["source"], "searched");
    if (!pitch["known"].get<bool>()) continue;
    ++found.known;
    const double error = pitch["degrees"].get<double>() - to_degrees(*rows[i].value(FrameColumn::pitch));
    EXPECT_LT(std::abs(error), 3.0) << images[i]["file"];
    found.right += std::abs(error) < 1.5 ? 1 : 0;
  }
  return found;
}

TEST_F(Look, FindsThePitchOfImagesThatShowLines) {
  const WalkImages walk = walk_images(folder_.path() / "walk", 24, 640, 0.25);
  const ProgramRun run = look(walk.files);
  ASSERT_EQ(run.code, 0) << run.err;
  const FoundPitches found = found_pitches(seen(), walk.rows);
  EXPECT_GE(found.known, 18) << run.out;
  EXPECT_GE(10 * found.right, 9 * found.known) << run.out;
}

/// Blur makes thin lines as wide as near ones, only fainter. If no line is wide enough to show how bright white is, the
/// pitch may stay unknown.
TEST_F(Look, FindsThePitchOfBlurredImages) {
  constexpr double kLensBlur = 0.0025;  // rad, 1.4 pixels
  const WalkImages walk = walk_images(folder_.path() / "walk", 24, 640, 0.1, kLensBlur);
  const ProgramRun run = look(walk.files);
  ASSERT_EQ(run.code, 0) << run.err;
  const FoundPitches found = found_pitches(seen(), walk.rows);
  EXPECT_GE(found.known, 10) << run.out;
  EXPECT_GE(10 * found.right, 7 * found.known) << run.out;
}

TEST_F(Look, DoesNotReportAPitchForImagesOfTheHallOnly) {
  WalkImages walk = walk_images(folder_.path() / "walk", 8, 320, -0.6);
  walk.files.erase(walk.files.begin(), walk.files.begin() + 2);  // the head is still moving up
  const ProgramRun run = look(walk.files);
  ASSERT_EQ(run.code, 0) << run.err;
  for (const auto& image : seen()) {
    EXPECT_EQ(image["pitch"]["source"], "searched");
    EXPECT_EQ(image["pitch"]["known"], false) << image["image"];
    EXPECT_TRUE(image["pitch"]["degrees"].is_null());
  }
  EXPECT_NE(run.out.find("pitch searched for in 6, unknown in 6"), std::string::npos) << run.out;
}

/// A JPEG of which the left half is black and the right half is white, with `segment` after its first two bytes.
std::string black_and_white(const TemporaryFolder& folder, const std::vector<std::uint8_t>& segment) {
  std::string ppm = "P6 160 120 255\n";
  for (int y = 0; y < 120; ++y)
    ppm += std::string(std::size_t{3} * 80, '\0') + std::string(std::size_t{3} * 80, '\xff');
  const std::vector<std::byte> jpeg = encoded(folder.write("halves.ppm", ppm), ".jpg");
  std::string file(reinterpret_cast<const char*>(jpeg.data()), jpeg.size());
  file.insert(2, std::string(segment.begin(), segment.end()));
  return file;
}

TEST_F(Look, ShowsAnImageAsItsOrientationSays) {
  const auto luma = [&](int orientation, int x, int y) {
    const auto file = folder_.write("photo.jpg", black_and_white(folder_, exif_segment(orientation)));
    return int{read_image(file, decoder_library()).view().at(x, y).y};
  };
  EXPECT_EQ(luma(1, 10, 60), 0);
  EXPECT_EQ(luma(3, 10, 60), 255) << "rotated by 180 degrees";
  EXPECT_EQ(luma(6, 60, 10), 0) << "rotated clockwise: the left side is on top";
  EXPECT_EQ(luma(8, 60, 10), 255) << "rotated counterclockwise";
  const ProgramRun run = look({folder_.write("photo.jpg", black_and_white(folder_, exif_segment(6))).string()});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(seen()[0]["camera"]["width"], 120);
  EXPECT_EQ(seen()[0]["camera"]["height"], 160);
}

TEST_F(Look, NamesWhyAnImageCannotBeDecoded) {
  const std::string jpeg = black_and_white(folder_, {});
  const auto refusal = [&](const std::string& name, const std::string& bytes) {
    const ProgramRun run = look({folder_.write(name, bytes).string()});
    EXPECT_EQ(run.code, kBadInput);
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
    return run.err;
  };
  const std::size_t frame = jpeg.find("\xff\xc0");
  std::string deep = jpeg, lossless = jpeg;
  deep[frame + 4] = 12;
  lossless[frame + 1] = '\xc3';
  EXPECT_NE(refusal("deep.jpg", deep).find("deep.jpg: expected a JPEG with 8 bits per color, found 12"),
            std::string::npos);
  EXPECT_NE(refusal("lossless.jpg", lossless).find("found a lossless or hierarchical one"), std::string::npos);
  const std::vector<std::byte> png = encoded(folder_.path() / "halves.ppm", ".png");
  const std::string half(reinterpret_cast<const char*>(png.data()), png.size() / 2);
  EXPECT_NE(refusal("half.png", half).find("half.png: expected a whole PNG"), std::string::npos);
}

TEST_F(Look, DoesNotReportAPitchForAPlainImage) {
  const std::string ppm = "P6 160 120 255\n" + std::string(160 * 120 * 3, '\x60');
  const ProgramRun run = look({folder_.write("plain.ppm", ppm).string()});
  ASSERT_EQ(run.code, 0) << run.err;
  EXPECT_EQ(seen()[0]["pitch"]["known"], false);
  EXPECT_NE(run.out.find("pitch unknown"), std::string::npos) << run.out;
}

TEST_F(Look, UsesTheGivenPitch) {
  const ProgramRun run = look({(recorded() / "images/0000.png").string(), "--pitch", "12", "--height", "0.6"});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto image = seen()[0];
  EXPECT_EQ(image["pitch"]["source"], "given");
  EXPECT_NEAR(image["pitch"]["used_degrees"].get<double>(), 12.0, 0.01);
  EXPECT_NEAR(image["camera_height_m"].get<double>(), 0.6, 1e-6);
}

TEST_F(Look, ReportsUnusableImagesInOneLine) {
  const std::pair<Words, const char*> cases[] = {
      {{"/nowhere.png"}, "/nowhere.png"},
      {{folder_.write("text.png", "no image").string()}, "text.png: expected an image"},
      {{(recorded() / "images/0000.png").string(), "--pitch", "100"}, "--pitch"},
      {{(recorded() / "images/0000.png").string(), "--camera", "missing"}, "missing"},
  };
  for (const auto& [words, what] : cases) {
    const ProgramRun run = look(words);
    EXPECT_EQ(run.code, kBadInput) << what;
    EXPECT_NE(run.err.find(what), std::string::npos) << run.err;
    EXPECT_EQ(std::count(run.err.begin(), run.err.end(), '\n'), 1) << run.err;
  }
}

/// Real images of NAOs on real fields.
class LookAtRealImages : public DecodedSharedDataTest {
 protected:
  LookAtRealImages() : DecodedSharedDataTest("images") {}
};

/// The camera poses were estimated by hand: in the first image from the size of the center circle
/// (tests/perception/field/real_images_test.cpp), in the second one from the goal. The horizon crosses its posts at the
/// camera's height, and its slope from post to post is the roll.
TEST_F(LookAtRealImages, FindsTheirPitchByLines) {
  const TemporaryFolder out;
  const std::string json = (out.path() / "o.json").string();
  const ProgramRun run = run_reorient({"look", (folder() / "nao-v4-top-640x480-a.png").string(),
                                       (folder() / "nao-v4-top-640x480-b.png").string(), "--fov-degrees", "60.97",
                                       "--out", (out.path() / "out").string(), "--json", json});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto images = nlohmann::json::parse(std::ifstream(json));
  const double estimated[] = {21.9, 12.2};
  for (std::size_t i = 0; i < images.size(); ++i) {
    EXPECT_EQ(images[i]["pitch"]["known"], true);
    EXPECT_NEAR(images[i]["pitch"]["used_degrees"].get<double>(), estimated[i], 2.0);
    EXPECT_GT(images[i]["counts"]["line_points"].get<int>(), 40);
  }
  EXPECT_NEAR(images[1]["roll_degrees"].get<double>(), -4.4, 2.0);
}

TEST_F(LookAtRealImages, FindsThePitchOnACarpetThatIsNotGreen) {
  const TemporaryFolder out;
  const std::string json = (out.path() / "o.json").string(), reddish = (out.path() / "reddish.png").string();
  const Image image = read_image(folder() / "nao-v4-top-640x480-b.png", decoder_library());
  write_image(reddish, recolored(image.view(), {.cr = 16}).view());
  const ProgramRun run =
      run_reorient({"look", reddish, "--fov-degrees", "60.97", "--out", (out.path() / "out").string(), "--json", json});
  ASSERT_EQ(run.code, 0) << run.err;
  const auto seen = nlohmann::json::parse(std::ifstream(json)).at(0);
  EXPECT_EQ(seen["pitch"]["known"], true) << run.out;
  EXPECT_NEAR(seen["pitch"]["used_degrees"].get<double>(), 12.2, 2.0);
  EXPECT_GT(seen["counts"]["line_points"].get<int>(), 40);
}

}  // namespace
}  // namespace reorient
