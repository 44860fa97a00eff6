// SPDX-License-Identifier: MIT
#include "program/recording/test_replay.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

#include <spdlog/fmt/fmt.h>

#include "geometry/bytes.h"
#include "workbench/files/script_files.h"
#include "workbench/recording/comparison.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/replay.h"

namespace reorient {
namespace {

class Played : public PlayedRecording {
 public:
  Played(const std::filesystem::path& file, const ScriptTexts& scripts, const std::function<bool()>& stop)
      : recording_(file, stop), replay_(recording_), comparison_(replay_.playback()), engine_(replay_.next_stretch()) {
    if (engine_ == nullptr) {
      throw std::runtime_error(file.string() + ": expected frames that can be replayed, found none" +
                               (recording_.damages().empty() ? "" : " (" + recording_.damages().front() + ")") +
                               "; see 'reorient recording info'");
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

/// The path of a recording that a test names. Throws std::runtime_error, for a file outside of the root without looking
/// whether it exists.
std::filesystem::path file_below(const std::filesystem::path& root, const std::string& named) {
  if (!is_below(root, root / "tests" / named))
    throw std::runtime_error("replay: expected a file below the root of the scripts, found '" + named + "'");
  return root / "tests" / named;
}

}  // namespace

PlayRecording recordings_below(const std::filesystem::path& scripts_root) {
  return [scripts_root](const std::string& named, const ScriptTexts& scripts, const std::function<bool()>& stop) {
    const std::filesystem::path file = file_below(scripts_root, named);
    try {
      return std::unique_ptr<PlayedRecording>(new Played(file, scripts, stop));
    } catch (const BadBytes& error) {
      throw std::runtime_error(file.string() + ": " + error.what());
    }
  };
}

}  // namespace reorient
