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

/// With another line in place of the one that begins so; without it where that is empty.
std::string nao_with(std::string_view begin, std::string_view line) {
  std::string text = nao_text();
  const std::size_t at = text.find("\n" + std::string(begin));
  EXPECT_NE(at, std::string::npos) << begin;
  text.replace(at + 1, text.find('\n', at + 1) - at - 1, line);
  return text;
}

/// The message with which reading fails; empty where it does not.
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

TEST(BodyFile, OfEachShippedRobotNamesAFieldThatThereIs) {
  int robots = 0;
  for (const auto& entry : std::filesystem::directory_iterator(kAssets / "robots")) {
    if (entry.path().extension() != ".toml") continue;
    ++robots;
    const RobotBody body = load_body(entry.path());
    EXPECT_NO_THROW(load_field(kAssets / "fields" / (body.field + ".toml"))) << entry.path();
  }
  EXPECT_GE(robots, 3);
}

TEST(BodyFile, OfTheBoostersPutsTheirCamerasWhereTheyWereMeasured) {
  const RobotBody k1 = load_body(kAssets / "robots" / "booster-k1.toml");
  EXPECT_NEAR(standing_camera_height(k1), 0.88, 0.001);
  EXPECT_FALSE(k1.standing_load);
  EXPECT_FALSE(k1.lower_camera);
  EXPECT_EQ(k1.upper_camera.width, 544);
  const RobotBody t1 = load_body(kAssets / "robots" / "booster-t1.toml");
  EXPECT_NEAR(standing_camera_height(t1), 1.10, 0.001);
}

TEST(BodyFile, TellsWhatABodyDoesNotHaveByLeavingItOut) {
  const std::string text = nao_text();
  const RobotBody body = parse_body(text.substr(0, text.find("[lower_camera]")), "robot.toml");
  EXPECT_FALSE(body.lower_camera);
  EXPECT_FALSE(body.standing_load);
  EXPECT_FALSE(body.gait);
  EXPECT_FALSE(body.get_up_time);
}

TEST(BodyFile, ThatIsMissingIsNamedInOneLine) {
  try {
    static_cast<void>(load_body("nowhere/robot.toml"));
    FAIL();
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "nowhere/robot.toml: there is no such robot; assets/robots has some");
  }
}

TEST(BodyFile, WithAMistakeIsRefusedWithItsLine) {
  const std::pair<std::string, const char*> mistakes[] = {
      {"", "the key 'field' is missing"},
      {nao_with("name", "naem = \"NAO\""), "there is no key 'naem' here (did you mean 'name'?)"},
      {nao_with("name", "name = 6"), "name is a text in quotes"},
      {nao_with("name", "name = \"" + std::string(100, 'N') + "\""), "name is longer than 60 letters"},
      {nao_with("height = 0.24809", "height = 24.8"), "height is a number from 0.05 to 2.5"},
      {nao_with("height = 0.24809", "height = nan"), "height is a number from 0.05 to 2.5"},
      {nao_with("height = 0.24809", ""), "the key 'height' is missing"},
      {nao_with("order", "order = \"roll\""), "order is \"yaw, pitch\" or \"pitch, yaw\", from the torso to the head"},
      {nao_with("first_axis", "first_axis = [0.0, 0.2]"), "first_axis is a list of 3 numbers"},
      {nao_with("first_axis", "first_axis = [0.0, 0.0, inf]"), "each of first_axis is a number from -2.5 to 2.5"},
      {nao_with("  [0.486", "  [0.0, -0.6, 0.4],"), "each row's yaw is greater than the one's before"},
      {nao_with("  [0.486", "  [0.486, 0.4, -0.6],"), "the least pitch is above the most"},
      {nao_with("  [0.486", "  [0.486, 0.4],"), "each row of pitch is a list of 3 numbers"},
      {nao_with("width", "width = 640.5"), "width is a whole number from 64 to 4096"},
      {nao_with("field_of_view", "field_of_view_degrees = [180.0, 43.7]"), "is a number from 20 to 150"},
      {nao_with("standing_load", "standing_load = -1.0"), "standing_load is a number from 0.1 to 200"},
      {"feet = 5.3\n" + nao_text().substr(0, nao_text().find("[feet]")), "feet is a table: [feet]"},
      {nao_text() + "\n[wings]\nspan = 1.0\n", "there is no key 'wings' here"},
  };
  for (const auto& [text, why] : mistakes) {
    const std::string complaint = complaint_about_body(text);
    EXPECT_NE(complaint.find(why), std::string::npos) << complaint << "\nwanted: " << why;
    EXPECT_EQ(complaint.rfind("robot.toml:", 0), 0u) << complaint;
    EXPECT_EQ(complaint.find('\n'), std::string::npos) << complaint;
  }
}

TEST(BodyFile, WithoutAPitchOfTheNeckIsRefused) {
  std::string text = nao_text();
  const std::size_t begin = text.find("pitch = ["), end = text.find("\n]", begin);
  text.replace(begin, end + 2 - begin, "pitch = []");
  EXPECT_NE(complaint_about_body(text).find("pitch is a list of 1 to 64 times [yaw, least, most]"), std::string::npos);
}

}  // namespace
}  // namespace reorient
