// SPDX-License-Identifier: MIT
// Saves the room model of a run in a file.
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

/// A model from a file, for a robot with this mounting of its cameras (mounting_of()): a bias that was learned with
/// another calibration belongs to another body.
std::optional<SavedModel> as_mounted(std::optional<SavedModel> model, std::uint64_t mounting);

/// Saves every half minute of the robot's time, so that little is lost when it is switched off, and at the end. The
/// file keeps its first axes when the teams change sides. A disk is slow, so no frame waits for it.
class ModelKeeper : public Observer {
 public:
  /// `loaded`: the model that the run loaded. `sides_changed`: the run's axes are the file's, rotated by 180 degrees.
  /// `mounting`: as in as_mounted(); `loaded` is the model as it was before that.
  ModelKeeper(std::filesystem::path file, const std::optional<SavedModel>& loaded, bool sides_changed,
              std::uint64_t mounting = 0);

  Topics wanted() const override { return {Topic::room}; }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;
  void finish(const FrameRecord& last, const SceneTruth& scene) override;

  /// Call at the end of the run. Throws std::runtime_error with one line if the model cannot be saved.
  void save();
  /// What happened to the file, in a few words.
  std::string outcome() const;

 private:
  /// The part of the model that must not be lost.
  struct Kept {
    ModelBasis basis;
    int known_tiles = 0;
  };

  std::optional<SavedModel> news(const FrameRecord& frame);

  std::filesystem::path file_;
  bool sides_changed_;
  std::uint64_t mounting_;
  std::optional<Kept> kept_;                             // in the file
  double learned_before_;                                // s, at the last check
  std::optional<KnownBias> camera_bias_;                 // the latest one to save
  bool any_news_ = false;                                // learned in this run
  bool is_saved_ = false;                                // with the final state of the run
  bool is_forgotten_ = false;                            // by the run, not by the file
  std::optional<SavedModel> end_;                        // the model at the end of the run
  double next_ = std::numeric_limits<double>::lowest();  // s, in the robot's time
  BackgroundWriting writing_;
};

}  // namespace reorient
