// SPDX-License-Identifier: MIT
// The colors of the pictures are those of the live page, of the reports of experiments and of the layout for
// PlotJuggler.
#include <cstdio>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "engine/world/room_status.h"
#include "tests/paths.h"
#include "workbench/views/pictures/parts/status_color.h"

namespace reorient::pictures {
namespace {

std::string text_of(const std::string& file) {
  std::ifstream in(std::string(kSourceFolder) + "/" + file);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// "#1558d6"
std::string hex(const Color& color) {
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color.red, color.green, color.blue);
  return text;
}

/// "rgba(44, 50, 58, 0.62)"
std::string rgba(const Color& color) {
  char text[40];
  std::snprintf(text, sizeof text, "rgba(%d, %d, %d, %g)", color.red, color.green, color.blue, color.opacity);
  return text;
}

/// What the first group of the expression matches first; the light theme is the first one of a style sheet.
std::string first_match(const std::string& text, const std::string& expression) {
  std::smatch match;
  return std::regex_search(text, match, std::regex(expression)) ? match[1].str() : "nothing matches " + expression;
}

std::string variable(const std::string& sheet, const std::string& name) {
  return first_match(sheet, "--" + name + ": (#[0-9a-f]+);");
}

TEST(Palette, IsThatOfTheDrawingsOfTheLivePage) {
  const std::string page = text_of("workbench/views/live/page/source/draw/palette.js");
  const auto value = [&](const std::string& name) { return first_match(page, name + ": \"([^\"]+)\""); };
  EXPECT_EQ(value("truth"), hex(palette::truth));
  EXPECT_EQ(value("belief"), hex(palette::belief));
  EXPECT_EQ(value("opposite"), hex(palette::opposite));
  EXPECT_EQ(value("view"), hex(palette::view_particle));
  EXPECT_EQ(value("noEvidence"), hex(palette::no_evidence));
  EXPECT_EQ(value("particle"), rgba(palette::pose_particle));
  EXPECT_EQ(value("unknownTile"), rgba(palette::unknown_tile));
}

TEST(Palette, IsThatOfTheTimelineOfTheLivePage) {
  const std::string sheet = text_of("workbench/views/live/page/source/style.css");
  EXPECT_EQ(variable(sheet, "belief"), hex(palette::belief));
  EXPECT_EQ(variable(sheet, "mirrored"), hex(palette::opposite));
  EXPECT_EQ(variable(sheet, "evidence"), hex(palette::evidence));
  const std::string bands = text_of("workbench/views/live/page/source/draw/palette.js");
  for (int i = 0; i < kRoomStatuses; ++i) {
    const auto status = static_cast<RoomStatus>(i);
    const std::string name = first_match(bands, std::string(to_string(status)) + ": \"(\\w+-band)\"");
    EXPECT_EQ(variable(sheet, name), hex(status_color(status))) << to_string(status);
  }
}

TEST(Palette, IsThatOfTheReportsOfExperiments) {
  const std::string sheet = text_of("workbench/experiments/report/style.css");
  EXPECT_EQ(variable(sheet, "believed"), hex(palette::belief));
  EXPECT_EQ(variable(sheet, "mirrored"), hex(palette::opposite));
  EXPECT_EQ(variable(sheet, "evidence"), hex(palette::evidence));
  EXPECT_EQ(variable(sheet, "usable"), hex(status_color(RoomStatus::usable)));
  EXPECT_EQ(variable(sheet, "undecided"), hex(status_color(RoomStatus::fresh)));
  EXPECT_EQ(variable(sheet, "idle"), hex(status_color(RoomStatus::resting)));
}

TEST(Palette, IsThatOfTheLayoutForPlotJuggler) {
  const std::string layout = text_of("assets/views/plotjuggler.xml");
  const auto value = [&](const std::string& name) {
    return first_match(layout, "/world/confidence/" + name + "\" color=\"([^\"]+)\"");
  };
  EXPECT_EQ(value("current"), hex(palette::belief));
  EXPECT_EQ(value("opposite"), hex(palette::opposite));
  EXPECT_EQ(value("evidence"), hex(palette::evidence));
}

}  // namespace
}  // namespace reorient::pictures
