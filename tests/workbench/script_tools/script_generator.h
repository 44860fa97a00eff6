// SPDX-License-Identifier: MIT
// Valid behaviors, generated at random.
#pragma once

#include <cstdint>
#include <string>

namespace reorient {

/// The text of a behavior that can be loaded and runs without an error. It uses most features of scripts: parameters,
/// memory, nested states, functions with and without optional arguments, metatables, closures. `number` is the seed and
/// part of the name.
std::string generated_script(std::uint64_t number);

/// "generated_17"
std::string generated_name(std::uint64_t number);

}  // namespace reorient
