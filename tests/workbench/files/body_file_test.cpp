// SPDX-License-Identifier: MIT
#include "workbench/files/body_file.h"

#include <fstream>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "geometry/bytes.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"
#include "workbench/files/field_file.h"

namespace reorient {
namespace {

const std::filesystem::path kAssets = std::filesystem::path(kSourceFolder) / "assets";

std::string nao_text() {
  std::ostringstream text;
  text << std::ifstream(kAssets / "robots" / "nao-v6.toml").rdbuf();
  return text.str();
}

/// The file with `line` instead of the line that starts with `begin`; empty: without that line.
std::string nao_with(std::string_view begin, std::string_view line) {
  std::string text = nao_text();
  const std::size_t at = text.find("\n" + std::string(begin));
  EXPECT_NE(at, std::string::npos) << begin;
  text.replace(at + 1, text.find('\n', at + 1) - at - 1, line);
  return text;
}

/// The error message of reading; empty: success.
std::string complaint_about_body(const std::string& text) {
  try {
    static_cast<void>(parse_body(text, "robot.toml"));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

std::vector<std::byte> bytes_of_body(const RobotBody& body) {
  std::vector<std::byte> bytes;
  ByteWriter out(bytes);
  out(body);
  return bytes;
}

TEST(BodyFile, OfTheNaoHasTheDefaultsOfTheCode) {
  EXPECT_EQ(bytes_of_body(load_body(kAssets / "robots" / "nao-v6.toml")), bytes_of_body(RobotBody()));
}

TEST(BodyFile, OfEachShippedRobotNamesAnExistingField) {
  int robots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kAssets / "robots")) {
    if (entry.path().extension() != ".toml") continue;
    ++robots;
    const RobotBody body = load_body(entry.path());
    EXPECT_NO_THROW(load_field(kAssets / "fields" / (body.field + ".toml"))) << entry.path();
  }
  EXPECT_GE(robots, 3);
}

TEST(BodyFile, OfTheBoostersHasTheMeasuredCameraPositions) {
  const RobotBody k1 = load_body(kAssets / "robots" / "booster-k1.toml");
  EXPECT_NEAR(standing_camera_height(k1), 0.88, 0.001);
  EXPECT_FALSE(k1.standing_load);
  EXPECT_FALSE(k1.lower_camera);
  EXPECT_EQ(k1.upper_camera.width, 544);
  const RobotBody t1 = load_body(kAssets / "robots" / "booster-t1.toml");
  EXPECT_NEAR(standing_camera_height(t1), 1.10, 0.001);
}

TEST(BodyFile, OmitsWhatABodyDoesNotHave) {
  const std::string text = nao_text();
  const RobotBody body = parse_body(text.substr(0, text.find("[lower_camera]")), "robot.toml");
  EXPECT_FALSE(body.lower_camera);
  EXPECT_FALSE(body.standing_load);
  EXPECT_FALSE(body.gait);
  EXPECT_FALSE(body.get_up_time);
}

TEST(BodyFile, MayDescribeAFisheye) {
  const RobotBody body = load_body(std::filesystem::path(kSourceFolder) / "tests/robots/bodies/fisheye-160.toml");
  EXPECT_EQ(body.upper_camera.projection, CameraProjection::fisheye);
  EXPECT_EQ(body.upper_camera.k4, -0.0002);
  const CameraModel camera = camera_model(body.upper_camera, 640, 528);
  EXPECT_NEAR(to_degrees(camera.horizontal_field_of_view()), 160.0, 1e-6);
  EXPECT_LT(camera.ray({0.0, 0.0}).x(), 0.0) << "its corners look backward";
}

/// The NAO's file with these keys of a lens in its first camera.
std::string nao_with_lens(const std::string& keys) {
  std::string text = nao_with("field_of_view", "");
  const std::size_t at = text.find("\ndistortion");
  text.replace(at + 1, text.find('\n', at + 1) - at - 1, keys);
  return text;
}

TEST(BodyFile, AcceptsACalibrationOfOpenCv) {
  const RobotBody body = parse_body(
      nao_with_lens("focal = [611.5, 612.25]\ncenter = [322.0, 236.5]\ndistortion = [0.05, -0.08, 0.001, 0.002, 0.02]"),
      "robot.toml");
  const CameraModel camera = camera_model(body.upper_camera, 640, 480);
  EXPECT_NEAR(camera.focal.x(), 611.5, 1e-9);
  EXPECT_NEAR(camera.focal.y(), 612.25, 1e-9);
  EXPECT_EQ(camera.center, Eigen::Vector2d(322.0, 236.5));
  EXPECT_EQ(camera.k3, 0.02);
  EXPECT_EQ(camera_model(body.upper_camera, 320, 240), camera.scaled_to(320, 240));
  const RobotBody wide = parse_body(nao_with_lens("model = \"fisheye\"\nfocal = [200.0, 201.0]"), "robot.toml");
  EXPECT_NEAR(camera_model(wide.upper_camera, 640, 480).focal.y(), 201.0, 1e-9);
  EXPECT_EQ(bytes_of_body(wide).size(), bytes_of_body(body).size() - sizeof(Eigen::Vector2d));
}

TEST(BodyFile, WithAMistakeInALensIsRefusedWithItsLine) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"focal = [600.0, 600.0]", "expected the key 'distortion', found none"},
      {"distortion = [0.0, 0.0]", "expected the key 'field_of_view_degrees' or 'focal', found neither"},
      {"focal = [600.0, 600.0]\nfield_of_view_degrees = [60.0, 50.0]\ndistortion = [0.0, 0.0]",
       "expected either 'focal' or 'field_of_view_degrees', found both"},
      {"focal = [0.0, 600.0]\ndistortion = [0.0, 0.0]", "each of focal: expected a number from 1 to "},
      {"focal = [600.0, 600.0]\ndistortion = [0.0, nan]", "each of distortion: expected a number from -100 to 100"},
      {"focal = [600.0, 600.0]\ndistortion = [0.0, 0.0, 0.0]",
       "distortion: expected 0, 2, 4, 5 or 8 coefficients for a pinhole camera, found 3"},
      {"focal = [600.0, 600.0]\nmodel = \"fisheye\"\ndistortion = [0.0, 0.0]",
       "distortion: expected 0 or 4 coefficients for a fisheye camera, found 2"},
      {"focal = [600.0, 600.0]\nmodel = \"mirror\"\ndistortion = [0.0, 0.0]",
       "expected model \"pinhole\", \"fisheye\" or \"equirectangular\", found \"mirror\""},
      {"focal = [600.0, 600.0]\ndistortion = [-2.0, 0.0]", "the distortion folds back"},
      {"focal = [600.0, 600.0]\ndistortion = [-2.0, 0.0, 0.0, 0.0, 0.1]", "the distortion folds back"},
      {"focal = [60.0, 60.0]\nmodel = \"equirectangular\"", "or the field of view is too wide"},
  };
  for (const auto& [keys, why] : mistakes) {
    const std::string complaint = complaint_about_body(nao_with_lens(keys));
    EXPECT_NE(complaint.find(why), std::string::npos) << complaint << "\nexpected: " << why;
    EXPECT_EQ(complaint.rfind("robot.toml:", 0), 0u) << complaint;
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
  }
}

