// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/world/commands.h"
#include "engine/world/room_status.h"
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

bool is_correct_in(const ConfidenceSample& sample) { return sample.correct; }
RoomStatus status_in(const ConfidenceSample& sample) { return sample.status; }
double threshold_in(const ConfidenceSample& sample) { return sample.threshold; }

/// Calls `draw` with the first sample of each interval in which a value stays the same, and its end in s.
template <typename Value, typename Draw>
void for_each_interval(const TrialResult& trial, const Value& value, const Draw& draw) {
  const std::vector<ConfidenceSample>& samples = trial.confidences;
  for (std::size_t i = 0; i < samples.size();) {
    const std::size_t begin = i;
    while (i < samples.size() && value(samples[i]) == value(samples[begin])) ++i;
    draw(samples[begin], i < samples.size() ? samples[i].time : trial.seconds);
  }
}

void shade_wrong_belief(Plot& plot, const TrialResult& trial) {
  for_each_interval(trial, &is_correct_in, [&](const ConfidenceSample& sample, double until) {
    if (!sample.correct) plot.stretch(sample.time, until, "wrong");
  });
}

/// The class of the color of a status: whether the confidences count, do not count, or do not exist.
std::string status_style(RoomStatus status) {
  if (status == RoomStatus::usable) return "usable";
  return status == RoomStatus::off || status == RoomStatus::resting ? "idle" : "undecided";
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

/// The area between zero and the evidence, where it has this sign.
void fill_evidence(Plot& plot, const TrialResult& trial, double sign, std::string_view style) {
  std::vector<PlotPoint> zero, edge;
  for (const ConfidenceSample& sample : trial.confidences) {
    zero.push_back({sample.time, 0.0});
    edge.push_back({sample.time, sign * std::max(0.0, sign * sample.evidence)});
  }
  plot.band(zero, edge, style);
}

/// What the behaviors decide on: the evidence, the thresholds of an unconfirmed pose, and above it the status of the
/// room.
void draw_evidence(Markup& out, const TrialResult& trial, const std::string& description, const PlotAxis& time) {
  constexpr double kLinear = 3.0, kLeastShown = 15.0, kMostShown = 300.0;  // log-odds
  double most = kLeastShown;
  for (const ConfidenceSample& sample : trial.confidences)
    most = std::max({most, std::abs(sample.evidence), sample.threshold});
  most = std::min(1.1 * most, kMostShown);
  Plot plot(out, description, time, {"evidence", -most, most, 5, false, false, kLinear}, PlotShape::low);
  shade_wrong_belief(plot, trial);
  for_each_interval(trial, &status_in, [&](const ConfidenceSample& sample, double until) {
    plot.bar(sample.time, until, status_style(sample.status));
  });
  fill_evidence(plot, trial, 1.0, "mirrored");
  fill_evidence(plot, trial, -1.0, "believed");
  for_each_interval(trial, &threshold_in, [&](const ConfidenceSample& sample, double until) {
    if (!(sample.threshold > 0.0)) return;
    plot.line({{sample.time, sample.threshold}, {until, sample.threshold}}, "limit mirrored");
    plot.line({{sample.time, -sample.threshold}, {until, -sample.threshold}}, "limit believed");
  });
  if (trial.corrected_after) plot.moment(*trial.corrected_after, "");
  plot.line(values_of(trial, &ConfidenceSample::evidence), "evidence");
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
  const PlotAxis time{"time, s", 0.0, std::max(1.0, trial.seconds), 6, false};
  {
    Plot plot(out, shown.role + " trial: " + end, time, {"confidence", 0.0, highest, 4, false});
    shade_wrong_belief(plot, trial);
    if (trial.corrected_after) plot.moment(*trial.corrected_after, reorientation_word(trial.corrected_by));
    plot.line(values_of(trial, &ConfidenceSample::current), "believed");
    plot.line(values_of(trial, &ConfidenceSample::opposite), "mirrored");
  }
  draw_evidence(out, trial, shown.role + " trial: evidence and status of the room", time);
  out.leaf("p", place_of(report, shown) + "seed " + std::to_string(trial.seed), {{"class", "reading"}});
  const Element again(out, "p", {{"class", "again"}});
  out.leaf("code", report.command_of(task_of(report, shown.cell, shown.trial)));
}

template <typename Holds>
bool is_in_any(const Report& report, const std::vector<ShownTrial>& shown, const Holds& holds) {
  return std::any_of(shown.begin(), shown.end(), [&](const ShownTrial& one) {
    const std::vector<ConfidenceSample>& samples = report.cells[one.cell].trials[one.trial].confidences;
    return std::any_of(samples.begin(), samples.end(), holds);
  });
}

/// The names of the statuses with this color that the trials contain: "fresh, lost".
std::string statuses_in(const Report& report, const std::vector<ShownTrial>& shown, const std::string& style) {
  std::string names;
  for (int i = 0; i < kRoomStatuses; ++i) {
    const auto status = static_cast<RoomStatus>(i);
    const auto has_it = [&](const ConfidenceSample& sample) { return sample.status == status; };
    if (status_style(status) == style && is_in_any(report, shown, has_it))
      names += (names.empty() ? "" : ", ") + std::string(to_string(status));
  }
  return names;
}

void draw_legend_of(Markup& out, const Report& report, const std::vector<ShownTrial>& shown) {
  std::vector<LegendEntry> entries{{"confidence in the believed pose", "believed"},
                                   {"in the mirrored pose", "mirrored"},
                                   {"evidence (log-odds of the mirrored pose)", "evidence"}};
  if (is_in_any(report, shown, [](const ConfidenceSample& sample) { return sample.threshold > 0.0; })) {
    entries.push_back({"threshold of an unconfirmed pose: mirrored", "limit mirrored"});
    entries.push_back({"believed", "limit believed"});
  }
  for (const char* const style : {"usable", "undecided", "idle"}) {
    if (const std::string names = statuses_in(report, shown, style); !names.empty())
      entries.push_back({"room: " + names, style, true});
  }
  if (is_in_any(report, shown, [](const ConfidenceSample& sample) { return !sample.correct; }))
    entries.push_back({"the belief is wrong", "wrong", true});
  draw_entries(out, entries);
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
    draw_legend_of(out, report, shown);
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
            "\u201d: confidences over time, below them the evidence on which the behaviors decide, and the first "
            "command that corrected the belief. The bar above the evidence is the status of the room. Two samples a "
            "second: a shorter peak may be missing. Below each: the command that repeats it with pictures." +
            some);
  }
}

}  // namespace reorient
