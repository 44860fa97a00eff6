// SPDX-License-Identifier: MIT
#include "workbench/views/pictures/run_pictures.h"

#include "workbench/files/atomic_file.h"
#include "workbench/views/pictures/canvas/png_file.h"
#include "workbench/views/pictures/confidence_plot.h"
#include "workbench/views/pictures/record_views.h"
#include "workbench/views/pictures/reorientation_view.h"

namespace reorient {

void RunPictures::observe(const FrameRecord& frame, const SceneTruth& scene) {
  history_.observe(frame, scene);
  if (!moment_ && frame.reorientation && pictured_ == PicturedMoment::first_reorientation) keep(frame, scene);
}

void RunPictures::finish(const FrameRecord& last, const SceneTruth& scene) {
  if (!moment_ || pictured_ == PicturedMoment::last_frame) keep(last, scene);
}

void RunPictures::keep(const FrameRecord& frame, const SceneTruth& scene) {
  moment_.emplace(Moment{frame, scene});
  moment_->frame.own_images();
}

std::vector<std::string> RunPictures::write(const std::filesystem::path& folder) const {
  std::vector<std::string> failures;
  const auto write = [&](const char* name, const pictures::Picture& picture) {
    try_to_write(failures, [&] { pictures::write_png(folder / name, picture); });
  };
  if (moment_) {
    write("world_view.png", draw_world_view(pictures::world_view_of(moment_->frame, moment_->scene)));
    write("camera_view.png", draw_camera_view(pictures::camera_view_of(moment_->frame)));
  }
  const FieldDimensions field = moment_ ? moment_->frame.world.field : FieldDimensions();
  write("confidences.png", draw_confidence_plot(pictures::confidence_plot_of(history_)));
  write("reorientations.png", pictures::draw_reorientation_view(field, history_.reorientations()));
  return failures;
}

}  // namespace reorient