TEST(BodyFile, ThatIsMissingIsNamedInOneLine) {
  try {
    static_cast<void>(load_body("nowhere/robot.toml"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "nowhere/robot.toml: expected a file (robot), found none; examples in assets/robots");
  }
}

TEST(BodyFile, WithAMistakeIsRefusedWithItsLine) {
  const std::pair<std::string, const char*> mistakes[] = {
      {"", "expected the key 'field', found none"},
      {nao_with("name", "naem = \"NAO\""), "unknown key 'naem' (did you mean 'name'?)"},
      {nao_with("name", "name = 6"), "name: expected a text in quotes, found 6"},
      {nao_with("name", "name = \"" + std::string(100, 'N') + "\""), "name: expected at most 60 letters, found 100"},
      {nao_with("height = 0.24809", "height = 24.8"), "height: expected a number from 0.05 to 2.5, found 24.8"},
      {nao_with("height = 0.24809", "height = nan"), "height: expected a number from 0.05 to 2.5"},
      {nao_with("height = 0.24809", ""), "expected the key 'height', found none"},
      {nao_with("order", "order = \"roll\""),
       "order: expected \"yaw, pitch\" or \"pitch, yaw\", from the torso to the head, found 'roll'"},
      {nao_with("first_axis", "first_axis = [0.0, 0.2]"), "first_axis: expected a list of 3 numbers, found [0, 0.2]"},
      {nao_with("first_axis", "first_axis = [0.0, 0.0, inf]"),
       "each of first_axis: expected a number from -2.5 to 2.5"},
      {nao_with("  [0.486", "  [0.0, -0.6, 0.4],"),
       "expected non-negative yaw that increases from row to row, found [0, -0.6, 0.4]"},
      {nao_with("  [0.486", "  [0.486, 0.4, -0.6],"),
       "expected the least pitch not above the most, found [0.486, 0.4, -0.6]"},
      {nao_with("  [0.486", "  [0.486, 0.4],"), "each row of pitch: expected a list of 3 numbers, found [0.486, 0.4]"},
      {nao_with("width", "width = 640.5"), "width: expected a whole number from 64 to 4096, found 640.5"},
      {nao_with("field_of_view", "field_of_view_degrees = [180.0, 43.7]"), "expected a number from 20 to 150"},
      {nao_with("standing_load", "standing_load = -1.0"), "standing_load: expected a number from 0.1 to 200, found -1"},
      {"feet = 5.3\n" + nao_text().substr(0, nao_text().find("[feet]")), "feet: expected a table [feet], found 5.3"},
      {nao_text() + "\n[wings]\nspan = 1.0\n", "unknown key 'wings'"},
  };
  for (const auto& [text, why] : mistakes) {
    const std::string complaint = complaint_about_body(text);
    EXPECT_NE(complaint.find(why), std::string::npos) << complaint << "\nexpected: " << why;
    EXPECT_EQ(complaint.rfind("robot.toml:", 0), 0u) << complaint;
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
  }
}

TEST(BodyFile, WithoutAPitchOfTheNeckIsRefused) {
  std::string text = nao_text();
  const std::size_t begin = text.find("pitch = ["), end = text.find("\n]", begin);
  text.replace(begin, end + 2 - begin, "pitch = []");
  EXPECT_NE(complaint_about_body(text).find("pitch: expected 1 to 64 rows [yaw, least, most], found []"),
            std::string::npos);
}

}  // namespace
}  // namespace reorient
