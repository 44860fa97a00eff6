// SPDX-License-Identifier: MIT
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

#include "workbench/experiments/charts/plot.h"
#include "workbench/experiments/report/figures.h"
#include "workbench/experiments/statistics/rates.h"

namespace reorient {
namespace {

constexpr std::size_t kFewestRungs = 3;  // two points are not a curve

/// "30 %": a choice that begins with a number that an axis of a figure can show.
struct Quantity {
  double value = 0.0;
  std::string unit;  ///< may be empty
};

std::optional<Quantity> quantity_of(std::string_view choice) {
  constexpr double kLeast = 1e-6, kGreatest = 1e9;  // limits of numbers other than zero
  Quantity quantity;
  const auto [end, error] = std::from_chars(choice.data(), choice.data() + choice.size(), quantity.value);
  const double size = std::abs(quantity.value);
  const bool can_be_shown = size == 0.0 || (size >= kLeast && size <= kGreatest);  // false for NaN
  if (error != std::errc() || !can_be_shown) return std::nullopt;
  choice.remove_prefix(static_cast<std::size_t>(end - choice.data()));
  while (choice.starts_with(' ')) choice.remove_prefix(1);
  quantity.unit = choice;
  return quantity;
}

bool has_quantities(const Axis& axis) {
  if (axis.choices.size() < kFewestRungs) return false;
  const std::optional<Quantity> first = quantity_of(axis.choices.front().name);
  return first && std::all_of(axis.choices.begin(), axis.choices.end(), [&](const AxisChoice& choice) {
           const std::optional<Quantity> quantity = quantity_of(choice.name);
           return quantity && quantity->unit == first->unit;
         });
}

/// The last axis whose choices are numbers of one unit.
std::optional<std::size_t> ladder_axis(const Experiment& experiment) {
  for (std::size_t i = experiment.axes.size(); i-- > 0;) {
    if (has_quantities(experiment.axes[i])) return i;
  }
  return std::nullopt;
}

/// The number of trials in which something happened.
struct Count {
  int events = 0;
  int trials = 0;
  void add(bool event) {
    ++trials;
    events += event ? 1 : 0;
  }
};

/// The trials of one choice of the axis, in all rooms.
struct Rung {
  double value = 0.0;
  Count detected;  ///< trials with a wrong belief at the start whose belief came right
  Count flipped;   ///< trials in which a correct belief was flipped
};

/// The choices of all axes but the ladder's and the room's.
struct Ladder {
  std::string name;
  std::vector<Rung> rungs;  ///< by their values
};

std::string name_beside(const Report& report, const CellResults& cell, std::size_t axis) {
  std::string name;
  for (std::size_t i = 0; i < report.experiment.axes.size(); ++i) {
    const Axis& one = report.experiment.axes[i];
    if (i == axis || one.name == "room" || one.choices.size() < 2) continue;
    name += (name.empty() ? "" : ", ") + one.name + " " + cell.choices[i];
  }
  return name;
}

std::vector<Ladder> ladders_of(const Report& report, std::size_t axis) {
  std::vector<Ladder> ladders;
  for (const CellResults& cell : report.cells) {
    const std::string name = name_beside(report, cell, axis);
    auto ladder = std::find_if(ladders.begin(), ladders.end(), [&](const Ladder& one) { return one.name == name; });
    if (ladder == ladders.end()) ladder = ladders.insert(ladders.end(), {name, {}});
    const double value = quantity_of(cell.choices[axis])->value;
    std::vector<Rung>& rungs = ladder->rungs;
    auto rung = std::find_if(rungs.begin(), rungs.end(), [&](const Rung& one) { return one.value >= value; });
    if (rung == rungs.end() || rung->value != value) rung = rungs.insert(rung, {value, {}, {}});
    for (const TrialResult& trial : cell.trials) {
      if (trial.disturbed()) rung->detected.add(trial.right_after.has_value());
      rung->flipped.add(trial.false_flips > 0);
    }
  }
  return ladders;
}

void draw_share(Plot& plot, const std::vector<Rung>& rungs, Count Rung::*count, std::string_view style) {
  std::vector<PlotPoint> share, low, high;
  for (const Rung& rung : rungs) {
    const Count& one = rung.*count;
    if (one.trials == 0) continue;
    const Interval interval = wilson_interval(one.events, one.trials);
    share.push_back({rung.value, static_cast<double>(one.events) / one.trials});
    low.push_back({rung.value, interval.low});
    high.push_back({rung.value, interval.high});
  }
  plot.band(low, high, style);
  plot.line(share, style);
}

std::string total_text(const Ladder& ladder, Count Rung::*count) {
  Count total;
  for (const Rung& rung : ladder.rungs) {
    total.events += (rung.*count).events;
    total.trials += (rung.*count).trials;
  }
  return std::to_string(total.events) + " of " + std::to_string(total.trials);
}

}  // namespace

void draw_ladder(Markup& out, const Report& report) {
  const std::optional<std::size_t> axis = ladder_axis(report.experiment);
  if (!axis || report.cells.empty()) return;
  const std::vector<Ladder> ladders = ladders_of(report, *axis);
  const std::vector<Rung>& rungs = ladders.front().rungs;
  if (rungs.size() < kFewestRungs) return;  // "1" and "1.0" are the same number
  const std::string name = report.experiment.axes[*axis].name;
  const std::string unit = quantity_of(report.experiment.axes[*axis].choices.front().name)->unit;
  std::string axis_name = name;
  if (!unit.empty()) axis_name.append(", ").append(unit);
  out.leaf("h2", "Detection and false flips along " + name);
  const Element figure(out, "figure", {{"id", "ladder"}});
  draw_legend(out, {{"wrong belief detected", "s0", {}}, {"correct belief flipped", "s1", {}}});
  {
    const Element panels(out, "div", {{"class", "panels"}});
    for (const Ladder& ladder : ladders) {
      const Element panel(out, "div", {{"class", "panel"}});
      if (!ladder.name.empty()) out.leaf("p", ladder.name, {{"class", "panel-name"}});
      const std::string reading =
          "detected " + total_text(ladder, &Rung::detected) + ", flipped " + total_text(ladder, &Rung::flipped);
      {
        std::string title = "detection and false flips along ";
        title.append(name).append(": ").append(reading);
        Plot plot(out, title, {axis_name, rungs.front().value, rungs.back().value, 5, false},
                  {"trials, %", 0.0, 1.0, 5, true});
        draw_share(plot, ladder.rungs, &Rung::detected, "s0");
        draw_share(plot, ladder.rungs, &Rung::flipped, "s1");
      }
      out.leaf("p", reading, {{"class", "reading"}});
    }
  }
  draw_caption(out, report,
               "Detected: of the trials with a wrong belief at the start, those whose belief became right in time and "
               "stayed right, also where a failure would be excused. Flipped: of all trials, those with at least "
               "one flip of a correct belief. Trials of all rooms together. Shaded: "
               "Wilson\u2019s 95 % interval.");
}

}  // namespace reorient
