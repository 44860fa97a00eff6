// SPDX-License-Identifier: MIT
// One trial: a condition and a seed become a result, on the same run loop as any run.
#pragma once

#include <cstdint>
#include <filesystem>

#include "program/robots.h"
#include "program/run/run_options.h"
#include "program/run/simulation.h"
#include "workbench/experiments/condition/condition.h"
#include "workbench/experiments/peers/compass_methods.h"
#include "workbench/experiments/trial/trial_result.h"

namespace reorient {

/// The options of the same `reorient run`, without a model learned before. Throws std::runtime_error with one line.
SimulationOptions options_of(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts);

/// The same with the room as learned on another day, if the condition requests it; simulates that day.
/// Throws as run_trial() does.
SimulationOptions prepared_options_of(const Condition& condition, std::uint64_t seed,
                                      const std::filesystem::path& scripts, RoomCache& rooms);

/// The setup of the comparison, if a condition has compasses. Throws std::runtime_error with one line.
CompassParameters compass_parameters_of(const Condition& condition);

/// Call before many trials: throws std::runtime_error with one line about a mistake in the condition, with the line of
/// the experiment if possible. Returns what the trial loads, also on another day before it.
LoadedFiles check_trial(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts);

/// Returns the same result for the same condition and seed, independent of earlier trials. `rooms`: cache between
/// trials. Throws std::runtime_error (of scripts: ScriptError) with one line.
TrialResult run_trial(const Condition& condition, std::uint64_t seed, const std::filesystem::path& scripts,
                      RoomCache& rooms);

}  // namespace reorient
