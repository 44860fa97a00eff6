// SPDX-License-Identifier: MIT
// The generated parts of a behavior's page: the states as a diagram, the parameters and arguments as tables.
#pragma once

#include <span>
#include <string>

#include "engine/parameters/parameter.h"
#include "engine/script/machine/machine_definition.h"

namespace reorient {

/// The page with the part between "<!-- generated: states -->" (or parameters, or arguments) and "<!-- end -->"
/// regenerated. `parameters`: those that the script itself declares; only a script with `args` needs the last part.
/// Throws std::runtime_error if a mark is missing.
std::string with_generated_parts(const std::string& page, const MachineDefinition& machine,
                                 std::span<const ParameterDeclaration> parameters,
                                 std::span<const ParameterDeclaration> arguments = {});

}  // namespace reorient
