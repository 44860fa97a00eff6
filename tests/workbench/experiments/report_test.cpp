// SPDX-License-Identifier: MIT
// The page and the table of trials, from artificial results.
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "geometry/random.h"
#include "tests/well_formed.h"
#include "workbench/experiments/report/page.h"
#include "workbench/experiments/report/trials_csv.h"

namespace reorient {
namespace {

const std::string kHostile = "<script>alert('x')</script> \"&\x01\xFF\xC0,\n=1";

/// Corrected at a time that depends on the seed, every fifth trial never; the confidences cross at that time.
TrialResult shown_result(std::uint64_t seed, bool is_disturbed) {
  Random random(seed, 7);
  TrialResult trial;
  trial.seed = seed;
  trial.started = true;
  trial.correct_at_start = !is_disturbed;
  trial.seconds = 70.0;
  if (!is_disturbed) trial.right_after = 0.0;
  if (is_disturbed && seed % 5 != 0) {
    trial.right_after = random.uniform(1.0, 50.0);
    trial.corrected_after = *trial.right_after;
    trial.corrected_by = seed % 2 == 0 ? Reorientation::flip_pose : Reorientation::purge_reflection;
  }
  trial.right_seconds = 60.0;
  for (double time = 0.5; time < 70.0; time += 0.5) {
    const bool correct = trial.right_after && time >= *trial.right_after;
    const double evidence = (correct ? -1.0 : 1.0) * random.uniform(-1.0, 9.0);
    trial.confidences.push_back(
        {time, correct ? 0.8 : 0.3, correct ? 0.1 : 0.6, evidence, RoomStatus::usable, correct, !correct, 5.5});
  }
  return trial;
}

Report report_with(const std::string& name, int trials) {
  Report report;
  report.experiment.name = name;
  report.experiment.title = name;
  report.experiment.description = name;
  report.experiment.trials = trials;
  report.experiment.axes = {{name, {{name + "1", {}}, {name + "2", {}}}}, {"mode", {{"default", {}}, {name, {}}}}};
  report.experiment.references = {{name, {{name, name + "1"}}, 20, 0.7, {}, 0.15, 18.1, {}, {}}};
  for (const Cell& cell : cells_of(report.experiment)) {
    CellResults results{cell.choices, {}, {}};
    for (int i = 0; i < trials; ++i) results.trials.push_back(shown_result(1 + i, i % 3 != 2));
    results.row = row_of(results.trials);
    report.cells.push_back(std::move(results));
  }
  report.provenance = {"reorient " + name, "1.2.3 " + name, name, "today"};
  report.command_of = [name](int task) { return "reorient again " + name + std::to_string(task); };
  return report;
}

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(ReportPage, IsWellFormedAndHasItsFiguresAndTables) {
  const std::string page = report_page(report_with("halls", 12));
  EXPECT_EQ(mistake_in_markup(page), "");
  for (const char* id : {"failures", "times", "false-flips", "roc", "reliability"})
    EXPECT_TRUE(has(page, std::string("<figure id=\"") + id + "\">")) << id;
  for (const char* role : {"best", "median", "worst", "failed"})
    EXPECT_TRUE(has(page, std::string("<strong>") + role)) << role;
  EXPECT_TRUE(has(page, "<code>reorient again halls10</code>")) << "the failed trial's own command";
  EXPECT_EQ(std::count(page.begin(), page.end(), '\r'), 0);
}

/// How often a text contains a part.
int count_of(const std::string& text, const std::string& part) {
  int count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++count;
  return count;
}

TEST(ReportPage, DrawsWhatTheBehaviorsDecideOnForEachTrialThatItShows) {
  Report report = report_with("halls", 12);
  const std::string page = report_page(report);
  const int panels = count_of(page, "trial: evidence and status of the room");
  EXPECT_EQ(panels, count_of(page, "<strong>"));
  EXPECT_EQ(count_of(page, "<polyline class=\"line evidence\""), panels);
  EXPECT_EQ(count_of(page, "<polyline class=\"line limit mirrored\""), panels);
  EXPECT_EQ(count_of(page, "<polyline class=\"line limit believed\""), panels);
  EXPECT_EQ(count_of(page, "<rect class=\"usable\" x="), panels) << "one interval each";
}

TEST(ReportPage, HasNoLegendEntryWithoutItsObject) {
  Report report = report_with("halls", 12);
  const std::string page = report_page(report);
  EXPECT_TRUE(has(page, "room: usable"));
  EXPECT_FALSE(has(page, "room: fresh"));
  EXPECT_TRUE(has(page, "threshold of"));
  EXPECT_TRUE(has(page, "the belief is wrong</li>"));
  for (CellResults& cell : report.cells) {
    for (TrialResult& trial : cell.trials) {
      for (ConfidenceSample& sample : trial.confidences) {
        sample.threshold = 0.0;
        sample.correct = true;
      }
      if (!trial.confidences.empty()) trial.confidences[0].status = RoomStatus::fresh;
      if (!trial.confidences.empty()) trial.confidences[1].status = RoomStatus::lost;
    }
  }
  const std::string other = report_page(report);
  EXPECT_TRUE(has(other, "room: lost, fresh"));
  EXPECT_FALSE(has(other, "threshold of"));
  EXPECT_FALSE(has(other, "the belief is wrong</li>"));
}

TEST(ReportPage, NeedsNoNetworkAndNoScript) {
  const std::string page = report_page(report_with("halls", 3));
  for (const char* word : {"http:", "https:", "src=", "@import", "url(", "<script", "<link"})
    EXPECT_FALSE(has(page, word)) << word;
}

TEST(ReportPage, EscapesTextOfUsers) {
  const std::string page = report_page(report_with(kHostile, 6));
  EXPECT_EQ(mistake_in_markup(page), "");
  EXPECT_FALSE(has(page, "<script"));
  EXPECT_TRUE(has(page, "&lt;script&gt;alert(&#39;x&#39;)&lt;/script&gt; &quot;&amp;\\x01\\xFF\\xC0, =1"));
}

TEST(ReportPage, IsTheSameForEqualReports) {
  EXPECT_EQ(report_page(report_with("halls", 9)), report_page(report_with("halls", 9)));
}

TEST(ReportPage, ShowsTheNumbersOfTheRows) {
  Report report = report_with("halls", 9);
  Row& row = report.cells[0].row;
  row.right.mean = 123.4;  // the page must show the row's value
  row.right.interval = Interval{120.1, 129.9};
  row.right_median = 77.7;
  row.by_command.mean = 55.5;
  row.by_command.interval = Interval{51.0, 59.0};
  const std::string page = report_page(report);
  for (const char* text : {"123.4 [120.1, 129.9]", "77.7", "55.5 [51.0, 59.0]"}) EXPECT_TRUE(has(page, text)) << text;
}

TEST(ReportPage, ShowsThatATimeIsLaterThanTheLimit) {
  Report report = report_with("halls", 10);
  for (CellResults& cell : report.cells) {
    for (TrialResult& trial : cell.trials) trial.right_after = trial.corrected_after = {};
    cell.row = row_of(cell.trials);
  }
  const std::string page = report_page(report);
  EXPECT_EQ(mistake_in_markup(page), "");
  EXPECT_TRUE(has(page, "<td>&gt; 60</td>"));
}

TEST(ReportPage, ShowsPublishedResultsBesideTheRows) {
  const std::string page = report_page(report_with("halls", 6));
  EXPECT_TRUE(has(page, "<td>70 %</td>"));
  EXPECT_TRUE(has(page, "<td>18.1</td>"));
  EXPECT_TRUE(has(page, "here, mode default"));
}

TEST(ReportPage, ReportsWhichTrialsWereNeverMeasured) {
  Report report = report_with("x", 3);
  EXPECT_EQ(report_page(report).find("never reached the state"), std::string::npos);
  report.cells[1].trials[0].started = false;
  report.cells[1].row = row_of(report.cells[1].trials);
  EXPECT_NE(report_page(report).find("x1, x: 1 of 3 trials never reached the state"), std::string::npos);
}

TEST(ReportPage, OfTrialsWithoutResultsIsStillAPage) {
  Report report = report_with("halls", 2);
  for (CellResults& cell : report.cells) {
    cell.trials.assign(2, TrialResult());
    cell.row = row_of(cell.trials);
  }
  EXPECT_EQ(mistake_in_markup(report_page(report)), "");
  report.cells.clear();
  EXPECT_EQ(mistake_in_markup(report_page(report)), "");
}

TEST(ReportPage, OfAnExperimentWithoutAxesHasOneSeries) {
  Report report = report_with("halls", 4);
  report.cells.resize(1);
  report.cells[0].choices.clear();
  report.experiment.axes.clear();
  report.experiment.references.clear();
  const std::string page = report_page(report);
  EXPECT_EQ(mistake_in_markup(page), "");
  EXPECT_TRUE(has(page, "all trials"));
}

/// With an axis of these choices instead of the first one, and two modes.
Report report_along(const std::vector<std::string>& choices, int trials) {
  Report report = report_with("halls", 1);
  report.experiment.references.clear();
  report.experiment.axes[0] = {"strength", {}};
  for (const std::string& choice : choices) report.experiment.axes[0].choices.push_back({choice, {}});
  report.cells.clear();
  for (const Cell& cell : cells_of(report.experiment)) {
    CellResults results{cell.choices, {}, {}};
    for (int i = 0; i < trials; ++i) results.trials.push_back(shown_result(1 + i, i % 2 == 0));
    results.row = row_of(results.trials);
    report.cells.push_back(std::move(results));
  }
  return report;
}

TEST(ReportLadder, ShowsDetectionAndFalseFlipsAlongAnAxisOfNumbers) {
  Report report = report_along({"100 %", "0 %", "50 %"}, 10);
  report.cells[0].trials[1].false_flips = 2;  // one trial
  report.cells[0].trials[0].false_flips = 1;  // after the belief came right
  const std::string page = report_page(report);
  EXPECT_EQ(mistake_in_markup(page), "");
  EXPECT_TRUE(has(page, "<figure id=\"ladder\">"));
  EXPECT_TRUE(has(page, "strength, %"));
  for (const char* mode : {"mode default", "mode halls"}) EXPECT_TRUE(has(page, mode)) << mode;
  // Seed 5 of the seeds 1, 3, 5, 7 and 9 never comes right.
  EXPECT_TRUE(has(page, "<p class=\"reading\">detected 12 of 15, flipped 2 of 30</p>"));
  EXPECT_TRUE(has(page, "<p class=\"reading\">detected 12 of 15, flipped 0 of 30</p>"));
}

TEST(ReportLadder, CountsAnExcusedFailureAsNotDetected) {
  Report report = report_along({"0", "0.5", "1"}, 2);
  for (CellResults& cell : report.cells) {
    cell.trials[0].right_after.reset();
    cell.trials[0].symmetric_room = cell.trials[0].ended_uninformative = true;
    ASSERT_FALSE(cell.trials[0].failed());
  }
  EXPECT_TRUE(has(report_page(report), "detected 0 of 3, flipped 0 of 6"));
}

TEST(ReportLadder, PoolsTheRooms) {
  Report report = report_along({"0 m", "1 m", "2 m"}, 2);
  report.experiment.axes[1].name = "room";
  EXPECT_TRUE(has(report_page(report), "detected 6 of 6, flipped 0 of 12"));
}

TEST(ReportLadder, IsDrawnForNumbersOfOneUnitOnly) {
  const auto draws = [](const std::vector<std::string>& choices) {
    const std::string page = report_page(report_along(choices, 2));
    EXPECT_EQ(mistake_in_markup(page), "") << choices.front();
    return has(page, "<figure id=\"ladder\">");
  };
  EXPECT_TRUE(draws({"1", "2", "3"}));
  EXPECT_TRUE(draws({"-1 m", "0 m", "0.75 m"}));
  EXPECT_FALSE(draws({"1", "2"})) << "too few";
  EXPECT_FALSE(draws({"1", "1.0", "1e0"})) << "one number";
  EXPECT_FALSE(draws({"1 m", "2 m", "3 %"}));
  EXPECT_FALSE(draws({"none", "2 robots", "9 robots"}));
  EXPECT_FALSE(draws({"1", "2", "inf"}));
  EXPECT_FALSE(draws({"1", "2", "nan"}));
  EXPECT_FALSE(draws({"1", "2", "1e999"}));
  EXPECT_FALSE(draws({"1e308", "-1e308", "0"}));
  EXPECT_FALSE(draws({"1e-320", "2e-320", "3e-320"}));
  EXPECT_FALSE(draws({kHostile, kHostile + "1", kHostile + "2"}));
  EXPECT_TRUE(draws({"1 " + kHostile, "2 " + kHostile, "3 " + kHostile}));
  EXPECT_TRUE(draws({"1", "1.0000000000000002", "1.0000000000000004"}));
}

TEST(TrialsCsv, HasALineForEachTrial) {
  const std::string csv = trials_as_csv(report_with("halls", 3));
  EXPECT_TRUE(csv.starts_with("halls,mode,task,seed,started,disturbed,failed,measured_s,right_after_s,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 4 * 3);
  EXPECT_TRUE(has(csv, "\r\nhalls1,halls,4,1,true,true,false,70,"));
}

TEST(TrialsCsv, WritesWhatIsNotANumberWithoutASign) {
  Report report = report_with("halls", 1);
  for (const double sign : {1.0, -1.0}) {
    report.cells.front().trials.front().seconds = std::copysign(std::numeric_limits<double>::quiet_NaN(), sign);
    EXPECT_TRUE(has(trials_as_csv(report), ",nan,")) << trials_as_csv(report);
  }
}

TEST(TrialsCsv, QuotesTexts) {
  const std::string csv = trials_as_csv(report_with(kHostile, 1));
  EXPECT_TRUE(csv.starts_with("\"<script>alert('x')</script> \"\"&\\x01\\xFF\\xC0, =1\",mode,"));
  EXPECT_TRUE(is_utf8(csv));
}

TEST(ReportPictures, ShowAsManySeriesAsCanBeDistinguishedEachBesideTheFirst) {
  std::vector<Series> series;
  for (std::size_t i = 0; i < 21; ++i)
    series.push_back({"series " + std::to_string(i), "s" + std::to_string(i % 7), {i}});
  const std::vector<std::vector<Series>> pictures = pictures_of(series);
  ASSERT_EQ(pictures.size(), 4u);
  std::set<std::string> shown;
  for (const std::vector<Series>& picture : pictures) {
    EXPECT_EQ(picture.front().name, "series 0");
    std::set<std::string> styles;
    for (const Series& one : picture) {
      EXPECT_TRUE(styles.insert(one.style).second) << one.name << " looks like another one";
      shown.insert(one.name);
    }
  }
  EXPECT_EQ(shown.size(), series.size());
}

TEST(ReportPictures, OfFewSeriesIsOneWithTheStylesThatTheyHaveElsewhere) {
  const std::vector<Series> series{{"default", "s0", {0}}, {"paper", "s1", {1}}, {"none", "s2", {2}}};
  ASSERT_EQ(pictures_of(series).size(), 1u);
  EXPECT_EQ(pictures_of(series)[0][2].style, "s2");
  EXPECT_EQ(pictures_of({series[0]}).size(), 1u);
  EXPECT_TRUE(pictures_of({})[0].empty());
}

}  // namespace
}  // namespace reorient
