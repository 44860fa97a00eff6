// SPDX-License-Identifier: MIT
// Trials on footage: at many moments the pose is set right or wrong, and what follows is watched. Each trial
// continues from a robot that processed everything before with the recorded poses.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "program/footage/footage_run.h"
#include "robots/footage/footage_robot.h"
#include "workbench/experiments/trial/trial_observer.h"

namespace reorient {

/// A whole footage in memory, decoded once.
class FootageInMemory {
 public:
  /// Throws BadFootage, also if it is too large.
  explicit FootageInMemory(FootageSource& source);

  std::size_t size() const { return frames_->size(); }
  const std::vector<FootageFrame>& frames() const { return *frames_; }
  std::unique_ptr<FootageSource> source() const;

 private:
  std::shared_ptr<const std::vector<FootageFrame>> frames_;
};

struct FootageTrialOptions {
  int starts = 100;        ///< evenly over the footage
  double learn = 0.0;      ///< s of the robot's time before the first start
  double watch = 10.0;     ///< s after a start
  double hold = 2.0;       ///< s for which a belief must stay correct
  double turned_by = 0.0;  ///< rad by which the rotation is wrong in the trials "off"
};

/// How a trial begins.
struct FootageCase {
  const char* start;  ///< "told", "told, off", "lifted"
  const char* pose;   ///< "right", "mirrored"
  BeliefChange change;
};

/// One footage, ready for its trials.
class FootageTrials {
 public:
  /// Processes the footage once, with the recorded poses. Throws std::runtime_error with one line.
  FootageTrials(const FootageSetup& setup, const FootageTrialOptions& options, const ScriptTexts& scripts)
      : FootageTrials(setup, options, prepare_footage(setup, scripts)) {}

  struct Start {
    std::size_t frame = 0;         ///< of the footage
    std::string image;             ///< its file or another name
    double time = 0.0;             ///< s, robot time
    std::vector<std::byte> state;  ///< of the engine, before that frame
  };
  const std::vector<Start>& starts() const { return starts_; }
  /// s, first time at which the evidence was usable; nothing: not before the last start.
  std::optional<double> room_learned_at() const { return room_learned_at_; }
  /// Its wall, as text for the user.
  const std::string& wall() const { return wall_; }
  /// Digest of everything that determines the results, except for the case.
  std::uint64_t origin() const { return origin_; }

  TrialResult run(std::size_t start, const FootageCase& one) const;
  /// Images from the start up to `seconds` after it.
  int images_within(std::size_t start, double seconds) const;

 private:
  FootageTrials(const FootageSetup& setup, const FootageTrialOptions& options, PreparedFootage prepared);
  std::vector<double> times() const;
  void choose_starts();
  void live_through(FrameSetup frame);

  FootageSetup setup_;
  FootageTrialOptions options_;
  FootageInMemory footage_;
  RobotBody body_;
  std::string wall_;
  std::vector<Start> starts_;
  std::optional<double> room_learned_at_;
  std::uint64_t origin_ = 0;
};

}  // namespace reorient
