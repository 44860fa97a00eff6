// SPDX-License-Identifier: MIT
// The fields of the world that behaviors read, declared once: the Lua tables, the reference page and the editor
// annotations are generated from this list.
#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "engine/script/language/script_language.h"
#include "engine/world/world.h"

namespace reorient {

std::span<const WorldField> world_fields();

/// The tables of world_fields(), in the order in which they are documented.
std::span<const WorldTable> world_tables();

/// Appends one frame's values of all fields, in the order of world_fields(); a boolean is 0 or 1, a name its index.
void append_world(const World& world, std::vector<double>& values);

/// For tests: sets a field, as `set_world { table = { name = value } }` does. Throws std::runtime_error with one line
/// if the field is unknown or the value is invalid.
struct WorldValue {
  WorldField::Type type = WorldField::Type::number;
  double number = 0.0;  ///< of a boolean: 0 or 1
  std::string_view name;
};
/// Returns the field, whose name may be a former one.
const WorldField& write_world(World& world, std::string_view table, std::string_view name, const WorldValue& value);

/// The number that a value stands for in this field. Throws as write_world().
double checked_value(const WorldField& field, const WorldValue& value);

}  // namespace reorient
