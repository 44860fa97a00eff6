// SPDX-License-Identifier: MIT
// Digest of the beliefs, decisions and actions of a run, without names and texts.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "engine/record/record_bytes.h"
#include "geometry/bytes.h"
#include "workbench/run/observer.h"

namespace reorient {

/// Does not change with names of states, reasons and log texts. DigestObserver contains these, too.
struct NumberDigest : Observer {
  Topics wanted() const override { return {}; }
  void observe(const FrameRecord& frame, const SceneTruth& /*scene*/) override {
    bytes_.clear();
    for (const Topic topic : {Topic::inputs, Topic::world, Topic::percepts, Topic::answer})
      write_topic(frame, topic, bytes_);
    ByteWriter writer(bytes_);
    for (const CommandRecord& command : frame.commands)
      writer(command.request.reorientation, command.request.priority, command.verdict);
    for (const Lease& lease : frame.leases) writer(lease.pause);
    if (const auto& granted = frame.reorientation)
      writer(granted->reorientation, granted->belief_before, granted->belief_after);
    digest_.add(bytes_);
  }
  std::string hex() const { return digest_.hex(); }

 private:
  Digest digest_;
  std::vector<std::byte> bytes_;
};

}  // namespace reorient
