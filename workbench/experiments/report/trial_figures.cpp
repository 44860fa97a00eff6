// SPDX-License-Identifier: MIT
#include <algorithm>
#include <utility>

#include "engine/world/commands.h"
#include "workbench/experiments/charts/numbers.h"
#include "workbench/experiments/charts/plot.h"
#include "workbench/experiments/report/figures.h"

namespace reorient {
namespace {

/// One typical trial.
struct ShownTrial {
  std::string role;  ///< "best"
  std::size_t cell = 0;
  std::size_t trial = 0;
};

constexpr std::size_t kMostFailedShown = 3;

std::vector<ShownTrial> shown_trials(const Report& report, const Series& series) {
  std::vector<ShownTrial> right, failed;
  for (const std::size_t cell : series.cells) {
    const std::vector<TrialResult>& trials = report.cells[cell].trials;
    for (std::size_t i = 0; i < trials.size(); ++i) {
      if (!trials[i].disturbed() || trials[i].confidences.empty()) continue;
      if (trials[i].failed()) failed.push_back({"failed", cell, i});
      if (trials[i].right_after) right.push_back({"", cell, i});
    }
  }
  const auto time = [&](const ShownTrial& one) { return *report.cells[one.cell].trials[one.trial].right_after; };
  std::stable_sort(right.begin(), right.end(), [&](const auto& a, const auto& b) { return time(a) < time(b); });
  std::vector<ShownTrial> shown;
  const auto show = [&](const char* role, std::size_t i) {
    shown.push_back(right[i]);
    shown.back().role = role;
  };
  if (!right.empty()) show("best", 0);
  if (right.size() > 2) show("median", (right.size() - 1) / 2);
  if (right.size() > 1) show("worst", right.size() - 1);
  failed.resize(std::min(failed.size(), kMostFailedShown));
  shown.insert(shown.end(), failed.begin(), failed.end());
  return shown;
}

std::vector<PlotPoint> values_of(const TrialResult& trial, double ConfidenceSample::*value) {
  std::vector<PlotPoint> points;
  for (const ConfidenceSample& sample : trial.confidences) points.push_back({sample.time, sample.*value});
  return points;
}

void shade_wrong_belief(Plot& plot, const TrialResult& trial) {
  const std::vector<ConfidenceSample>& samples = trial.confidences;
  for (std::size_t i = 0; i < samples.size();) {
    const std::size_t begin = i;
    while (i < samples.size() && samples[i].correct == samples[begin].correct) ++i;
    const double until = i < samples.size() ? samples[i].time : trial.seconds;
    if (!samples[begin].correct) plot.stretch(samples[begin].time, until, "wrong");
  }
}

std::string reorientation_word(const std::optional<Reorientation>& command) {
  if (!command) return "command";
  const std::string_view name = to_string(*command);
  return std::string(name.substr(0, name.find('_')));
}

std::string place_of(const Report& report, const ShownTrial& shown) {
  std::string text;
  for (std::size_t i = 0; i < report.experiment.axes.size(); ++i)
    text += report.experiment.axes[i].name + " " + report.cells[shown.cell].choices[i] + ", ";
  return text;
}

void draw_trial(Markup& out, const Report& report, const ShownTrial& shown) {
  const TrialResult& trial = report.cells[shown.cell].trials[shown.trial];
  const std::string end =
      trial.right_after ? "right after " + fixed(*trial.right_after, 1) + " s" : "never right for good";
  const Element panel(out, "div", {{"class", "panel"}});
  {
    const Element name(out, "p", {{"class", "panel-name"}});
    out.leaf("strong", shown.role);
    out.text(" \u00b7 " + end);
  }
  double highest = 1.0;
  for (const ConfidenceSample& sample : trial.confidences)
    highest = std::max({highest, sample.current, sample.opposite});
  {
    const PlotAxis time{"time, s", 0.0, std::max(1.0, trial.seconds), 6, false};
    Plot plot(out, shown.role + " trial: " + end, time, {"confidence", 0.0, highest, 4, false});
    shade_wrong_belief(plot, trial);
    if (trial.corrected_after) plot.moment(*trial.corrected_after, reorientation_word(trial.corrected_by));
    plot.line(values_of(trial, &ConfidenceSample::current), "s0");
    plot.line(values_of(trial, &ConfidenceSample::opposite), "s1");
  }
  out.leaf("p", place_of(report, shown) + "seed " + std::to_string(trial.seed), {{"class", "reading"}});
  const Element again(out, "p", {{"class", "again"}});
  out.leaf("code", report.command_of(task_of(report, shown.cell, shown.trial)));
}

}  // namespace

void draw_confidences(Markup& out, const Report& report) {
  bool is_first = true;
  for (const Series& series : series_of(report)) {
    const std::vector<ShownTrial> shown = shown_trials(report, series);
    if (shown.empty()) continue;
    if (std::exchange(is_first, false)) out.leaf("h2", "Single trials");
    int failed = 0;
    for (const std::size_t cell : series.cells) failed += report.cells[cell].row.failed;
    const Element figure(out, "figure", {{"class", "trials"}});
    draw_legend(out, {{"confidence in the believed pose", "s0", {}}, {"in the mirrored pose", "s1", {}}}, true);
    {
      const Element panels(out, "div", {{"class", "panels"}});
      for (const ShownTrial& trial : shown) draw_trial(out, report, trial);
    }
    const std::string some = failed > static_cast<int>(kMostFailedShown)
                                 ? " Of " + std::to_string(failed) + " failed trials the first " +
                                       std::to_string(kMostFailedShown) + " are shown."
                                 : "";
    draw_caption(
        out, report,
        "Single trials of \u201c" + series.name +
            "\u201d: confidences over time, and the first command that corrected the belief. Shaded: the belief "
            "is wrong. Below each: the command that repeats it with pictures." +
            some);
  }
}

}  // namespace reorient
