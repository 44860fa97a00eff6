// SPDX-License-Identifier: MIT
#include "workbench/recording/playback.h"

#include <string>
#include <utility>

namespace reorient {

Playback::Playback(FrameSource& source, double from, double to) : source_(source), to_(to + kReadingError) {
  is_over_ = !source_.go_to(from);
}

bool Playback::next_stretch() {
  while (!is_over_) {
    if ((!std::exchange(is_waiting_, false) && !source_.next(frame_)) || frame_.entry.time > to_) {
      is_over_ = true;
      break;
    }
    if (!frame_.state.empty() && frame_.entry.is_exact()) {
      begins_ = true;
      return true;
    }
    ++skipped_;
  }
  return false;
}

bool Playback::observe(Observation& observation) {
  if (is_over_ || is_waiting_) return false;
  if (!std::exchange(begins_, false)) {
    if (!source_.next(frame_)) {
      is_over_ = true;
      return false;
    }
    if (!frame_.follows || !frame_.entry.is_exact()) {
      is_waiting_ = true;
      return false;
    }
  }
  try {
    take_inputs();
  } catch (const BadBytes& bad) {
    source_.add_damage(frame_, bad.what());
    frame_.state.clear();  // so that the next section does not begin with this frame
    is_waiting_ = true;
    return false;
  }
  observation = inputs_->inputs().observation;
  return true;
}

void Playback::skip(const BadBytes& reason) {
  source_.add_damage(frame_, std::string("the state of the engine: ") + reason.what());
  begins_ = false;
  ++skipped_;
}

void Playback::take_inputs() {
  inputs_.emplace(frame_.entry.inputs);
  const Observation& seen = inputs_->inputs().observation;
  const bool has_frame[] = {seen.upper.has_value(), seen.lower.has_value()};
  for (std::size_t camera = 0; camera < frame_.images.size(); ++camera) {
    if (!frame_.entry.image_is_exact[camera]) continue;
    check_bytes(has_frame[camera], "a frame and its images do not match");
    inputs_->put_pixels(camera, frame_.images[camera].view());
  }
}

void Playback::add_to(FrameInputs& inputs) {
  inputs.parameter_changes = inputs_->inputs().parameter_changes;
  inputs.script_edits = inputs_->inputs().script_edits;
  inputs.external = inputs_->inputs().external;
}

std::optional<GroundTruth> Playback::truth() const {
  std::optional<GroundTruth> truth = frame_.entry.scene.truth;
  if (truth) truth->pose = in_axes_of_team(truth->pose, frame_.entry.sides_changed);
  return truth;
}

}  // namespace reorient
