// SPDX-License-Identifier: MIT
// `behaviors.orientation.state` and `published.pose_is_searched`: scripts read the machines of other scripts.
#pragma once

#include <string_view>

#include <lua.hpp>

#include "engine/script/machine/machine.h"

namespace reorient {

/// A machine at the start of the frame, before any machine ticks.
struct MachineSight {
  std::string_view state;      ///< path
  double time_in_state = 0.0;  ///< s
};

/// A behavior that another one runs. Its machine ticks after that of its caller.
struct CalledSight {
  bool is_running = false;                  ///< false: the caller is not in a state that runs it
  BehaviorEnd outcome = BehaviorEnd::none;  ///< of the latest run, also after its caller has left the state
  std::string_view reason;                  ///< of the transition into its state, or into that which ended it
  std::string_view state;                   ///< path; empty before its first frame
  double time_in_state = 0.0;               ///< s
};

class MachineDirectory {
 public:
  virtual ~MachineDirectory() = default;
  /// False: unknown machine.
  virtual bool look_up(std::string_view name, MachineSight& sight) const = 0;
  /// Whether a state of any machine that publishes this flag was active at the start of the frame.
  virtual bool is_published(std::string_view flag) const = 0;
  /// False: the caller declares no call of this behavior.
  virtual bool look_up_called(const Machine& caller, std::string_view behavior, CalledSight& sight) const = 0;
};

/// Makes the globals `behaviors` and `published` of `L`; the directory must outlive it.
void add_behavior_view(lua_State* L, const MachineDirectory& directory);

}  // namespace reorient
