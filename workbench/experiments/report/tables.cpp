// SPDX-License-Identifier: MIT
#include "workbench/experiments/report/tables.h"

#include <algorithm>

#include "workbench/experiments/charts/numbers.h"
#include "workbench/experiments/tables/outcome.h"
#include "workbench/experiments/tables/paired_comparison.h"

namespace reorient {
namespace {

/// Columns of names, then of numbers; scrolls if the page is too narrow.
class NumberTable {
 public:
  NumberTable(Markup& out, std::string_view caption, const std::vector<std::string>& names,
              const std::vector<std::string>& numbers)
      : out_(captioned(out, caption)),
        scroll_(out, "div", {{"class", "scroll"}}),
        table_(out, "table", {{"class", "numbers"}}) {
    const Element head(out_, "thead");
    const Element line(out_, "tr");
    for (const std::string& name : names) out_.leaf("th", name, {{"scope", "col"}, {"class", "name"}});
    for (const std::string& number : numbers) out_.leaf("th", number, {{"scope", "col"}});
  }

  void add(const std::vector<std::string>& names, const std::vector<std::string>& numbers, std::string_view kind = "") {
    const Element line(out_, "tr", {{"class", kind}});
    for (const std::string& name : names) out_.leaf("th", name, {{"scope", "row"}, {"class", "name"}});
    for (const std::string& number : numbers) out_.leaf("td", number);
  }

 private:
  /// A note outside of the scrolling part, so that it is always visible.
  static Markup& captioned(Markup& out, std::string_view caption) {
    out.leaf("p", caption, {{"class", "caption"}});
    return out;
  }

