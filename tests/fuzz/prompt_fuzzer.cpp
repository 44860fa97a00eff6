// SPDX-License-Identifier: MIT
// Arbitrary bytes at the prompt of a run: as a pipe sends them, command by command, and as the keys of a terminal. The
// answers are readable, and the robot continues.
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <unistd.h>

#include "engine/frame.h"
#include "engine/parameters/utf8.h"
#include "program/run/console/command_table.h"
#include "program/run/console/key_queue.h"
#include "program/run/console/live_console.h"
#include "tests/fuzz/promises.h"
#include "tests/temporary_folder.h"
#include "workbench/scenario/scenario_host.h"

namespace reorient {
namespace {

constexpr double kStep = 1.0 / 30.0;  // s
constexpr int kMostCommands = 20;     // one per frame; the run continues until no more output appears
constexpr int kMostFrames = 200;
constexpr std::size_t kLongestAnswer = 200'000;  // bytes

constexpr const char* kBehavior = R"(param {
  level = { 0.5, range = { 0, 1 }, unit = "m", doc = "how bright" },
  kind = { "lamp", choices = { "lamp", "fire" }, doc = "of light" },
  count = { 3, range = { 0, 9 }, integer = true, doc = "how many" },
  shown = { true, doc = "whether" },
}
behavior "tested" {
  initial = "off",
  state "off" {
    { "on", when = function() return robot.penalized end, lasting = "level", because = "it is dark" },
    { "on", after = 3 },
  },
  state "on" { { "off", after = 1 } },
})";
constexpr const char* kScenario = R"(param { pace = { 1, range = { 0, 2 }, doc = "how fast" } }
scenario "scene" { behaviors = {}, initial = "waiting", state "waiting" { { "over", after = 3600 } }, state "over" {} })";

bool is_control(char letter) {
  const auto code = static_cast<unsigned char>(letter);
  return code < ' ' || code == 0x7F;
}

void require_readable(std::string_view text) {
  require(text.size() <= kLongestAnswer, "an answer can be read");
  require(is_utf8(text), "an answer is UTF-8");
  require(std::none_of(text.begin(), text.end(), [](char c) { return c != '\n' && is_control(c); }),
          "an answer has no control characters");
}

/// A small field, because the map of a whole one would take most of the time.
FieldDimensions small_field() {
  FieldDimensions field;
  field.length = 3.0;
  field.width = 2.0;
  field.border = 0.2;
  field.penalty_area_depth = 0.4;
  field.penalty_area_width = 1.2;
  field.goal_area_depth = 0.0;
  field.penalty_mark_x = 0.9;
  field.center_circle_radius = 0.3;
  field.goal_post_y = 0.4;
  return field;
}

/// A robot without cameras, its scenario, and the prompt of its run.
class Trial {
 public:
  Trial() {
    const ScriptTexts texts = written();
    scenario_.emplace(texts, "scene", std::vector<ParameterChange>{}, no_behaviors_);
    FrameSetup setup;
    setup.field = small_field();
    setup.scripts = texts;
    setup.behaviors.emplace_back("tested");
    engine_.emplace(std::move(setup));
    require(pipe(ends_) == 0, "a pipe can be created");
    console_.emplace(ends_[0], out_, subject());
  }
  Trial(const Trial&) = delete;
  Trial& operator=(const Trial&) = delete;
  ~Trial() {
    close(ends_[0]);
    close_writing();
  }

  /// Writes what fits in a pipe; no other process writes there.
  void type(std::string_view text) const {
    constexpr std::size_t kPipe = 65'536;  // bytes, pipe(7)
    const std::string_view fitting = text.substr(0, kPipe);
    require(write(ends_[1], fitting.data(), fitting.size()) == std::ssize(fitting), "the pipe accepts all bytes");
  }
  void close_writing() {
    if (ends_[1] >= 0) close(ends_[1]);
    ends_[1] = -1;
  }

  void run() {
    for (int frame = 0; frame < kMostFrames && !console_->wants_to_quit(); ++frame) {
      if (!step() && frame > kMostCommands) return;
    }
  }

