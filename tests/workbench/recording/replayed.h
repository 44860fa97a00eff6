// A recording, made again from its file alone.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "workbench/recording/comparison.h"
#include "workbench/recording/playback.h"
#include "workbench/recording/recording.h"
#include "workbench/run/digest_observer.h"
#include "workbench/run/run_loop.h"

namespace reorient {

struct Replayed {
  std::uint64_t frames = 0, different = 0, stretches = 0, passed_over = 0;
  std::string digest;
  std::optional<Difference> first, first_action;
  std::vector<ReplayComparison::Event> events;
  std::vector<std::string> damages;
};

/// From `from` (s of the robot) on; `what_if`: adds to what was recorded.
inline Replayed replay(const std::filesystem::path& file, double from = 0.0, InputSource* what_if = nullptr) {
  Recording recording(file);
  auto playback = std::make_unique<Playback>(recording, from);
  Playback& itself = *playback;
  RobotInstance robot{std::move(playback), {}, RobotInstance::Clock::simulated, nullptr, &itself};
  ReplayComparison comparison(itself);
  DigestObserver digest;
  Replayed replayed;
  while (itself.next_stretch()) {
    ++replayed.stretches;
    FrameLoop engine(itself.state());
    RunParts parts{robot, engine, nullptr, nullptr, {&itself}, {&digest, &comparison}, {}, 0.0, false};
    if (what_if != nullptr) parts.sources.push_back(what_if);
    RunLoop(std::move(parts)).run();
  }
  replayed.frames = comparison.frames();
  replayed.different = comparison.different();
  replayed.passed_over = itself.passed_over();
  replayed.digest = digest.hex();
  replayed.first = comparison.first();
  replayed.first_action = comparison.first_action();
  replayed.events = comparison.events();
  replayed.damages = recording.damages();
  return replayed;
}

}  // namespace reorient
