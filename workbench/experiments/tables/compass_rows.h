// SPDX-License-Identifier: MIT
// How well each method distinguishes a pose from the mirrored pose, over many trials.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/statistics/roc.h"
#include "workbench/experiments/tables/cell_results.h"

namespace reorient {

/// Whether any trial compared compasses.
bool have_looks(const std::vector<CellResults>& cells);

/// The figures after one of kLookTimes.
struct CompassFigure {
  std::vector<RocPoint> curve;  ///< found reflections over false alarms
  double area = 0.0;            ///< below it
  Interval area_interval;       ///< by bootstrap of whole trials
  double equal_error = 0.0;
  Interval equal_error_interval;        ///< Wilson's, as if looks were independent
  double silent = 0.0;                  ///< fraction of looks without evidence of the method
  std::optional<double> flipped;        ///< fraction of mirrored poses that its own rule has flipped by then
  std::optional<double> false_flipped;  ///< the same of right poses; no value: no rule is known
};

struct CompassRow {
  std::vector<std::string> choices;  ///< one for each axis; "all": pooled over it
  std::size_t method = 0;            ///< of kCompassMethods
  int trials = 0;                    ///< with at least one look
  int looks = 0;
  std::array<CompassFigure, kLookTimes.size()> figures;
};

/// Never pools the choices of the last axis. For each of them and each method: a row that is pooled over all other
/// axes; then, for each choice of each other axis with several choices, a row that is pooled over the rest.
std::vector<CompassRow> compass_rows(const Experiment& experiment, const std::vector<CellResults>& cells);

}  // namespace reorient
