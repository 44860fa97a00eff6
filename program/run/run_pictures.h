// The pictures of a run, as the paper's Figures 4 and 6: collected while it runs, written when it is over.
#pragma once

#include <filesystem>
#include <optional>

#include "engine/frame.h"
#include "workbench/run/run_history.h"
#include "workbench/views/pictures/canvas/picture.h"

namespace reorient {

class RunPictures {
 public:
  /// Draws world view and camera view in the frame of a reorientation: the moment that a run is about.
  void look(const FrameLoop& frame);

  /// Writes world_view, camera_view, confidences and reorientations (.png) into `folder`; where nothing was reoriented,
  /// world and camera are those of the last frame. Throws std::runtime_error where a file cannot be written.
  void write(const FrameLoop& frame, const RunHistory& history, const std::filesystem::path& folder) const;

 private:
  std::optional<pictures::Picture> world_;
  std::optional<pictures::Picture> camera_;
};

}  // namespace reorient
