// SPDX-License-Identifier: MIT
// What the compared compasses are made of: room awareness and its peers have parameters as everything has.
#pragma once

#include <vector>

#include "engine/parameters/parameter.h"
#include "workbench/experiments/peers/compass_methods.h"

namespace reorient {

/// Takes out what is set of the peers, which no run but theirs knows.
std::vector<ParameterChange> without_peers(std::vector<ParameterChange> changes);

/// The shipped parameters with these changes; the paper's recipe is that of assets/parameters/paper.toml, and nothing
/// else. Throws std::runtime_error with one line where a peer has no such parameter, or a value does not fit.
CompassParameters compass_parameters(const std::vector<ParameterChange>& changes);

}  // namespace reorient
