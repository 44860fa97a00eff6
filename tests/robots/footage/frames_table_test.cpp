// SPDX-License-Identifier: MIT
// Tables of footage: what is read, and that all other text is refused with one line that names the position.
#include "robots/footage/frames_table.h"

#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace reorient {
namespace {

constexpr const char* kName = "frames.csv";

std::vector<FrameRow> rows_of(std::string_view text, const ColumnHeaders& headers = {}) {
  return parse_frames(text, kName, headers);
}

/// The message of the exception; empty: the table was accepted.
std::string refusal_of(std::string_view text, const ColumnHeaders& headers = {}) {
  try {
    static_cast<void>(rows_of(text, headers));
  } catch (const BadFootage& error) {
    return error.what();
  }
  return "";
}

TEST(FramesTable, HasAPoseACameraAndDeadReckoningForEachImage) {
  const auto rows = rows_of(
      "image,time_s,x_m,y_m,rotation_rad,odometry_x_m,odometry_y_m,odometry_rotation_rad,camera_height_m,roll_rad,"
      "pitch_rad\n"
      "a.jpg,0.5,1,-2,0.25,3,4,-0.5,0.6,0.1,0.2\n"
      "b.jpg,1.5,1,-2,0.25,3,4,-0.5,0.6,0,0\n");
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].image, "a.jpg");
  EXPECT_EQ(rows[0].line, 2);
  EXPECT_EQ(rows[0].value(FrameColumn::time), 0.5);
  EXPECT_EQ(rows[0].pose()->position, Eigen::Vector2d(1.0, -2.0));
  EXPECT_EQ(rows[0].pose()->rotation, 0.25);
  EXPECT_EQ(rows[0].odometry()->rotation, -0.5);
  const Isometry3 camera = rows[0].robot_from_camera(0.4);
  EXPECT_EQ(camera.translation(), Eigen::Vector3d(0.0, 0.0, 0.6));
  EXPECT_LT(camera.linear()(2, 0), -0.19);  // it points down
  EXPECT_GT(camera.linear()(2, 1), 0.09);   // its left side is up
}

TEST(FramesTable, MayHaveSemicolonsAndDecimalCommas) {
  const auto rows = rows_of(
      "\xEF\xBB\xBFimage;time_ms;x_cm;y_cm;rotation_deg\r\n"
      "\"a;b.jpg\";500,5;100;-20,5;90\r\n"
      "\r\n");
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].image, "a;b.jpg");
  EXPECT_NEAR(*rows[0].value(FrameColumn::time), 0.5005, 1e-12);
  EXPECT_NEAR(rows[0].pose()->position.y(), -0.205, 1e-12);
  EXPECT_NEAR(rows[0].pose()->rotation, kPi / 2.0, 1e-12);
}

TEST(FramesTable, MayHaveOtherColumnNames) {
  const auto rows = rows_of("file\tstamp\tyaw\tnoise\na.png\t1500000000\t90\tx\n",
                            {{"image", "file"}, {"time", "stamp:ns"}, {"rotation", "yaw:deg"}});
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].image, "a.png");
  EXPECT_EQ(rows[0].value(FrameColumn::time), 1.5);
  EXPECT_FALSE(rows[0].pose());
  EXPECT_NEAR(*rows[0].heading(), kPi / 2.0, 1e-12);
}

TEST(FramesTable, TakesTheUnitOfANamedColumnFromItsHeader) {
  const auto rows = rows_of("stamp_ms,yaw,tilt_deg\n1500,1,90\n",
                            {{"time", "stamp_ms"}, {"rotation", "yaw:deg"}, {"pitch", "tilt_deg"}});
  EXPECT_NEAR(*rows.at(0).value(FrameColumn::time), 1.5, 1e-12);
  EXPECT_NEAR(*rows.at(0).value(FrameColumn::rotation), kPi / 180.0, 1e-12);
  EXPECT_NEAR(*rows.at(0).value(FrameColumn::pitch), 0.5 * kPi, 1e-12);
  EXPECT_FALSE(rows_of("time_s,pitch_rad\n1,1\n", {{"pitch", ""}}).at(0).value(FrameColumn::pitch)) << "left out";
}

TEST(FramesTable, MayHaveEmptyCellsForUnknownValues) {
  const auto rows = rows_of("image,time_s,x_m,y_m,rotation_rad\na,1,,,\nb,2,1,1,1\n");
  EXPECT_FALSE(rows[0].pose());
  EXPECT_TRUE(rows[1].pose());
  EXPECT_EQ(rows[0].robot_from_camera(0.4).translation().z(), 0.4);
}

struct BadTable {
  std::string_view text, what;
  ColumnHeaders headers{};
};

