// SPDX-License-Identifier: MIT
#include "program/room/learned_room.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "engine/parameters/parameter.h"
#include "engine/parameters/utf8.h"
#include "geometry/bytes.h"
#include "program/model/known_room.h"
#include "program/model/model_file.h"
#include "program/run/simulation.h"
#include "program/run/venue.h"
#include "workbench/recording/mcap/contents.h"
#include "workbench/recording/mcap/source.h"
#include "workbench/recording/recording.h"
#include "workbench/recording/replay.h"
#include "workbench/run/run_loop.h"

namespace reorient {
namespace {

constexpr std::string_view kBuiltInHall = "hall";
constexpr int kRatedWidth = 160;  // pixels of the camera image

bool is_panorama_name(const std::string& source) {
  std::string extension = std::filesystem::path(source).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return std::find(kPanoramaExtensions.begin(), kPanoramaExtensions.end(), extension) != kPanoramaExtensions.end();
}

/// Checks the first bytes, because a recording may have any name.
bool is_recording(const std::filesystem::path& file) {
  std::error_code error;
  return std::filesystem::is_regular_file(file, error) && mcap::is_mcap(mcap::FileSource(file));  // a pipe would wait
}

SavedModel learned_by_simulator(const std::string& source, const Learning& learning, SimulationOptions options,
                                const std::function<bool()>& stop) {
  options.room = source == kBuiltInHall ? "" : source;
  if (source == kBuiltInHall && !options.hall_seed) options.hall_seed = 1;
  options.scenario = "trial";
  options.width = kRatedWidth;
  options.seconds = learning.seconds;
  const auto set = [&](const char* name, const std::string& value) {
    options.parameters.changes.push_back({name, value, ParameterOrigin::file, "room rate"});
  };
  set("trial.event", "none");
  set("trial.learn", to_text(ParameterValue(learning.seconds)));
  // Training would stop if the room did not support the belief after the first decisions.
  for (const char* const name : {"background_training.min_time", "background_training.max_time"})
    set(name, to_text(ParameterValue(learning.seconds)));
  if (learning.stands_still) {  // as assets/conditions/head.toml
    options.without = {"penalty_marks"};
    set("kidnap_recovery.turn", "0");
  }
  Simulation simulation(options);
  KnownRoom room;
  RunParts parts = simulation.parts();
  parts.observers = {&room};
  parts.stop = stop;
  RunLoop(std::move(parts)).run();
  return room.model().value_or(SavedModel());
}

SavedModel known_in_recording(const std::string& source, const std::function<bool()>& stop) {
  Recording recording(source);
  if (!recording.contents().is_complete)
    throw std::runtime_error(
        "expected a whole recording, found one whose end is missing; 'reorient recording "
        "recover' repairs it");
  recording.require_this_format();
  Replay replay(recording, recording.end_time());
  KnownRoom room;
  while (replay.next_stretch() != nullptr) replay.run({}, {&room}, stop);
  if (!recording.damages().empty())
    throw std::runtime_error("expected a whole recording, found damage: " + recording.damages().front());
  std::optional<SavedModel> model = room.model();
  if (!model) throw std::runtime_error("expected a recorded model of the room, found none at the end");
  return *std::move(model);
}

SavedModel known_in_file(const std::string& source) {
  try {
    return read_model_file(source);
  } catch (const std::runtime_error& reason) {
    throw std::runtime_error(std::string(reason.what()) +
                             "; name a panorama (.hdr, .png, .jpg), a file that 'reorient run --model FILE' has "
                             "written, or a recording");
  }
}

}  // namespace

LearnedRoom learned_room(const std::string& source, const Learning& learning, SimulationOptions simulation,
                         const std::function<bool()>& stop) {
  const std::string name = as_line(source);
  if (source == kBuiltInHall || is_panorama_name(source)) {
    const std::string what = source == kBuiltInHall ? "the built-in hall" : "panorama " + name;
    const char* const how =
        learning.stands_still ? ", learned by the simulator from one place" : ", learned by the simulator";
    return {what + how, learned_by_simulator(source, learning, std::move(simulation), stop)};
  }
  try {
    if (is_recording(source)) return {"recording " + name + ", at its end", known_in_recording(source, stop)};
    return {"saved model " + name, known_in_file(source)};
  } catch (const std::runtime_error& error) {
    const std::string words = error.what();
    throw std::runtime_error(words.starts_with(source) ? words : name + ": " + words);
  }
}

}  // namespace reorient
