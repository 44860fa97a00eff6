// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/rating_view.h"

#include <cmath>
#include <limits>

#include <gtest/gtest.h>

#include "geometry/angle.h"

namespace reorient::pictures {
namespace {

RatingView a_rating() {
  RatingView view;
  view.title = "Where the evidence comes from";
  for (int column = 0; column < 48; ++column)
    view.sectors.push_back({column * 2.0 * kPi / 48, (column + 1) * 2.0 * kPi / 48, column < 24 ? 4.0 : -1.0, 1.0});
  return view;
}

/// Numbers of pixels with this color above and below the middle of the picture's ring.
std::pair<int, int> above_and_below(const Picture& picture, const Color& color) {
  int above = 0, below = 0;
  for (int y = 0; y < kRatingHeight - 160; ++y) {  // without the legend
    for (int x = 0; x < picture.width; ++x) {
      if (!(picture.at(x, y) == color)) continue;
      (y < kRatingHeight / 2 + 30 ? above : below) += 1;
    }
  }
  return {above, below};
}

TEST(RatingView, ShowsTheEvidenceOfTheLeftOnTheLeftOfTheField) {
  const Picture picture = draw_rating(a_rating());
  EXPECT_EQ(picture.width, kRatingWidth);
  EXPECT_EQ(picture.height, kRatingHeight);
  const auto [good_left, good_right] = above_and_below(picture, palette::belief);
  EXPECT_GT(good_left, 5000);
  EXPECT_EQ(good_right, 0);
  const auto [bad_left, bad_right] = above_and_below(picture, palette::opposite);
  EXPECT_EQ(bad_left, 0);
  EXPECT_GT(bad_right, 1000);
}

TEST(RatingView, MarksThePositionOfABanner) {
  RatingView view = a_rating();
  const Picture without = draw_rating(view);
  view.banner = {from_degrees(90.0), 0.125};
  const Picture with = draw_rating(view);
  EXPECT_EQ(above_and_below(without, palette::truth).first, 0);
  EXPECT_GT(above_and_below(with, palette::truth).first, 500);
}

TEST(RatingView, OmitsValuesThatAreNotFinite) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinite = std::numeric_limits<double>::infinity();
  RatingView view;
  view.title = std::string(5000, 'x');
  view.sectors = {{kNan, 1.0, 1.0, 1.0}, {0.0, kInfinite, 1.0, 1.0}, {0.0, 1.0, kNan, 1.0}, {0.0, 1.0, kInfinite, 1.0},
                  {1.0, 0.0, 1.0, 1.0},  {0.0, 1.0, 1.0, kNan},      {0.0, 1.0, 1.0, -1.0}, {1e9, 1e9 + 1.0, 1.0, 1.0}};
  view.banner = {kNan, kNan};
  view.field.length = kNan;
  const Picture picture = draw_rating(view);
  EXPECT_EQ(above_and_below(picture, palette::belief), (std::pair{0, 0}));
}

}  // namespace
}  // namespace reorient::pictures
