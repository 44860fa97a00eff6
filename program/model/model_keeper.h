// SPDX-License-Identifier: MIT
// Keeps what a run learns of the room in a file.
#pragma once

#include <cstdint>
#include <filesystem>
#include <limits>
#include <optional>
#include <string>

#include "perception/room/saved_model.h"
#include "program/background_writing.h"
#include "workbench/run/observer.h"

namespace reorient {

/// A model from a file, for a robot whose cameras are taken to be mounted like this (mounting_of()): a bias that was
/// learned with another calibration is one of another body.
std::optional<SavedModel> as_mounted(std::optional<SavedModel> model, std::uint64_t mounting);

/// Every half minute of the robot's time, so that little is lost when it is switched off, and at the end. The file
/// keeps the axes that it was begun with, however the teams change sides. A disk is slow: no frame waits for it.
class ModelKeeper : public Observer {
 public:
  /// `loaded`: what the file held, as the run took it. `sides_changed`: the run's axes are the file's, turned.
  /// `mounting`: as in as_mounted(); `loaded` is the model as it was before that.
  ModelKeeper(std::filesystem::path file, const std::optional<SavedModel>& loaded, bool sides_changed,
              std::uint64_t mounting = 0);

  Topics wanted() const override { return {Topic::room}; }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;
  void finish(const FrameRecord& last, const SceneTruth& scene) override;

  /// When the run is over. Throws std::runtime_error with one line where what was learned could not be saved.
  void save();
  /// In a few words, what became of the file.
  std::string outcome() const;

 private:
  /// What must not be lost.
  struct Kept {
    ModelBasis basis;
    int known_tiles = 0;
  };

  std::optional<SavedModel> news(const FrameRecord& frame);

  std::filesystem::path file_;
  bool sides_changed_;
  std::uint64_t mounting_;
  std::optional<Kept> kept_;                             // in the file
  double learned_before_;                                // s, by the time of the last look at it
  std::optional<KnownBias> camera_bias_;                 // the latest that is worth keeping
  bool any_news_ = false;                                // of this run
  bool is_saved_ = false;                                // with what the run ended with
  bool is_forgotten_ = false;                            // by the run, not by the file
  std::optional<SavedModel> end_;                        // what the run ended with
  double next_ = std::numeric_limits<double>::lowest();  // s, in the robot's time
  BackgroundWriting writing_;
};

}  // namespace reorient
