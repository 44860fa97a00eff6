// SPDX-License-Identifier: MIT
// Parameters of the compared compasses: room awareness and its peers.
#pragma once

#include <vector>

#include "engine/parameters/parameter.h"
#include "workbench/experiments/peers/compass_methods.h"

namespace reorient {

/// Removes and returns the parameters of the peers, which exist only in comparisons.
std::vector<ParameterChange> without_peers(std::vector<ParameterChange> changes);

/// The parameters of the peers, with these changes. Throws std::runtime_error with one line if a value is invalid.
std::vector<Parameter> peer_parameters(const std::vector<ParameterChange>& changes);

/// The shipped parameters with these changes; the paper's recipe is exactly assets/parameters/paper.toml. Throws
/// std::runtime_error with one line if a peer does not have the parameter, or a value is invalid.
CompassParameters compass_parameters(const std::vector<ParameterChange>& changes);

}  // namespace reorient
