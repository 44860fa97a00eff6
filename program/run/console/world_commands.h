// SPDX-License-Identifier: MIT
// Commands of the prompt for world fields: print them once, or watch them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/world/world.h"
#include "program/run/console/command.h"

namespace reorient {

/// The value of a world field, as "0.123 m"; "not known" for an unknown one.
std::string value_text(const World& world, std::string_view field);

class WorldCommands {
 public:
  WorldCommands();

  /// The values of all fields whose names match.
  Reply look(const std::string& pattern) const;
  /// Prints these values whenever they change. An empty pattern: lists the watched values.
  Reply watch(const std::string& pattern);
  /// An empty pattern: all.
  Reply unwatch(const std::string& pattern);

  /// Lines about changed values; each value at most twice a second of the robot's time.
  std::string changes(const World& world);

  const Words& names() const { return names_; }
  Words watched() const;

 private:
  struct Watched {
    std::size_t field;        ///< of world_fields()
    std::string printed;      ///< as it was printed last
    double printed_at = 0.0;  ///< s
  };

  Words names_;  ///< of world_fields()
  std::vector<Watched> watched_;
};

}  // namespace reorient
