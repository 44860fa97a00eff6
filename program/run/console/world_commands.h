// SPDX-License-Identifier: MIT
// Commands of the prompt for world fields and for the values of an application: print them once, or watch them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "engine/record/frame_record.h"
#include "program/run/console/command.h"

namespace reorient {

/// The value of a world field or of an application, as "0.123 m"; "not known" for an unknown one.
std::string value_text(const FrameRecord& frame, std::string_view name);

class WorldCommands {
 public:
  explicit WorldCommands(const ApplicationInterface& declared = {}) { take_application(declared); }

  /// The names of an application's values join those of the world.
  void take_application(const ApplicationInterface& declared);

  /// The values of all fields whose names match.
  Reply look(const std::string& pattern) const;
  /// Prints these values whenever they change. An empty pattern: lists the watched values.
  Reply watch(const std::string& pattern);
  /// An empty pattern: all.
  Reply unwatch(const std::string& pattern);

  /// Lines about changed values; each value at most twice a second of the robot's time.
  std::string changes(const FrameRecord& frame);

  const Words& names() const { return names_; }
  Words watched() const;

 private:
  struct Watched {
    std::string name;
    std::string printed;      ///< as it was printed last
    double printed_at = 0.0;  ///< s
  };

  Words names_;
  std::vector<Watched> watched_;
};

}  // namespace reorient
