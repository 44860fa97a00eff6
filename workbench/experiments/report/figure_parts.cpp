// SPDX-License-Identifier: MIT
// Parts that the figures share.
#include "workbench/experiments/report/figures.h"

namespace reorient {

void draw_entries(Markup& out, const std::vector<LegendEntry>& entries) {
  const Element list(out, "ul", {{"class", "legend"}});
  for (const LegendEntry& entry : entries) {
    const Element item(out, "li");
    {
      const Element swatch(out, "svg", {{"viewBox", "0 0 30 10"}, {"class", "swatch"}, {"aria-hidden", "true"}});
      if (entry.is_area) {
        out.single("rect", {{"class", entry.style}, {"width", "30"}, {"height", "10"}});
      } else {
        out.single("line", {{"class", "line " + entry.style}, {"x1", "1"}, {"x2", "29"}, {"y1", "5"}, {"y2", "5"}});
      }
    }
    out.text(entry.name);
  }
}

void draw_legend(Markup& out, const std::vector<Series>& series) {
  std::vector<LegendEntry> entries;
  entries.reserve(series.size());
  for (const Series& one : series) entries.push_back({one.name, one.style});
  draw_entries(out, entries);
}

void draw_caption(Markup& out, const Report& report, std::string_view caption) {
  const Element element(out, "figcaption");
  out.text(caption);
  const Element made(out, "span", {{"class", "made"}});
  const Provenance& from = report.provenance;
  out.leaf("code", from.command);
  out.text(" \u00b7 reorient " + from.version + " \u00b7 seeds " + seeds_of(report) + " \u00b7 " + from.machine +
           " \u00b7 " + from.when);
}

}  // namespace reorient
