// SPDX-License-Identifier: MIT
// Statistics of each compass over many trials: pooled rows, areas, equal errors.
#include "workbench/experiments/tables/compass_rows.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "geometry/random.h"

namespace reorient {
namespace {

Experiment experiment_of_rooms_and_lights() {
  Experiment experiment;
  experiment.axes = {{"room", {{"a", {}}, {"b", {}}}}, {"light", {{"same", {}}, {"hard", {}}}}};
  return experiment;
}

/// A look in which the first method has this evidence at all times, and the others have none.
CompassLook look_of(double lead) {
  CompassLook look{};
  look[0].if_right.fill(-lead);
  look[0].if_reflected.fill(lead);
  return look;
}

std::vector<CellResults> cells_with(const std::vector<double>& leads) {
  std::vector<CellResults> cells;
  for (const char* room : {"a", "b"}) {
    for (const char* light : {"same", "hard"}) {
      CellResults cell{{room, light}, {}, {}};
      for (const double lead : leads) cell.trials.emplace_back().looks = {look_of(lead)};
      cells.push_back(std::move(cell));
    }
  }
  return cells;
}

TEST(CompassRows, PoolAllButTheLastAxisFirst) {
  const auto rows = compass_rows(experiment_of_rooms_and_lights(), cells_with({1.0, 2.0}));
  const std::size_t methods = kCompassMethods.size();
  ASSERT_EQ(rows.size(), 6 * methods);
  EXPECT_EQ(rows[0].choices, (std::vector<std::string>{"all", "same"}));
  EXPECT_EQ(rows[methods].choices, (std::vector<std::string>{"all", "hard"}));
  EXPECT_EQ(rows[2 * methods].choices, (std::vector<std::string>{"a", "same"}));
  EXPECT_EQ(rows[5 * methods].choices, (std::vector<std::string>{"b", "hard"}));
  EXPECT_EQ(rows[0].trials, 4);
  EXPECT_EQ(rows[0].looks, 4);
  EXPECT_EQ(rows[2 * methods].looks, 2);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].method, i % methods);
}

TEST(CompassRows, DistinguishInformedMethodsFromGuessing) {
  const auto rows = compass_rows(experiment_of_rooms_and_lights(), cells_with({1.0, 2.0, 3.0}));
  for (const CompassFigure& figure : rows[0].figures) {
    EXPECT_EQ(figure.area, 1.0);
    EXPECT_EQ(figure.equal_error, 0.0);
    EXPECT_EQ(figure.silent, 0.0);
    EXPECT_GT(figure.equal_error_interval.high, 0.2);
  }
  for (const CompassFigure& figure : rows[1].figures) {
    EXPECT_EQ(figure.area, 0.5);
    EXPECT_EQ(figure.equal_error, 0.5);
    EXPECT_EQ(figure.silent, 1.0);
  }
}

TEST(CompassRows, CountFlipsOfMethodsThatHaveARule) {
  std::vector<CellResults> cells = cells_with({1.0, 2.0});
  for (CellResults& cell : cells) {
    cell.trials[0].looks[0][0].flips_if_reflected = {0.0, 1.0, 1.0};
    cell.trials[1].looks[0][0].flips_if_reflected = {0.0, 0.0, 1.0};
    cell.trials[1].looks[0][0].flips_if_right = {0.0, 0.0, 1.0};
  }
  const auto rows = compass_rows(experiment_of_rooms_and_lights(), cells);
  EXPECT_EQ(rows[0].figures[0].flipped, 0.0);
  EXPECT_EQ(rows[0].figures[1].flipped, 0.5);
  EXPECT_EQ(rows[0].figures[2].flipped, 1.0);
  EXPECT_EQ(rows[0].figures[2].false_flipped, 0.5);
  for (std::size_t i = 0; i < kCompassMethods.size(); ++i)
    EXPECT_EQ(rows[i].figures[2].flipped.has_value(), kHasFlipRule[i]) << i;
}

TEST(CompassRows, LeaveOutTrialsWithoutALook) {
  std::vector<CellResults> cells = cells_with({1.0});
  EXPECT_TRUE(have_looks(cells));
  for (CellResults& cell : cells) cell.trials.emplace_back();
  EXPECT_EQ(compass_rows(experiment_of_rooms_and_lights(), cells)[0].trials, 2);
  for (CellResults& cell : cells) cell.trials[0].looks.clear();
  EXPECT_FALSE(have_looks(cells));
  EXPECT_TRUE(compass_rows(experiment_of_rooms_and_lights(), cells).empty());
}

TEST(EqualErrorRate, IsWhereMissesAreAsManyAsFalseAlarms) {
  EXPECT_DOUBLE_EQ(equal_error_rate(roc_curve({3.0, 4.0}, {1.0, 2.0})), 0.0);
  EXPECT_DOUBLE_EQ(equal_error_rate(roc_curve({1.0, 2.0}, {3.0, 4.0})), 1.0);
  EXPECT_DOUBLE_EQ(equal_error_rate(roc_curve({1.0, 3.0, 5.0, 7.0}, {0.0, 2.0, -1.0, -2.0})), 0.25);
  EXPECT_TRUE(std::isnan(equal_error_rate({})));
}

TEST(BootstrapAreaInterval, ContainsTheAreaAndIsWiderForDependentCases) {
  Random random(1);
  std::vector<ScoredGroup> independent, dependent;
  std::vector<double> positives, negatives;
  for (int group = 0; group < 20; ++group) {
    const double own = random.normal();
    ScoredGroup& one = independent.emplace_back();
    ScoredGroup& other = dependent.emplace_back();
    for (int i = 0; i < 10; ++i) {
      one.positives.push_back(1.0 + random.normal());
      one.negatives.push_back(-1.0 + random.normal());
      other.positives.push_back(1.0 + own);
      other.negatives.push_back(-1.0 - own);
    }
    positives.insert(positives.end(), one.positives.begin(), one.positives.end());
    negatives.insert(negatives.end(), one.negatives.begin(), one.negatives.end());
  }
  const double area = area_below(roc_curve(positives, negatives));
  const Interval narrow = bootstrap_area_interval(independent), wide = bootstrap_area_interval(dependent);
  EXPECT_LT(narrow.low, area);
  EXPECT_GT(narrow.high, area);
  EXPECT_GT(wide.high - wide.low, 1.5 * (narrow.high - narrow.low));
  const Interval again = bootstrap_area_interval(independent);
  EXPECT_EQ(again.low, narrow.low);
  EXPECT_EQ(again.high, narrow.high);
  EXPECT_TRUE(std::isnan(bootstrap_area_interval({}).low));
}

}  // namespace
}  // namespace reorient
