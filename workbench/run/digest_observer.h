// SPDX-License-Identifier: MIT
// The fingerprint of a run.
#pragma once

#include <string>

#include "engine/record/record_bytes.h"
#include "workbench/run/observer.h"

namespace reorient {

/// Computed from all inputs, beliefs and decisions: the same inputs give the same 64 bits.
class DigestObserver : public Observer {
 public:
  Topics wanted() const override { return {Topic::images}; }
  void observe(const FrameRecord& frame, const SceneTruth& /*scene*/) override { digest_.add(frame); }

  std::string hex() const { return digest_.digest().hex(); }

 private:
  RecordDigest digest_;
};

}  // namespace reorient