  Markup& out_;
  Element scroll_;
  Element table_;
};

std::vector<std::string> axis_names(const Report& report) {
  std::vector<std::string> names;
  for (const Axis& axis : report.experiment.axes) names.push_back(axis.name);
  return names;
}

std::string share_text(int part, int whole) {
  return whole == 0 ? fixed(std::nullopt, 0) : percent(static_cast<double>(part) / whole);
}

std::string mean_and_interval(const TimeRow& row) {
  return fixed(row.mean, 1) + (row.interval ? " " + fixed(*row.interval, 1) : "");
}

/// The text of a quantile; with too many failed trials it is later than the limit.
std::string quantile_text(const std::optional<double>& seconds, int disturbed, double limit) {
  return !seconds && disturbed > 0 ? "> " + fixed(limit, 0) : fixed(seconds, 1);
}

std::string failed_share(const Row& row) {
  if (row.disturbed == 0) return fixed(std::nullopt, 0);
  return std::to_string(row.failed) + " of " + std::to_string(row.disturbed) + ", " +
         share_text(row.failed, row.disturbed) + " " +
         fixed(Interval{100.0 * row.failed_rate.low, 100.0 * row.failed_rate.high}, 0);
}

std::string name_of(const std::vector<std::pair<std::string, std::string>>& choices) {
  std::string name;
  for (const auto& [axis, choice] : choices) name += (name.empty() ? "" : ", ") + choice;
  return name;
}

std::string shown_share(const std::optional<double>& share) { return share ? percent(*share) : fixed(share, 0); }

std::vector<std::string> numbers_of(const Reference& reference) {
  return {reference.trials ? std::to_string(*reference.trials) : fixed(std::nullopt, 0),
          shown_share(reference.flip),
          shown_share(reference.purge),
          shown_share(reference.failed),
          fixed(reference.mean_s, 1),
          fixed(reference.flip_mean_s, 1),
          fixed(reference.purge_mean_s, 1)};
}

std::vector<std::string> numbers_beside(const Row& row) {
  return {std::to_string(row.disturbed),        share_text(row.flip, row.disturbed),
          share_text(row.purge, row.disturbed), failed_share(row),
          mean_and_interval(row.by_command),    fixed(row.flip_time.mean, 1),
          fixed(row.purge_time.mean, 1)};
}

std::vector<std::string> numbers_of(const PairedComparison& comparison) {
  const bool has_times = comparison.median_difference.has_value();
  const std::string interval = comparison.interval ? " [" + with_sign(comparison.interval->low, 1) + ", " +
                                                         with_sign(comparison.interval->high, 1) + "]"
                                                   : "";
  return {std::to_string(comparison.disturbed),
          std::to_string(comparison.failed_first),
          std::to_string(comparison.failed_second),
          std::to_string(comparison.only_first_failed),
          std::to_string(comparison.only_second_failed),
          comparison.disturbed == 0 ? fixed(std::nullopt, 0) : p_value(comparison.failed_p),
          std::to_string(comparison.timed),
          has_times ? with_sign(*comparison.median_difference, 1) + interval : fixed(std::nullopt, 0),
          has_times ? p_value(comparison.times_p) : fixed(std::nullopt, 0)};
}

/// The table without its notes.
void draw_table_of_rows(Markup& out, const Report& report) {
  NumberTable table(out,
                    "Results of each cell. Failed: of the trials with a wrong belief at the start; Wilson\u2019s 95 % "
                    "interval. Right after: of those that came right; mean with bootstrap interval; median and 90th "
                    "percentile count failed trials as later than all others. Corrected after: time until the command "
                    "that corrected the belief, the paper\u2019s measure. Times in s.",
                    axis_names(report),
                    {"trials", "failed, % [95 %]", "right after [95 %]", "median", "p90", "corrected after [95 %]",
                     "by flip", "by purge"});
  const auto add = [&table](const CellResults& cell, double limit, std::string_view kind) {
    const Row& row = cell.row;
    table.add(
        cell.choices,
        {std::to_string(row.trials), failed_share(row), mean_and_interval(row.right),
         quantile_text(row.right_median, row.disturbed, limit), quantile_text(row.right_p90, row.disturbed, limit),
         mean_and_interval(row.by_command), share_text(row.flip, row.disturbed), share_text(row.purge, row.disturbed)},
        kind);
  };
  for (std::size_t i = 0; i < report.cells.size(); ++i) add(report.cells[i], limit_of(report, i), "");
  for (const CellResults& row : pooled_over_rooms(report.experiment, report.cells)) {
    const auto belongs = [&row](const CellResults& cell) {
      return std::equal(cell.choices.begin(), cell.choices.end(), row.choices.begin(),
                        [](const std::string& one, const std::string& all) { return one == all || all == kAllRooms; });
    };
    const auto first = std::find_if(report.cells.begin(), report.cells.end(), belongs);
    add(row, limit_of(report, static_cast<std::size_t>(first - report.cells.begin())), "own");
  }
}

}  // namespace

void draw_rows(Markup& out, const Report& report) {
  draw_table_of_rows(out, report);
  for (const CellResults& cell : report.cells) {
    if (const std::string note = not_started_note(cell); !note.empty()) out.leaf("p", note);
  }
}

void draw_measures(Markup& out, const Report& report) {
  const std::vector<Measure>& measures = report.experiment.measures;
  if (measures.empty()) return;
  std::vector<std::string> names = axis_names(report);
  names.emplace_back("measure");
  NumberTable table(out,
                    "Measures of each cell, from the start of a trial\u2019s clock to its end. Counts are numbers of "
                    "events in one trial. Mean with bootstrap interval, least and most are over the trials.",
                    names, {"unit", "trials", "mean of a trial [95 %]", "least", "most"});
  const auto add = [&](const CellResults& cell, std::string_view kind) {
    for (std::size_t i = 0; i < measures.size() && i < cell.row.measures.size(); ++i) {
      const MeasureRow& row = cell.row.measures[i];
      const auto known = [&row](double value) {
        return fixed(row.trials > 0 ? std::optional(value) : std::nullopt, 3);
      };
      std::vector<std::string> choices = cell.choices;
      choices.push_back(measures[i].label());
      table.add(
          choices,
          {unit_of(measures[i]), std::to_string(row.trials),
           known(row.mean) + (row.interval ? " " + fixed(*row.interval, 3) : ""), known(row.least), known(row.most)},
          kind);
    }
  };
  for (const CellResults& cell : report.cells) add(cell, "");
  for (const CellResults& row : pooled_over_rooms(report.experiment, report.cells)) add(row, "own");
}

void draw_references(Markup& out, const Report& report) {
  const std::vector<Reference>& references = report.experiment.references;
  if (references.empty()) return;
  out.leaf("h2", "Comparison with published results");
  NumberTable table(
      out,
      "Published results, and our trials of the same case (shaded). Trials: those with a wrong belief at the "
      "start. Times: mean times until the command that corrected the belief, s.",
      {"case", "measured by"}, {"trials", "flip", "purge", "failed", "mean", "by flip", "by purge"});
  for (auto at = references.begin(); at != references.end();) {
    // References of equal choices are grouped, with the rows of this experiment below.
    const auto end = std::find_if(at, references.end(), [&](const auto& one) { return one.choices != at->choices; });
    const bool has_own = std::any_of(report.cells.begin(), report.cells.end(), [&](const CellResults& cell) {
      return belongs_to(*at, report.experiment, cell.choices);
    });
    std::string name = name_of(at->choices);
    for (auto reference = at; has_own && reference != end; ++reference) {
      table.add({std::exchange(name, ""), reference->label}, numbers_of(*reference), reference == at ? "group" : "");
    }
    for (const CellResults& cell : report.cells) {
      if (!belongs_to(*at, report.experiment, cell.choices)) continue;
      std::string label;
      for (std::size_t i = 0; i < report.experiment.axes.size(); ++i) {
        const std::string& axis = report.experiment.axes[i].name;
        if (std::none_of(at->choices.begin(), at->choices.end(), [&](const auto& one) { return one.first == axis; }))
          label += (label.empty() ? "here, " : ", ") + axis + " " + cell.choices[i];
      }
      table.add({"", label.empty() ? "here" : label}, numbers_beside(cell.row), "own");
    }
    at = end;
  }
}

void draw_comparisons(Markup& out, const Report& report) {
  struct Against {
    std::vector<std::string> names;  ///< of the case, where it is the case's first, and of both choices
    PairedComparison pairs;
  };
  const std::vector<Series> series = series_of(report);
  std::vector<Against> comparisons;
  for (const CellGroup& group : groups_of(report)) {
    const std::size_t first = group.cells.front();
    std::string name = group.name;
    for (std::size_t i = 1; i < group.cells.size(); ++i) {
      const std::size_t second = group.cells[i];
      const PairedComparison pairs =
          compare_pairs(outcomes_of(report.cells[first].trials), outcomes_of(report.cells[second].trials));
      if (pairs.disturbed == 0) continue;  // no trial can fail or have a time
      comparisons.push_back(
          {{std::exchange(name, ""), series_of_cell(series, first).name, series_of_cell(series, second).name}, pairs});
    }
  }
  if (comparisons.empty()) return;
  out.leaf("h2", "Comparisons of choices");
  NumberTable table(
      out,
      "Each choice (B) against the first (A), in pairs of equal seeds whose belief was wrong at the start in both. "
      "Failures: McNemar\u2019s exact test. Times, of pairs that came right in both: median of the differences B less "
      "A "
      "with bootstrap interval, s; Wilcoxon\u2019s signed-rank test. The p-values are not corrected for their number.",
      {"case", "A", "B"},
      {"pairs", "A failed", "B failed", "A alone", "B alone", "p of failures", "timed pairs", "B later by [95 %]",
       "p of times"});
  for (const Against& one : comparisons)
    table.add(one.names, numbers_of(one.pairs), one.names.front().empty() ? "" : "group");
}

}  // namespace reorient
