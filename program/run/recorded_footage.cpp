// SPDX-License-Identifier: MIT
#include "program/run/recorded_footage.h"

#include <algorithm>
#include <optional>
#include <string>

#include "geometry/bytes.h"
#include "workbench/recording/playback.h"
#include "workbench/recording/recording.h"

namespace reorient {
namespace {

class RecordedFootage : public FootageSource {
 public:
  explicit RecordedFootage(const std::filesystem::path& file)
      : name_(file.string()), recording_(file), playback_(recording_, recording_.begin_time(), recording_.end_time()) {}

  bool next(FootageFrame& frame) override try {
    while (true) {
      if (!in_stretch_) in_stretch_ = playback_.next_stretch();
      if (!in_stretch_) {
        if (!recording_.damages().empty()) throw BadFootage(name_ + ": " + recording_.damages().front());
        return false;
      }
      in_stretch_ = playback_.observe(observation_);
      if (!in_stretch_ || !observation_.upper) continue;
      fill(frame);
      return true;
    }
  } catch (const BadBytes& error) {
    throw BadFootage(name_ + ": " + error.what());
  }

 private:
  void fill(FootageFrame& frame) const {
    const CameraFrame& upper = *observation_.upper;
    frame = {};
    frame.time = observation_.time;
    frame.name = "frame " + std::to_string(playback_.frame().entry.frame);
    const ImageView& image = upper.image;
    frame.image = Image(image.width, image.height);
    for (int y = 0; y < image.height; ++y)
      std::copy_n(image.row(y), 2 * static_cast<std::size_t>(image.width), frame.image.row(y));
    const bool same_size = upper.camera.width == image.width && upper.camera.height == image.height;
    frame.camera = same_size ? upper.camera : upper.camera.scaled_to(image.width, image.height);
    frame.robot_from_camera = upper.robot_from_camera;
    frame.torso = observation_.body.torso;
    frame.odometry = observation_.odometry;
    const SceneTruth& scene = playback_.frame().entry.scene;
    if (scene.truth && !scene.truth->carried) frame.pose = scene.truth->pose;
  }

  std::string name_;
  Recording recording_;
  Playback playback_;
  Observation observation_;
  bool in_stretch_ = false;
};

}  // namespace

bool is_recording(const std::filesystem::path& file) try {
  static_cast<void>(Recording(file));
  return true;
} catch (const std::runtime_error&) {
  return false;
}

std::unique_ptr<FootageSource> open_recorded_footage(const std::filesystem::path& file) try {
  return std::make_unique<RecordedFootage>(file);
} catch (const std::runtime_error& error) {
  throw BadFootage(error.what());
}

}  // namespace reorient
