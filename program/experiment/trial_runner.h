// SPDX-License-Identifier: MIT
// One trial: a condition and a seed become a result, on the same run loop as any run.
#pragma once

#include <cstdint>
#include <filesystem>

#include "program/robots.h"
#include "program/run/run_options.h"
#include "program/run/venue.h"
#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/peers/compass_methods.h"
#include "workbench/experiments/trial/trial_result.h"

namespace reorient {

/// What `reorient run` would be asked for, but for what was learned before. Throws std::runtime_error with one line.
SimulationOptions options_of(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts);

/// The same with the room as the robot learned it on another day, where the condition says so; that day is played here.
/// Throws as run_trial() does.
SimulationOptions prepared_options_of(const Condition& condition, std::uint64_t seed,
                                      const std::filesystem::path& scripts, RoomCache& rooms);

/// Of what is compared where a condition has compasses. Throws std::runtime_error with one line.
CompassParameters compass_parameters_of(const Condition& condition);

/// Before many trials: throws std::runtime_error with one line, which names the experiment's where it can, of what is
/// wrong with the condition. Returns where they take place.
Venue check_trial(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts);

/// The same result for the same condition and seed, whatever ran before. `rooms`: what is kept between trials. Throws
/// std::runtime_error (of scripts: ScriptError) with one line.
TrialResult run_trial(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts,
                      RoomCache& rooms);

}  // namespace reorient
