// SPDX-License-Identifier: MIT
// The pictures of a run, as in the paper's Figures 4 and 6, drawn from its records only.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "workbench/run/observer.h"
#include "workbench/run/run_history.h"

namespace reorient {

/// The moment of which world and camera are drawn.
enum class PicturedMoment {
  first_reorientation,  ///< the first reorientation, or else the last frame
  last_frame
};

class RunPictures : public Observer {
 public:
  explicit RunPictures(PicturedMoment pictured = PicturedMoment::first_reorientation) : pictured_(pictured) {}

  Topics wanted() const override { return history_.wanted() | Topics{Topic::images, Topic::room}; }
  void observe(const FrameRecord& frame, const SceneTruth& scene) override;
  void finish(const FrameRecord& last, const SceneTruth& scene) override;

  /// Writes world_view, camera_view, confidences and reorientations (.png) into `folder`. Returns one line for each
  /// picture that could not be written.
  std::vector<std::string> write(const std::filesystem::path& folder) const;

 private:
  struct Moment {
    FrameRecord frame;
    SceneTruth scene;
  };
  void keep(const FrameRecord& frame, const SceneTruth& scene);

  PicturedMoment pictured_;
  RunHistory history_;
  std::optional<Moment> moment_;
};

}  // namespace reorient