  /// Requests the completions of a terminal after each prefix of the line.
  void complete(const std::string& line) {
    const CommandTable table(subject());
    std::istringstream in(line);
    Words before;
    for (std::string word; before.size() < 4 && in >> word; before.push_back(word)) {
      for (const std::string& name : table.candidates(before)) require_readable(name);
    }
  }

  const std::filesystem::path& folder() const { return folder_.path(); }

 private:
  ScriptTexts written() const {
    ScriptTexts texts;
    texts.apply({"behaviors/tested.lua", ScriptText{kBehavior, ""}});
    texts.apply({"scenarios/scene.lua", ScriptText{kScenario, ""}});
    for (const std::string& file : texts.files()) folder_.write("scripts/" + file, texts.find(file)->text);
    return texts;
  }

  std::vector<Parameter> parameters() const {
    std::vector<Parameter> all = engine_->parameters();
    for (const Parameter& parameter : scenario_->parameters().list()) all.push_back(parameter);
    return all;
  }

  ConsoleSubject subject() {
    return {.scenario = &*scenario_,
            .parameters = [this] { return parameters(); },
            .scripts = [this] { return &engine_->scripts(); }};
  }

  /// Returns whether the prompt printed anything.
  bool step() {
    out_.str("");
    console_->add_to(inputs_);
    require(inputs_.parameter_changes.size() <= 1, "at most one command per frame");
    if (!inputs_.script_edits.empty()) scenario_->apply(inputs_.script_edits);
    engine_->step(inputs_, console_->wanted());
    inputs_.parameter_changes.clear();
    inputs_.script_edits.clear();
    inputs_.observation.time += kStep;
    inputs_.observation.body.time = inputs_.observation.time;
    scene_.scenario = scenario_->tick({engine_->record().world, engine_->record().application, std::nullopt});
    console_->observe(engine_->record(), scene_);
    require(engine_->record().faults.empty() && scene_.scenario.faults.empty(),
            "no typed text causes a fault of a behavior");
    require(engine_->record().machines.size() == 1, "the behavior still runs");
    require_readable(out_.str());
    return !out_.str().empty();
  }

  TemporaryFolder folder_;
  RecordedBehaviors no_behaviors_;
  std::optional<ScenarioHost> scenario_;
  std::optional<FrameLoop> engine_;
  FrameInputs inputs_;
  SceneTruth scene_;
  std::ostringstream out_;
  std::optional<LiveConsole> console_;
  int ends_[2] = {-1, -1};
};

/// Redirects the files of `save` to the folder of the trial.
std::string kept_within(const std::filesystem::path& folder, std::string_view text) {
  std::istringstream in{std::string(text)};
  std::string kept;
  for (std::string line; std::getline(in, line); kept.append(line).append("\n")) {
    std::istringstream words(line);
    std::string command, file;
    if (!(words >> command >> file) || command != "save") continue;
    std::replace(file.begin(), file.end(), '/', '_');
    std::string rest;
    std::getline(words, rest, '\0');
    line.assign("save ").append((folder / ("saved_" + file)).string()).append(rest);
  }
  return kept;
}

void type_keys(std::string_view bytes) {
  const auto keys_of = [bytes](std::size_t at_once) {
    KeyQueue queue({"\x1B[A", "\x1B[1;5C", "\033f", "\x1BOH"});
    Words keys;
    for (std::size_t begin = 0; begin < bytes.size(); begin += at_once) {
      queue.add(bytes.substr(begin, at_once));
      while (std::optional<std::string> key = queue.next()) keys.push_back(std::move(*key));
    }
    queue.drop_begun();
    require(queue.empty(), "an incomplete key can be dropped");
    return keys;
  };
  const Words keys = keys_of(bytes.size());
  require(keys == keys_of(1), "keys do not depend on how their bytes are split");
  for (const std::string& key : keys) require(!key.empty() && is_utf8(key), "a key is a letter or a sequence");
}

void try_prompt(std::string_view text) {
  if (!text.empty()) type_keys(text);
  const Haste haste(4.0);
  Trial trial;
  trial.complete(std::string(text.substr(0, text.find('\n'))));
  trial.type(kept_within(trial.folder(), text));
  trial.close_writing();
  trial.run();
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_prompt({reinterpret_cast<const char*>(data), size});
  return 0;
}
