// SPDX-License-Identifier: MIT
#include "workbench/recording/replay.h"

#include <utility>

namespace reorient {
namespace {

void append_all(const FrameInputs& from, FrameInputs& to) {
  const auto append = [](auto& all, const auto& more) { all.insert(all.end(), more.begin(), more.end()); };
  append(to.script_edits, from.script_edits);
  append(to.parameter_changes, from.parameter_changes);
  append(to.external.messages, from.external.messages);
}

}  // namespace

void AddedInputs::add(const FrameInputs& more) { append_all(more, next_); }

void AddedInputs::add_to(FrameInputs& inputs) { append_all(std::exchange(next_, {}), inputs); }

Replay::Replay(FrameSource& source, double from, double to) : playback_(nullptr), to_(to) {
  auto playback = std::make_unique<Playback>(source, from, to);
  playback_ = playback.get();
  robot_ = {std::move(playback), {}, RobotInstance::Clock::simulated, nullptr, playback_};
}

FrameLoop* Replay::next_stretch() {
  while (!is_over_ && playback_->next_stretch()) {
    try {
      engine_ = std::make_unique<FrameLoop>(playback_->state());
      ++stretches_;
      return engine_.get();
    } catch (const BadBytes& bad) {
      playback_->skip(bad);
    }
  }
  return nullptr;
}

RunParts Replay::parts(const std::vector<InputSource*>& sources, std::vector<Observer*> observers) {
  RunParts parts{robot_, *engine_, nullptr, nullptr, {playback_}, std::move(observers), {}, 0.0, false};
  parts.sources.insert(parts.sources.end(), sources.begin(), sources.end());
  return parts;
}

void Replay::run(const std::vector<InputSource*>& sources, std::vector<Observer*> observers,
                 const std::function<bool()>& stop) {
  RunParts with_end = parts(sources, std::move(observers));
  with_end.stop = [&] { return (stop && stop()) || engine_->record().world.time >= to_; };
  is_over_ = RunLoop(std::move(with_end)).run() == RunEnd::stopped;
}

}  // namespace reorient
