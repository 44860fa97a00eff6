// From a run's history to what is drawn of it.
#pragma once

#include <vector>

#include "workbench/run/run_history.h"
#include "workbench/views/pictures/confidence_plot.h"
#include "workbench/views/pictures/reorientation_view.h"

namespace reorient::pictures {

ConfidencePlot confidence_plot_of(const RunHistory& history);
std::vector<ReorientationPanels> reorientations_of(const RunHistory& history);

}  // namespace reorient::pictures
