// What scripts see of the world, declared once: the Lua tables, the reference page and the editor annotations are all
// made from this list.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "engine/world/world.h"

namespace reorient {

/// Where a field lives in a world; nullptr where it is not known at the moment. Only tests write through it.
using WorldAccess = std::variant<double* (*)(World&), bool* (*)(World&), int* (*)(World&), std::uint64_t* (*)(World&)>;

struct WorldField {
  std::string_view table;  ///< "robot"
  std::string_view name;   ///< "fallen"
  std::string_view unit;   ///< "m", or empty
  std::string_view description;
  WorldAccess access;
  bool for_scenarios = false;  ///< behaviours do not get it

  bool is_boolean() const { return std::holds_alternative<bool* (*)(World&)>(access); }
  std::string full_name() const { return std::string(table) + "." + std::string(name); }
};

std::span<const WorldField> world_fields();

struct WorldTable {
  std::string_view name;
  std::string_view description;
};

/// The tables of world_fields(), in the order in which they are documented.
std::span<const WorldTable> world_tables();

/// One frame's values of all fields, in the order of world_fields(); a boolean is 0 or 1, NaN: not known.
void read_world(const World& world, std::vector<double>& values);

/// Throws std::runtime_error with one line when there is no such field or it takes no such value.
void write_world(World& world, std::string_view table, std::string_view name, double value, bool is_boolean);

}  // namespace reorient
