// SPDX-License-Identifier: MIT
#include "workbench/experiments/report/conditions.h"

#include <string>

#include "workbench/experiments/condition/resolved_text.h"

namespace reorient {
namespace {

/// "faster head; parameters.head_scan.speed = 2.0"
std::string meaning_of(const AxisChoice& choice) {
  std::string text = choice.description;
  for (const std::string& line : settings_of(choice.patch)) text += (text.empty() ? "" : "; ") + line;
  return text.empty() ? "nothing is changed" : text;
}

void draw_axis(Markup& out, const Axis& axis) {
  out.leaf("h3", "Axis " + axis.name);
  if (!axis.description.empty()) out.leaf("p", axis.description);
  const Element list(out, "dl");
  for (const AxisChoice& choice : axis.choices) {
    out.leaf("dt", choice.name);
    out.leaf("dd", meaning_of(choice));
  }
}

}  // namespace

void draw_conditions(Markup& out, const Report& report) {
  out.leaf("h2", "Conditions");
  for (const Axis& axis : report.experiment.axes) draw_axis(out, axis);
  const Element details(out, "details");
  out.leaf("summary", "The whole experiment as one file; condition files are resolved");
  out.leaf("pre", resolved_text(report.experiment));
}

}  // namespace reorient
