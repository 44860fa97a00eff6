// SPDX-License-Identifier: MIT
// A script in the host.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/script/machine/machine.h"
#include "engine/script/script.h"

namespace reorient {

/// One script: its current version, the last good one, and its state in the engine.
struct ScriptSlot {
  struct Running {
    Machine machine;
    std::string_view seen_state;  ///< at the start of the frame
    double seen_entered_at = 0.0;

    /// Takes over the state that the previous version had at the start of the frame, as a text of this version; the
    /// current state if that state was removed.
    void see_as(const Running& before) {
      const int same = machine.definition().find(std::string(before.seen_state));
      seen_state = same < 0 ? machine.state() : machine.definition().states[static_cast<std::size_t>(same)].path;
      seen_entered_at = same < 0 ? machine.entered_at() : before.seen_entered_at;
    }
  };

  std::string file;
  std::unique_ptr<Script> script;
  std::unique_ptr<Script> last_good;  ///< while the current version is within its trial_time
  BundleHashes read;                  ///< the files as they were last read, accepted or not
  std::vector<Running> machines;
  double swapped_at = 0.0;
  int recent_errors = 0;
  int errors = 0;
  double last_error_at = 0.0;
  std::string last_error;
  bool stopped = false;
  std::int64_t frames = 0;
  std::int64_t instructions_before = 0;
  double microseconds = 0.0;
};

/// Bounds what all scripts may use together, because a recording brings the limits of its scripts. Call it before a
/// version of `slot` is compiled with `limits`. Throws ScriptError.
void require_room(const std::vector<std::unique_ptr<ScriptSlot>>& slots, const ScriptSlot& slot,
                  const ScriptLimits& limits);

}  // namespace reorient
