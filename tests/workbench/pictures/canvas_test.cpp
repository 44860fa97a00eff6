// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/canvas/canvas.h"

#include <cmath>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/workbench/pictures/pixels.h"
#include "workbench/views/pictures/parts/field_drawing.h"

namespace reorient::pictures {
namespace {

constexpr Color kWhite{255, 255, 255};
constexpr Color kRed{200, 0, 0};

TEST(Canvas, FillsExactlyThePixelsOfABox) {
  Canvas canvas(20, 10, kWhite);
  canvas.fill_box({3.0, 2.0, 5.0, 4.0}, kRed);
  const Picture picture = canvas.finish();
  EXPECT_EQ(count(picture, kRed, 3, 2, 8, 6), 20);
  EXPECT_EQ(count(picture, kRed), 20);
  EXPECT_EQ(count(picture, kWhite), 180);
}

TEST(Canvas, BlendsATranslucentColorWithTheBackground) {
  Canvas canvas(8, 8, kWhite);
  canvas.fill_box({0.0, 0.0, 8.0, 8.0}, Color{0, 0, 0}.with_opacity(0.5));
  EXPECT_TRUE(is_similar(canvas.finish().at(4, 4), {127, 127, 127}, 1));
}

TEST(Canvas, SmoothsEdges) {
  Canvas canvas(40, 40, kWhite);
  canvas.disc({20.0, 20.0}, 12.0, Color{0, 0, 0});
  const Picture picture = canvas.finish();
  EXPECT_EQ(picture.at(20, 20), (Color{0, 0, 0}));
  EXPECT_EQ(picture.at(1, 1), kWhite);
  EXPECT_GT(count(picture, {128, 128, 128}), 0);
}

TEST(Canvas, ClipsToAWindow) {
  Canvas canvas(30, 30, kWhite);
  canvas.within({10.0, 10.0, 10.0, 10.0}, [&] {
    canvas.line({0.0, 15.0}, {30.0, 15.0}, kRed, 3.0);
    canvas.fill_box({0.0, 18.0, 30.0, 30.0}, kRed.with_opacity(0.99));
  });
  const Picture picture = canvas.finish();
  EXPECT_GT(count(picture, kRed, 10, 10, 20, 20), 40);
  EXPECT_EQ(count(picture, kWhite) - count(picture, kWhite, 10, 10, 20, 20), 800);
}

RC_GTEST_PROP(Canvas, DrawsALongLineThroughThePixelsThatItCrosses, ()) {
  const double angle = *rc::gen::inRange(0, 3600) * 0.1 * CV_PI / 180.0;
  const double reach = std::pow(10.0, *rc::gen::inRange(2, 9));
  Canvas canvas(60, 60, kWhite);
  const Pixel middle(30.0, 30.0);
  const Pixel direction(std::cos(angle), std::sin(angle));
  canvas.line(middle - reach * direction, middle + reach * direction, kRed, 4.0);
  const Picture picture = canvas.finish();
  for (const double along : {-20.0, 0.0, 20.0}) {
    const Pixel on = middle + along * direction;
    RC_ASSERT(is_similar(picture.at(int(on.x()), int(on.y())), kRed));
    const Pixel beside = on + 7.0 * Pixel(-direction.y(), direction.x());
    RC_ASSERT(picture.at(int(beside.x()), int(beside.y())) == kWhite);
  }
}

TEST(Canvas, OmitsCoordinatesThatAreNotFinite) {
  Canvas canvas(30, 30, kWhite);
  for (const double bad : {kNaN, kInfinity, -kInfinity}) {
    const Pixel point(bad, 10.0);
    canvas.line(point, {20.0, 20.0}, kRed, 2.0);
    canvas.dashed_line(point, {20.0, 20.0}, kRed, 2.0, 4.0);
    canvas.disc(point, 5.0, kRed);
    canvas.disc({10.0, 10.0}, bad, kRed);
    canvas.ring({10.0, 10.0}, bad, kRed, 2.0);
    canvas.ellipse({10.0, 10.0}, {3.0, 5.0}, bad, kRed, 2.0);
    canvas.fill_box({bad, 1.0, 5.0, 5.0}, kRed);
    canvas.fill(std::vector<Pixel>{point, {20.0, 20.0}, {3.0, 9.0}}, kRed);
    canvas.text(point, "words", {.color = kRed});
    canvas.polyline(arc({10.0, 10.0}, 5.0, 0.0, bad), kRed, 2.0);
  }
  EXPECT_EQ(count(canvas.finish(), kWhite), 900);
}

TEST(Canvas, LeavesAGapInACurveWhereAPointIsNotFinite) {
  Canvas canvas(60, 20, kWhite);
  canvas.polyline(std::vector<Pixel>{{5.0, 10.0}, {20.0, 10.0}, {30.0, kNaN}, {40.0, 10.0}, {55.0, 10.0}}, kRed, 4.0);
  const Picture picture = canvas.finish();
  EXPECT_TRUE(is_similar(picture.at(12, 10), kRed));
  EXPECT_TRUE(is_similar(picture.at(48, 10), kRed));
  EXPECT_EQ(count(picture, kWhite, 24, 0, 36, 20), 12 * 20);
}

TEST(Canvas, SurvivesExtremeCoordinatesAndSizes) {
  Canvas canvas(20, 20, kWhite);
  canvas.fill(std::vector<Pixel>{{-1e15, -1e15}, {1e15, -1e15}, {1e15, 1e15}, {-1e15, 1e15}}, kRed);
  EXPECT_EQ(count(canvas.finish(), kRed), 400);
  canvas.disc({1e12, 1e12}, 4.0, kWhite);
  canvas.disc({10.0, 10.0}, 1e12, kWhite);
  canvas.dashed_line({-1e12, 0.0}, {1e12, 10.0}, kWhite, 1.0, 5.0);
  canvas.text({1e12, -1e12}, "far", {.color = kWhite});
  EXPECT_EQ(count(canvas.finish(), kRed), 400);
}

TEST(Canvas, WritesTextOfTheReportedWidth) {
  const TextStyle style{.size = 24.0, .color = kRed};
  const double width = Canvas::text_width("wide words", style);
  Canvas canvas(300, 60, kWhite);
  canvas.text({20.0, 40.0}, "wide words", style);
  const Picture picture = canvas.finish();
  const int end = 20 + static_cast<int>(width);
  EXPECT_EQ(count(picture, kWhite, end + 3, 0, 300, 60), (300 - end - 3) * 60);
  EXPECT_LT(count(picture, kWhite, end - 14, 20, end, 42), 14 * 22);
}

TEST(Canvas, ShortensOnlyTextThatIsTooLong) {
  const TextStyle style{.size = 20.0};
  EXPECT_EQ(shortened("flip", 200.0, style), "flip");
  const std::string words = shortened(std::string(100000, 'w'), 200.0, style);
  EXPECT_LE(Canvas::text_width(words, style), 200.0);
  EXPECT_EQ(words.substr(words.size() - 4), "w...");
  EXPECT_EQ(shortened("tab\tand \xC3\xA9", 500.0, style), "tab?and ??");
}

TEST(FieldDrawing, DrawsLinesAtTheirDimensions) {
  const FieldDimensions field;
  Canvas canvas(1040, 740, kWhite);
  const FieldView view = FieldView::fitted(field, {0.0, 0.0, 1040.0, 740.0});
  EXPECT_DOUBLE_EQ(view.pixels_per_meter, 100.0);
  draw_field(canvas, view, field);
  const Picture picture = canvas.finish();
  const auto is_line = [&](double x, double y) {
    const Pixel pixel = view * Eigen::Vector2d(x, y);
    return is_similar(picture.at(int(pixel.x()), int(pixel.y())), palette::field_line);
  };
  EXPECT_TRUE(is_line(0.0, 1.7));                // halfway line
  EXPECT_TRUE(is_line(2.0, field.width / 2.0));  // left touchline
  EXPECT_TRUE(is_line(field.center_circle_radius, 0.0));
  EXPECT_TRUE(is_line(-field.penalty_mark_x, 0.0));
  EXPECT_TRUE(is_line(field.length / 2.0 - field.penalty_area_depth, 1.0));
  EXPECT_TRUE(is_line(field.length / 2.0 - field.goal_area_depth, 0.9));
  EXPECT_FALSE(is_line(1.5, 1.5));
}

TEST(FieldDrawing, SurvivesInvalidFields) {
  for (const double size : {0.0, -5.0, 1e300, kNaN, kInfinity}) {
    FieldDimensions field;
    field.length = field.border = field.center_circle_radius = field.line_width = size;
    Canvas canvas(40, 40, kWhite);
    draw_field(canvas, FieldView::fitted(field, {0.0, 0.0, 40.0, 40.0}), field);
    EXPECT_EQ(canvas.finish().bytes.size(), 4800U);
  }
}

}  // namespace
}  // namespace reorient::pictures
