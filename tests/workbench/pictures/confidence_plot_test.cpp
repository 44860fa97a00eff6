// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/confidence_plot.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/workbench/pictures/pixels.h"
#include "workbench/views/scene/color.h"

namespace reorient::pictures {
namespace {

// Position of the curves; the same numbers as in the implementation.
constexpr int kLeft = 196;
constexpr int kRight = 1464;
constexpr int kTop = 176;
constexpr int kBottom = 576;

ConfidencePlot ten_seconds(double current, double opposite) {
  ConfidencePlot plot;
  for (int i = 0; i <= 100; ++i) plot.samples.push_back({0.1 * i, current, opposite, kNaN, kNaN});
  return plot;
}

TEST(ConfidencePlot, DrawsEachCurveAtTheHeightOfItsConfidence) {
  const Picture picture = draw_confidence_plot(ten_seconds(0.8, 0.1));
  for (const int x : {kLeft + 100, (kLeft + kRight) / 2, kRight - 100}) {
    EXPECT_TRUE(is_similar(picture.at(x, kTop + 80), palette::belief)) << x;
    EXPECT_TRUE(is_similar(picture.at(x, kTop + 360), palette::opposite)) << x;
  }
}

TEST(ConfidencePlot, LeavesAGapWithoutAConfidence) {
  ConfidencePlot plot = ten_seconds(0.8, 0.1);
  for (int i = 40; i < 60; ++i) plot.samples[static_cast<std::size_t>(i)].current = kNaN;
  const Picture picture = draw_confidence_plot(plot);
  EXPECT_FALSE(is_similar(picture.at((kLeft + kRight) / 2, kTop + 80), palette::belief));
  EXPECT_TRUE(is_similar(picture.at((kLeft + kRight) / 2, kTop + 360), palette::opposite));
}

TEST(ConfidencePlot, DrawsAGrantedCommandSolidAndARefusedOneDashed) {
  ConfidencePlot plot = ten_seconds(0.8, 0.1);
  plot.commands = {{2.5, "flip", true}, {7.5, "purge", false}};
  const Picture picture = draw_confidence_plot(plot);
  const auto longest = [&](int x, Color color) {
    int best = 0;
    int run = 0;
    for (int y = kTop; y < kBottom; ++y) {
      run = is_similar(picture.at(x, y), color, 40) ? run + 1 : 0;
      best = std::max(best, run);
    }
    return best;
  };
  EXPECT_GT(longest(kLeft + 317, palette::ink), 380);
  const int dash = std::max(longest(kLeft + 950, palette::faint_ink), longest(kLeft + 951, palette::faint_ink));
  EXPECT_GE(dash, 4);
  EXPECT_LT(dash, 12);
}

TEST(ConfidencePlot, DrawsRefusalsInSuccessiveFramesAsOne) {
  ConfidencePlot once = ten_seconds(0.8, 0.1);
  once.commands = {{2.0, "flip", false}};
  ConfidencePlot often = once;
  for (int i = 1; i < 60; ++i) often.commands.push_back({2.0 + i / 30.0, "flip", false});
  EXPECT_EQ(draw_confidence_plot(once), draw_confidence_plot(often));
}

TEST(ConfidencePlot, DrawsALaneForEachConditionAndShadesTimesWithALiftedRobot) {
  ConfidencePlot plot = ten_seconds(0.9, 0.1);
  const int height_without = draw_confidence_plot(plot).height;
  plot.conditions = {{RunCondition::lifted, 4.0, 6.0}};
  const Picture picture = draw_confidence_plot(plot);
  EXPECT_GT(picture.height, height_without);
  EXPECT_FALSE(is_similar(picture.at(kLeft + 640, kTop + 210), palette::page));
  EXPECT_TRUE(is_similar(picture.at(kLeft + 300, kTop + 210), palette::page));
  plot.conditions = {{RunCondition::training, 4.0, 6.0}};
  EXPECT_TRUE(is_similar(draw_confidence_plot(plot).at(kLeft + 640, kTop + 210), palette::page));
}

TEST(ConfidencePlot, DrawsTheEvidenceOnItsSideAndTheStatusOfTheRoom) {
  constexpr int kZero = 681, kTopOfEvidence = 606, kBottomOfEvidence = 756, kStatus = 784;
  ConfidencePlot plot = ten_seconds(0.8, 0.1);
  for (ConfidencePoint& sample : plot.samples) {
    sample.evidence = 100.0;
    sample.status = RoomStatus::usable;
  }
  const auto ink = [&](int from, int to) {
    return count(draw_confidence_plot(plot), palette::evidence, kLeft + 100, from, kRight - 100, to);
  };
  EXPECT_GT(ink(kTopOfEvidence, kZero - 10), 1000) << "for the mirrored pose";
  EXPECT_EQ(ink(kZero + 10, kBottomOfEvidence), 0);
  const Color usable = draw_confidence_plot(plot).at(kLeft + 100, kStatus);
  for (ConfidencePoint& sample : plot.samples) sample.evidence = -100.0;
  EXPECT_EQ(ink(kTopOfEvidence, kZero - 10), 0);
  EXPECT_GT(ink(kZero + 10, kBottomOfEvidence), 1000);
  for (ConfidencePoint& sample : plot.samples) sample.status = RoomStatus::symmetric;
  EXPECT_FALSE(is_similar(draw_confidence_plot(plot).at(kLeft + 100, kStatus), usable));
}

TEST(ConfidencePlot, DrawsTheThresholdsInTheColorsOfThePoses) {
  constexpr int kZero = 681, kTopOfEvidence = 606, kBottomOfEvidence = 756;
  ConfidencePlot plot = ten_seconds(0.8, 0.1);
  const auto dashes = [&](Color color, int from, int to) {
    return count(draw_confidence_plot(plot), color, kLeft + 100, from, kRight - 100, to);
  };
  EXPECT_EQ(dashes(palette::opposite, kTopOfEvidence, kZero), 0) << "the threshold is unknown";
  for (ConfidencePoint& sample : plot.samples) sample.threshold = 5.5;
  EXPECT_GT(dashes(palette::opposite, kTopOfEvidence, kZero), 300);
  EXPECT_EQ(dashes(palette::opposite, kZero, kBottomOfEvidence), 0);
  EXPECT_GT(dashes(palette::belief, kZero, kBottomOfEvidence), 300);
  EXPECT_EQ(dashes(palette::belief, kTopOfEvidence, kZero), 0);
}

TEST(ConfidencePlot, FillsTheEvidenceInTheColorOfThePoseThatItSupports) {
  constexpr int kAbove = 660, kBelow = 702, kX = kLeft + 500;
  ConfidencePlot plot = ten_seconds(0.8, 0.1);
  for (ConfidencePoint& sample : plot.samples) sample.evidence = 100.0;
  const Color mirrored = draw_confidence_plot(plot).at(kX, kAbove);
  EXPECT_GT(mirrored.red, mirrored.blue + 20);
  for (ConfidencePoint& sample : plot.samples) sample.evidence = -100.0;
  const Color believed = draw_confidence_plot(plot).at(kX, kBelow);
  EXPECT_GT(believed.blue, believed.red + 20);
}

TEST(ConfidencePlot, HasNoLegendEntryWithoutItsObject) {
  constexpr int kBottomOfLegend = 110;
  const auto legend = [&](const ConfidencePlot& plot, Color color) {
    return count(draw_confidence_plot(plot), color, 0, 70, 1500, kBottomOfLegend);
  };
  ConfidencePlot plot = ten_seconds(0.8, 0.1);
  const int without = legend(plot, palette::ink);
  for (ConfidencePoint& sample : plot.samples) sample.threshold = 5.5;
  const int with_threshold = legend(plot, palette::ink);
  EXPECT_GT(with_threshold, without);
  plot.commands = {{2.5, "flip", false}};
  const int with_refusal = legend(plot, palette::ink);
  EXPECT_GT(with_refusal, with_threshold);
  plot.commands.push_back({5.0, "flip", true});
  EXPECT_GT(legend(plot, palette::ink), with_refusal);
  EXPECT_GT(legend(plot, palette::faint_ink), 20) << "the dashes of the last entry: all entries fit";
}

TEST(ConfidencePlot, StaysWithinItsAxesForAnyValues) {
  ConfidencePlot plot = ten_seconds(1e30, -1e30);
  plot.samples.push_back({kNaN, 0.5, 0.5, 0.5, 0.5, kNaN, RoomStatus::usable, kNaN});
  plot.samples.push_back({5.0, 0.5, 0.5, 0.5, 0.5, 1e300, RoomStatus::usable, 1e300});
  plot.commands = {{kNaN, "flip", true}, {-1e300, "flip", true}, {1e300, std::string(5000, 'x'), true}};
  plot.conditions = {
      {RunCondition::down, kNaN, 3.0}, {RunCondition::down, 5.0, 2.0}, {RunCondition::down, -1e300, 1e300}};
  const Picture picture = draw_confidence_plot(plot);
  EXPECT_EQ(picture.width, 1500);
  EXPECT_EQ(count(picture, palette::page, kRight + 6, kTop, 1500, kBottom), (1500 - kRight - 6) * (kBottom - kTop));
}

TEST(ConfidencePlot, DrawsARunInWhichNothingHappened) {
  const Picture picture = draw_confidence_plot({});
  EXPECT_GT(count(picture, palette::grid), 4000);
  ConfidencePlot one;
  one.samples = {{3.0, 0.5, 0.5, 0.5, 0.5}};
  EXPECT_EQ(draw_confidence_plot(one).width, 1500);
}

}  // namespace
}  // namespace reorient::pictures