TEST(FramesTable, ReportsAnErrorInOneLineWithItsPosition) {
  const BadTable tables[] = {
      {"", "frames.csv:1: expected a line of column headers, found an empty file"},
      {"image,time_s\n", "frames.csv:1: expected a row for each image, found none"},
      {"image,time_s\na,1\nb\n", "frames.csv:3: expected 2 cells, found 1"},
      {"image,time_s\na,1\nb,1\n", "frames.csv:3: expected a time after that of line 2"},
      {"image,time_s\na,2\nb,1\n", "frames.csv:3: expected a time after that of line 2"},
      {"image,time_s\na,\n", "frames.csv:2: expected a time, found an empty cell"},
      {"image,time_s\na,nan\n", "frames.csv:2: 'time_s': expected a finite number, found 'nan'"},
      {"image,time_s\na,inf\n", "frames.csv:2: 'time_s': expected a finite number, found 'inf'"},
      {"image,time_s\na,1x\n", "frames.csv:2: 'time_s': expected a finite number, found '1x'"},
      {"image,x_m,y_m,rotation_rad\na,1,nan,2\n", "frames.csv:2: 'y_m': expected a finite number, found 'nan'"},
      {"image,x_m,y_m,rotation_rad\na,1e9,0,2\n",
       "frames.csv:2: 'x_m': expected at most 1e+04 m, found '1e9'; a header ends with the unit, as in x_cm"},
      {"image,x_m,y_m,rotation_rad\na,1,0,90\n",
       "frames.csv:2: 'rotation_rad': expected at most 62.8 rad, found '90'; a header ends with the unit, as in "
       "rotation_deg"},
      {"image,pitch_rad\na,-12.5\n", "frames.csv:2: 'pitch_rad': expected at most 6.28 rad, found '-12.5'"},
      {"image,camera_height_m\na,51\n", "frames.csv:2: 'camera_height_m': expected at most 10 m, found '51'"},
      {"image,x_m,y_m,rotation_rad\na,1,,2\n", "frames.csv:2: expected x, y and rotation together"},
      {"image,x_m,y_m\na,1,2\n", "frames.csv:1: expected all of the columns x, y, rotation, or none of them"},
      {"image,x_m,y_m,yaw_rad\na,1,2,3\n",
       "frames.csv:1: expected all of the columns x, y, rotation, or none of them, found 'image', 'x_m', 'y_m', "
       "'yaw_rad'; if a column has another name, use --column rotation=HEADER[:UNIT]"},
      {"image,odometry_rotation_rad\na,1\n", "frames.csv:1: expected all of the columns odometry_x"},
      {"image,time_s,time_ms\na,1,1\n", "frames.csv:1: expected one column for time, found two"},
      {"image,image\na,1\n", "frames.csv:1: expected one column with images, found two"},
      {"image,time_s\n,1\n", "frames.csv:2: expected the name of an image, found an empty cell"},
      {"image,time_s\n\"a,1\n", "frames.csv:2: expected the end of a text in quotes, found the end of the file"},
      {"image,time_s\na,1\n",
       "frames.csv:1: expected a column 'stamp' for time, found 'image', 'time_s'",
       {{"time", "stamp"}}},
      {"image,t\na,1\n", "frames.csv:1: expected a unit of time (s, ms, us, ns), found 'h'", {{"time", "t:h"}}},
  };
  for (const BadTable& table : tables) {
    const std::string refusal = refusal_of(table.text, table.headers);
    EXPECT_TRUE(refusal.starts_with(table.what)) << refusal << "\nexpected: " << table.what;
    EXPECT_EQ(refusal.find('\n'), std::string::npos);
  }
}

TEST(FramesTable, MayHaveAMillionRows) {
  std::string text = "image,time_s,x_m,y_m,rotation_rad\n";
  constexpr int kRows = 1'000'000;
  for (int i = 0; i < kRows; ++i) text.append("a.jpg,").append(std::to_string(i)).append(",1,2,3\n");
  EXPECT_EQ(rows_of(text).size(), static_cast<std::size_t>(kRows));
}

/// A valid table with some bytes changed, truncated at a random position.
std::string damaged_table() {
  std::string text = "image,time_s,x_m,y_m,rotation_rad\na.jpg,1,2,3,4\n\"b\"\"c\",2,3,4,5\n";
  const int changes = *rc::gen::inRange(0, 5);
  for (int i = 0; i < changes; ++i)
    text[*rc::gen::inRange<std::size_t>(0, text.size())] =
        *rc::gen::element(',', ';', '"', '\n', '\t', '\0', '9', 'e', '-', '\xff');
  return text.substr(0, *rc::gen::inRange<std::size_t>(0, text.size() + 1));
}

RC_GTEST_PROP(FramesTable, WithAnyBytesIsReadOrRefused, ()) {
  const std::string text = *rc::gen::oneOf(rc::gen::exec(damaged_table), rc::gen::arbitrary<std::string>());
  const std::string refusal = refusal_of(text);
  RC_ASSERT(refusal.empty() || refusal.starts_with("frames.csv:"));
  if (!refusal.empty()) return;
  for (const FrameRow& row : rows_of(text)) {
    if (const auto pose = row.pose()) RC_ASSERT(pose->position.allFinite() && std::isfinite(pose->rotation));
    RC_ASSERT(row.robot_from_camera(0.5).matrix().allFinite());
  }
}

}  // namespace
}  // namespace reorient
