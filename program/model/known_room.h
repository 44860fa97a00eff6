// SPDX-License-Identifier: MIT
// The room model of the engine at the end of a run.
#pragma once

#include <optional>
#include <vector>

#include "perception/room/saved_model.h"
#include "workbench/run/observer.h"

namespace reorient {

class KnownRoom : public Observer {
 public:
  Topics wanted() const override { return Topics{Topic::room}; }
  void observe(const FrameRecord& frame, const SceneTruth& /*scene*/) override {
    basis_ = frame.room.basis;
    tiles_ = frame.room.model;
    learned_ = frame.world.trained_seconds;
    if (const auto known = known_bias(frame.world)) camera_bias_ = known;
  }
  /// Nothing if room awareness is off.
  std::optional<SavedModel> model() const {
    if (tiles_.empty()) return std::nullopt;
    return SavedModel{basis_, learned_, BackgroundModel(tiles_), camera_bias_};
  }

 private:
  ModelBasis basis_;
  std::vector<TileModel> tiles_;
  double learned_ = 0.0;
  std::optional<KnownBias> camera_bias_;
};

}  // namespace reorient
