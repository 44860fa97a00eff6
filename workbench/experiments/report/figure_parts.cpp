// SPDX-License-Identifier: MIT
// Parts that the figures share.
#include "workbench/experiments/report/figures.h"

namespace reorient {

void draw_legend(Markup& out, const std::vector<Series>& series, bool wrong) {
  const Element list(out, "ul", {{"class", "legend"}});
  for (const Series& one : series) {
    const Element item(out, "li");
    {
      const Element swatch(out, "svg", {{"viewBox", "0 0 30 10"}, {"class", "swatch"}, {"aria-hidden", "true"}});
      out.single("line", {{"class", "line " + one.style}, {"x1", "1"}, {"x2", "29"}, {"y1", "5"}, {"y2", "5"}});
    }
    out.text(one.name);
  }
  if (!wrong) return;
  const Element item(out, "li");
  {
    const Element swatch(out, "svg", {{"viewBox", "0 0 30 10"}, {"class", "swatch"}, {"aria-hidden", "true"}});
    out.single("rect", {{"class", "wrong"}, {"width", "30"}, {"height", "10"}});
  }
  out.text("the belief is wrong");
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
