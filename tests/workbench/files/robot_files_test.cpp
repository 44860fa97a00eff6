// SPDX-License-Identifier: MIT
// Files of one robot or team: initial poses of players, mounting of cameras.
#include <string>

#include <gtest/gtest.h>

#include "tests/temporary_folder.h"
#include "workbench/files/calibration_file.h"
#include "workbench/files/places_file.h"

namespace reorient {
namespace {

template <typename Parse>
std::string complaint(Parse parse, const std::string& text) {
  try {
    static_cast<void>(parse(text, "file.toml"));
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return "";
}

TEST(PlacesFile, ContainsThePoseOfEachPlayer) {
  const Places places = parse_places("player_2 = [-3.2, -3.0, 90.0]\nplayer_20 = [1, 2, -180]\n", "file.toml");
  ASSERT_TRUE(places[1]);
  EXPECT_DOUBLE_EQ(places[1]->position.x(), -3.2);
  EXPECT_NEAR(places[1]->rotation, kPi / 2.0, 1e-12);
  EXPECT_TRUE(places[19]);
  EXPECT_FALSE(places[0]);
}

TEST(PlacesFile, IsRefusedInOneLine) {
  EXPECT_EQ(complaint(parse_places, "player_2 = [1, 2]"),
            "file.toml:1: player_2: expected a list of 3 numbers, found [1, 2]");
  EXPECT_NE(complaint(parse_places, "player_21 = [1, 2, 3]").find("unknown key 'player_21'"), std::string::npos);
  EXPECT_NE(complaint(parse_places, "player_1 = [nan, 2, 3]"), "");
  EXPECT_EQ(complaint(parse_places, "player_1 = [1, -101, 3]"),
            "file.toml:1: player_1: expected a pose within 100 m of the field's center along each axis and within 100 "
            "turns, found 1 m, -101 m, 0 rad");
  EXPECT_NE(complaint(parse_places, "player_1 = "), "");
  EXPECT_THROW(load_places("/nowhere/places.toml"), std::runtime_error);
}

TEST(CalibrationFile, IsReadAsItWasWritten) {
  const Calibration written{{CameraOffset{from_degrees(1.25), from_degrees(-0.5)},
                             CameraOffset{0.0, from_degrees(2.0), from_degrees(-3.1), 0.0123}},
                            {.roll = false}};
  const Calibration read = parse_calibration(to_toml(written), "file.toml");
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(read.offsets[i].tilt, written.offsets[i].tilt, 1e-4);
    EXPECT_NEAR(read.offsets[i].pan, written.offsets[i].pan, 1e-4);
    EXPECT_NEAR(read.offsets[i].roll, written.offsets[i].roll, 1e-4);
    EXPECT_NEAR(read.offsets[i].height, written.offsets[i].height, 1e-4);
  }
  EXPECT_EQ(read.recorded, written.recorded);
  EXPECT_EQ(to_toml({}).find("footage"), std::string::npos);
}

TEST(CalibrationFile, MayLeaveOutValuesOfTheDataSheet) {
  const Calibration calibration = parse_calibration("[lower]\ntilt_degrees = 1\n", "file.toml");
  EXPECT_EQ(calibration.offsets[0].tilt, 0.0);
  EXPECT_NEAR(calibration.offsets[1].tilt, from_degrees(1.0), 1e-12);
}

TEST(CalibrationFile, IsRefusedInOneLine) {
  EXPECT_NE(complaint(parse_calibration, "[uper]\n").find("did you mean 'upper'?"), std::string::npos);
  EXPECT_NE(complaint(parse_calibration, "[upper]\ntilt_degrees = 40\n"), "");
  EXPECT_NE(complaint(parse_calibration, "[upper]\ntilt_degrees = \"much\"\n"), "");
  EXPECT_NE(complaint(parse_calibration, "[upper]\nheight_m = 0.5\n"), "");
  EXPECT_NE(complaint(parse_calibration, "upper = 3\n"), "");
  EXPECT_NE(complaint(parse_calibration, "[footage]\nrecorded_roll = 0\n"), "");
  EXPECT_NE(complaint(parse_calibration, "[footage]\nroll = false\n"), "");
}

}  // namespace
}  // namespace reorient
