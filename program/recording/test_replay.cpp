// SPDX-License-Identifier: MIT
#include "program/recording/test_replay.h"

#include <memory>
#include <optional>
#include <stdexcept>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "geometry/bytes.h"
#include "workbench/files/script_files.h"
#include "workbench/recording/comparison.h"
#include "workbench/recording/replay.h"

namespace reorient {
namespace {

class Played : public PlayedRecording {
 public:
  Played(const std::filesystem::path& file, const ScriptTexts& scripts)
      : recording_(file), replay_(recording_), comparison_(replay_.playback()), engine_(replay_.next_stretch()) {
    if (engine_ == nullptr) {
      throw std::runtime_error(file.string() +
                               ": expected frames that can be replayed, found none; see 'reorient recording info'");
    }
    FrameInputs first;
    first.script_edits = edits_between(engine_->scripts(), scripts);
    added_.add(first);
    loop_.emplace(replay_.parts({&added_}, {&comparison_}));
  }

  const FrameRecord* step(const FrameInputs& added) override {
    added_.add(added);
    return loop_->step() ? nullptr : &engine_->record();
  }

  std::vector<const MachineDefinition*> machines() const override { return engine_->machines(); }

  std::optional<std::string> first_difference() const override {
    const std::optional<Difference>& first = comparison_.first_action();
    if (!first) return std::nullopt;
    return fmt::format("at {:.2f} s (frame {}) {}: recorded {}, now {}", first->time, first->frame, first->what,
                       first->recorded, first->replayed);
  }

 private:
  Recording recording_;
  Replay replay_;
  ReplayComparison comparison_;
  FrameLoop* engine_;
  AddedInputs added_;
  std::optional<RunLoop> loop_;
};

}  // namespace

PlayRecording recordings_below(std::filesystem::path folder) {
  return [folder = std::move(folder)](const std::string& file, const ScriptTexts& scripts) {
    try {
      return std::unique_ptr<PlayedRecording>(new Played(folder / file, scripts));
    } catch (const BadBytes& error) {
      throw std::runtime_error((folder / file).string() + ": " + error.what());
    }
  };
}

}  // namespace reorient
