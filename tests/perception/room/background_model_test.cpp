// SPDX-License-Identifier: MIT
#include "perception/room/background_model.h"

#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include "tests/perception/room/histograms.h"

namespace reorient {
namespace {

TEST(BackgroundModel, MatchesEquationsOneAndTwo) {
  // N = 3: mu = (3 * 0.2 + 0.6) / 4, sigma^2 = (3 * 0.01 + 3/4 * 0.4^2) / 4.
  const MovingAverage first = updated({0.2, 0.01}, 3.0, 0.6);
  EXPECT_NEAR(first.mean, 0.3, 1e-12);
  EXPECT_NEAR(first.variance, 0.0375, 1e-12);
  // mu = (0.9 + 0.1) / 4, sigma^2 = (0.1125 + 0.75 * 0.2^2) / 4.
  const MovingAverage second = updated(first, 3.0, 0.1);
  EXPECT_NEAR(second.mean, 0.25, 1e-12);
  EXPECT_NEAR(second.variance, 0.035625, 1e-12);
}

RC_GTEST_PROP(BackgroundModel, WithGrowingNIsTheTrueMeanAndVariance, ()) {
  const auto values = *rc::gen::container<std::vector<int>>(12, rc::gen::inRange(0, 1001));
  MovingAverage average{values[0] / 1000.0, 0.0};
  double sum = values[0] / 1000.0;
  double squares = sum * sum;
  for (std::size_t i = 1; i < values.size(); ++i) {
    const double value = values[i] / 1000.0;
    average = updated(average, static_cast<double>(i), value);
    sum += value;
    squares += value * value;
    const double count = static_cast<double>(i) + 1.0;
    RC_ASSERT(std::abs(average.mean - sum / count) < 1e-9);
    RC_ASSERT(std::abs(average.variance - (squares / count - sum * sum / count / count)) < 1e-9);
  }
}

RC_GTEST_PROP(BackgroundModel, AverageStaysBetweenTheMeasurementsAndVarianceIsNotNegative, ()) {
  const double n = *rc::gen::inRange(1, 1000);
  const double last = *rc::gen::inRange(0, 1001) / 1000.0;
  const double measured = *rc::gen::inRange(0, 1001) / 1000.0;
  const MovingAverage result = updated({last, 0.02}, n, measured);
  RC_ASSERT(result.mean >= std::min(last, measured) - 1e-12);
  RC_ASSERT(result.mean <= std::max(last, measured) + 1e-12);
  RC_ASSERT(result.variance >= 0.0);
}

TEST(BackgroundModel, CopiesATileThatIsSeenForTheFirstTime) {
  BackgroundModel model;
  model.forget(4);
  model.train(2, all_in(5), {0.1, 100.0, false, 0.0});
  EXPECT_EQ(model[2].mean, all_in(5));
  EXPECT_EQ(model[2].variance, ColorHistogram{});
  EXPECT_EQ(model[2].visits, 1);
  EXPECT_EQ(model[1].visits, 0);
}

TEST(BackgroundModel, SecondViewHasLittleWeightInThePaperAndHalfWithTrueMeans) {
  BackgroundModel model;
  model.forget(2);
  for (const int bin : {5, 6}) {
    model.train(0, all_in(bin), {0.1, 9.0, false, 0.0});
    model.train(1, all_in(bin), {0.1, 9.0, true, 0.04});
  }
  EXPECT_NEAR(model[0].mean[6], 0.1, 1e-6);
  EXPECT_NEAR(model[1].mean[6], 0.5, 1e-6);
  // The prior variance counts as one more view: (1 * 0.04 + 1/2 * 1) / 2.
  EXPECT_NEAR(model[1].variance[6], 0.27, 1e-6);
  EXPECT_NEAR(model[1].trained, 0.2, 1e-12);
}

TEST(BackgroundModel, ForgetsEverything) {
  BackgroundModel model;
  model.forget(3);
  model.train(0, all_in(1), {});
  model.forget(5);
  EXPECT_EQ(model.tiles().size(), 5u);
  for (const TileModel& tile : model.tiles()) EXPECT_EQ(tile.visits, 0);
}

}  // namespace
}  // namespace reorient
