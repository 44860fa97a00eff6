// SPDX-License-Identifier: MIT
// Parameters of the compared compasses: room awareness and its peers.
#pragma once

#include <vector>

#include "engine/parameters/parameter.h"
#include "workbench/experiments/peers/compass_methods.h"

namespace reorient {

/// Removes and returns the parameters of the peers, which no other run knows.
std::vector<ParameterChange> without_peers(std::vector<ParameterChange> changes);

/// The shipped parameters with these changes; the paper's recipe is that of assets/parameters/paper.toml, and nothing
/// else. Throws std::runtime_error with one line where a peer has no such parameter, or a value does not fit.
CompassParameters compass_parameters(const std::vector<ParameterChange>& changes);

}  // namespace reorient
