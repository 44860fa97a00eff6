// SPDX-License-Identifier: MIT
// Published results, shown beside the rows of this project.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace reorient {

/// The published values of a row; fractions from 0 to 1.
struct Reference {
  std::string label;  ///< "paper, real robot"
  std::vector<std::pair<std::string, std::string>>
      choices;  ///< axis and choice: selects the rows beside which it is shown
  std::optional<int> trials;
  std::optional<double> flip;
  std::optional<double> purge;
  std::optional<double> failed;
  std::optional<double> mean_s;
  std::optional<double> flip_mean_s;
  std::optional<double> purge_mean_s;
};

}  // namespace reorient
