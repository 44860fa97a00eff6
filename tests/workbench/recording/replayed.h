// SPDX-License-Identifier: MIT
// Replays a recording from its file only.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "workbench/recording/comparison.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/replay.h"
#include "workbench/run/digest_observer.h"

namespace reorient {

struct Replayed {
  std::uint64_t frames = 0, different = 0, stretches = 0, skipped = 0;
  std::string digest;
  std::optional<Difference> first, first_action;
  std::vector<ReplayComparison::Event> events;
  std::vector<std::string> damages;
};

/// Replays from `from` (s of the robot). `what_if` adds to the recorded inputs.
inline Replayed replay(const std::filesystem::path& file, double from = 0.0, InputSource* what_if = nullptr) {
  Recording recording(file);
  Replay again(recording, from);
  ReplayComparison comparison(again.playback());
  DigestObserver digest;
  while (again.next_stretch() != nullptr) {
    std::vector<InputSource*> sources;
    if (what_if != nullptr) sources.push_back(what_if);
    again.run(sources, {&digest, &comparison});
  }
  Replayed replayed;
  replayed.stretches = again.stretches();
  replayed.frames = comparison.frames();
  replayed.different = comparison.different();
  replayed.skipped = again.playback().skipped();
  replayed.digest = digest.hex();
  replayed.first = comparison.first();
  replayed.first_action = comparison.first_action();
  replayed.events = comparison.events();
  replayed.damages = recording.damages();
  return replayed;
}

}  // namespace reorient
