#include "workbench/views/pictures/history_views.h"

#include <string>

namespace reorient::pictures {
namespace {

std::string short_name(Reorientation reorientation) {
  const std::string name(to_string(reorientation));
  return name.substr(0, name.find('_'));
}

Condition condition_of(RunCondition condition) {
  switch (condition) {
    case RunCondition::training:
      return Condition::training;
    case RunCondition::evaluation_paused:
      return Condition::evaluation_paused;
    case RunCondition::belief_reflected:
      return Condition::belief_reflected;
    case RunCondition::lifted:
      return Condition::carried;
    case RunCondition::down:
      return Condition::fallen;
  }
  return Condition::training;
}

}  // namespace

ConfidencePlot confidence_plot_of(const RunHistory& history) {
  ConfidencePlot plot;
  for (const ConfidencePoint& point : history.points())
    plot.samples.push_back({point.time, point.current, point.opposite, point.raw_current, point.raw_opposite});
  for (const reorient::CommandMark& mark : history.commands())
    plot.commands.push_back({mark.time, short_name(mark.reorientation), mark.granted});
  for (const reorient::ConditionInterval& interval : history.intervals())
    plot.conditions.push_back({condition_of(interval.condition), interval.from, interval.to});
  return plot;
}

std::vector<ReorientationPanels> reorientations_of(const RunHistory& history) {
  std::vector<ReorientationPanels> panels;
  for (const ReorientationSnapshot& snapshot : history.reorientations()) {
    panels.push_back({short_name(snapshot.reorientation),
                      snapshot.time,
                      {snapshot.particles_before, snapshot.truth, snapshot.belief_before},
                      {snapshot.particles_after, snapshot.truth, snapshot.belief_after}});
  }
  return panels;
}

}  // namespace reorient::pictures
