// SPDX-License-Identifier: MIT
#include "workbench/experiments/report/page.h"

#include "engine/parameters/counted.h"
#include "workbench/experiments/report/conditions.h"
#include "workbench/experiments/report/figures.h"
#include "workbench/experiments/report/style.h"
#include "workbench/experiments/report/tables.h"

namespace reorient {
namespace {

void draw_facts(Markup& out, const Report& report) {
  const Provenance& from = report.provenance;
  std::size_t trials = 0;
  for (const CellResults& cell : report.cells) trials += cell.trials.size();
  const Element list(out, "dl");
  const auto add = [&out](std::string_view name, std::string_view value) {
    out.leaf("dt", name);
    out.leaf("dd", value);
  };
  out.leaf("dt", "Command");
  {
    const Element command(out, "dd");
    out.leaf("code", from.command);
  }
  add("Trials", std::to_string(trials) + " in " + counted(report.cells.size(), "cell"));
  add("Seeds", seeds_of(report) + ", the same in each cell");
  add("Version", "reorient " + from.version);
  add("Machine", from.machine);
  add("Written", from.when);
}

/// One sentence with the failures of each choice.
std::string finding_of(const Report& report) {
  std::string text;
  for (const Series& series : series_of(report)) {
    int failed = 0, disturbed = 0;
    for (const std::size_t cell : series.cells) {
      failed += report.cells[cell].row.failed;
      disturbed += report.cells[cell].row.disturbed;
    }
    if (disturbed == 0) continue;
    text += (text.empty() ? "Of the trials with a wrong belief at the start, these failed: " : "; ") + series.name +
            " " + std::to_string(failed) + " of " + std::to_string(disturbed);
  }
  return text.empty()
             ? "No trial had a wrong belief at its start, so the trials only show whether a right belief is flipped."
             : text + ".";
}

void draw_header(Markup& out, const Report& report) {
  const Element header(out, "header");
  out.leaf("p", "Reorient experiment \u00b7 " + report.experiment.name, {{"class", "kicker"}});
  out.leaf("h1", report.experiment.title);
  if (!report.experiment.description.empty()) out.leaf("p", report.experiment.description);
  out.leaf("p", finding_of(report));
  draw_facts(out, report);
}

void draw_method(Markup& out) {
  out.leaf("h2", "Method");
  const Element list(out, "ul", {{"class", "notes"}});
  for (const std::string_view note :
       {"A trial is a simulated run; its clock starts when its scenario enters the state `measured_from`. If the "
        "belief is wrong then, the trial shows how it is corrected; otherwise, whether a right belief is flipped. A "
        "trial whose clock never starts has failed.",
        "A belief counts as right from the first time within the limit after which it stays right for the required "
        "duration. If there is no such time, the trial has failed: its time is censored, not left out.",
        "The trials of all cells have the same seeds, so the same noise and people. Choices are compared in pairs.",
        "All intervals and bands are of 95 %. Fractions: Wilson 1927. Rates: Garwood 1936. Means and medians: 2000 "
        "bootstrap "
        "resamples (Efron 1979), percentiles. Curves: Kaplan and Meier 1958; bands: Kalbfleisch and Prentice 1980. "
        "Paired: McNemar 1947, exact; Wilcoxon 1945, exact up to 300 pairs."})
    out.leaf("li", note);
}

void draw_files(Markup& out) {
  out.leaf("h2", "The data");
  const Element list(out, "ul", {{"class", "notes"}});
  constexpr std::pair<std::string_view, std::string_view> kFiles[] = {
      {"rows.json", "the rows as --json writes them, with the outcome of each trial"},
      {"trials.csv", "a line for each trial"},
      {"trials.json", "each trial with all measurements, including the confidences"}};
  for (const auto& [file, text] : kFiles) {
    const Element item(out, "li");
    out.leaf("a", file, {{"href", file}});
    out.text(": " + std::string(text));
  }
}

}  // namespace

std::string report_page(const Report& report) {
  Markup out;
  out.raw("<!DOCTYPE html>\n");
  {
    const Element html(out, "html", {{"lang", "en"}});
    {
      const Element head(out, "head");
      out.single("meta", {{"charset", "utf-8"}});
      out.single("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}});
      out.leaf("title", report.experiment.title);
      const Element style(out, "style");
      out.raw(report_style());
    }
    const Element body(out, "body");
    draw_header(out, report);
    {
      const Element content(out, "main");
      out.leaf("h2", "Results");
      draw_compasses(out, report);
      draw_rows(out, report);
      draw_measures(out, report);
      draw_failures(out, report);
      draw_references(out, report);
      draw_time_to_right(out, report);
      draw_comparisons(out, report);
      draw_false_flips(out, report);
      draw_ladder(out, report);
      draw_roc(out, report);
      draw_reliability(out, report);
      draw_confidences(out, report);
      draw_conditions(out, report);
      draw_method(out);
      draw_files(out);
    }
    const Element footer(out, "footer");
    out.leaf("code", report.provenance.command);
  }
  return out.str();
}

}  // namespace reorient
