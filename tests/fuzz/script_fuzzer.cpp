// SPDX-License-Identifier: MIT
// Arbitrary texts as a behavior and as an edit of it: loaded, run, reloaded, run. The engine must keep its promises for
// any text; a broken promise aborts. The input is the behavior, a byte 0xFF, the edit; without that byte the edit is
// the behavior with its first digit changed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/behaviors.h"
#include "engine/script/language/script_actions.h"
#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_error.h"
#include "tests/fuzz/promises.h"
#include "tests/paths.h"
#include "workbench/scenario/scenario_host.h"
#include "workbench/scenario/scenario_language.h"
#include "workbench/script_tools/check/machine_warnings.h"
#include "workbench/script_tools/check/text_check.h"
#include "workbench/script_tools/graph/machine_graph.h"

namespace reorient {
namespace {

constexpr const char* kHonest = R"(KIND "honest_one" { update = function() log.info("alive") end })";
/// What a fuzzed behavior can run: a behavior with an argument of each type that ends in both ways, and runs another.
constexpr const char* kCalled = R"(local a = args {
  x = { 0.5, range = { -1, 1 }, unit = "m", doc = "x" },
  n = { 2, range = { 1, 3 }, integer = true, doc = "n" },
  on = { false, doc = "on" },
  mode = { "slow", choices = { "slow", "fast" }, doc = "mode" },
}
behavior "called" {
  initial = "looking",
  state "looking" {
    update = function() head.look(a.x, 0.1) end,
    run "inner" { x = function() return a.x end },
    { "good", when = function() return a.on and called.inner.outcome == "done" end, because = "the inner one has ended" },
    { "bad", after = function() return a.mode == "fast" and 0 or a.n end, because = "it took too long" },
  },
  state "good" { ends = "done" },
  state "bad" { ends = "failed" },
})";
constexpr const char* kInner = R"(local a = args { x = { 0.0, range = { -1, 1 }, unit = "m", doc = "x" } }
behavior "inner" {
  initial = "walking",
  state "walking" {
    enter = function() command.pause_training() end,
    update = function() walk.velocity(a.x, 0, 0) end,
    { "there", after = 0.03, because = "it is there" },
  },
  state "there" { ends = "done" },
})";
constexpr int kFrames = 12;  // between two edits
constexpr std::size_t kMemorySlack = 64 * 1024;
constexpr std::int64_t kInstructionSlack = 10'000;  // exits, and work of C functions before they are charged
constexpr double kLongestTick = 0.25;               // s of processor time, with sanitizers
constexpr double kLongestLoad = 1.0;

ScriptLimits low_limits() {
  ScriptLimits limits;
  limits.instructions_per_frame = 5'000;
  limits.instructions_per_load = 20'000;
  limits.max_memory = 256;
  limits.string_length = 1024;
  limits.trial_time = 0.1;
  return limits;
}

/// Random worlds that differ in all fields that behaviors read; the same ones for the same input.
class Worlds {
 public:
  explicit Worlds(std::uint64_t seed) : bits_(seed) {}

  const World& next() {
    constexpr std::array<double, 4> kSteps = {1.0 / 30.0, 1.0 / 30.0, 0.4, 12.0};  // s
    world_.time_step = kSteps[draw(4)];
    world_.time += world_.time_step;
    ++world_.frame;
    world_.posture = static_cast<Posture>(draw(kPostures));
    world_.room_status = static_cast<RoomStatus>(draw(kRoomStatuses));
    world_.referee.penalized = draw(8) == 0;
    world_.head = {fraction() - 0.5, 0.2 * fraction()};
    world_.pose.pose = Pose2(6.0 * fraction() - 3.0, 4.0 * fraction() - 2.0, 6.0 * fraction() - 3.0);
    world_.pose.reflected_weight = fraction();
    world_.pose_known = draw(2) == 0;
    world_.confidence.current = fraction();
    world_.confidence.opposite = fraction();
    world_.confidence.coverage = fraction();
    world_.confidence.distinctiveness = fraction();
    world_.trained_seconds = 60.0 * fraction();
    truth_.reset();
    if (draw(2) == 0)
      truth_ = GroundTruth{world_.pose.pose, is_down(world_.posture), world_.posture == Posture::lifted};
    return world_;
  }
  const std::optional<GroundTruth>& truth() const { return truth_; }
  double time() const { return world_.time; }

 private:
  std::uint64_t draw(std::uint64_t count) {
    bits_ ^= bits_ << 13;
    bits_ ^= bits_ >> 7;
    bits_ ^= bits_ << 17;
    return (bits_ >> 32) % count;
  }
  double fraction() { return static_cast<double>(draw(1'001)) / 1'000.0; }

  World world_;
  std::optional<GroundTruth> truth_;
  std::uint64_t bits_;
};

/// The scripts of one type: a valid one and the fuzzed one.
class Trial {
 public:
  Trial(std::uint64_t seed, ScriptLanguage& language, const std::string& folder, ScriptTexts texts)
      : file_(folder + "/fuzzed.lua"), host_(std::move(texts), language, parameters_, limits_), worlds_(seed | 1) {
    host_.load("honest_one");
  }
  virtual ~Trial() = default;

  /// Returns false if the text is not a script.
  bool load(const std::string& text) {
    const std::vector<ScriptEdit> edits{{file_, ScriptText{text, ""}}};
    host_.apply(edits);
    const double start = processor_seconds();
    bool loaded = true;
    try {
      host_.load("fuzzed");
    } catch (const ScriptError& error) {
      require(!error.fault.message.empty(), "a refusal has a reason");
      loaded = false;
    }
    require(processor_seconds() - start < kLongestLoad, "loading takes a bounded time");
    look_at_definitions();
    return loaded;
  }

  void edit(const std::string& text) {
    const std::vector<ScriptEdit> edits{{file_, ScriptText{text, ""}}};
    const double start = processor_seconds();
    const std::vector<ReloadRecord> records = host_.apply(edits);
    require(processor_seconds() - start < kLongestLoad, "reloading takes a bounded time");
    require(records.size() <= 1, "one edit, one report");
    for (const ReloadRecord& record : records) {
      require(record.script == file_, "the report names the file");
      require(record.accepted || !record.fault.message.empty(), "a refusal has a reason");
    }
    look_at_definitions();
  }

  void run() {
    for (int frame = 0; frame < kFrames; ++frame) {
      const World& world = worlds_.next();
      values_.clear();
      append_values(world, worlds_.truth(), values_);
      const double start = processor_seconds();
      const ScriptOutput& output = host_.tick(world.time, values_);
      require(processor_seconds() - start < kLongestTick, "a tick takes a bounded time");
      look_at(output);
      look_at_actions();
      look_at_machines();
    }
  }

 protected:
  virtual void append_values(const World& world, const std::optional<GroundTruth>& truth,
                             std::vector<double>& values) const = 0;
  virtual void look_at_actions() const = 0;

  void require_state(NameId machine, NameId path) const {
    for (const MachineDefinition* definition : host_.definitions()) {
      if (definition->name == host_.names()[machine] && definition->find(host_.names()[path]) >= 0) return;
    }
    require(false, "a state belongs to the definition");
  }

  const ScriptHost& host() const { return host_; }
  bool rolled_back() const { return rolled_back_; }

 private:
  void look_at(const ScriptOutput& output) {
    require(!output.logs.empty() && output.logs.front().text == "alive", "the valid script continues");
    std::map<NameId, std::size_t> logged;
    for (const LogRecord& record : output.logs)
      require(++logged[record.machine] <= ScriptActions::kMostPerFrame, "log lines are bounded");
    std::map<NameId, int> transitions, stops;
    for (const TransitionRecord& record : output.transitions) {
      // A called behavior stops and starts again in the frame in which its caller enters the state again.
      const bool is_stop = host_.names()[record.reason] == "its caller has left the state";
      require(++(is_stop ? stops : transitions)[record.machine] == 1,
              "at most one transition for a machine in a frame");
      require(record.reason != kNoName, "a transition has a reason");
    }
    rolled_back_ = false;
    for (const FaultRecord& fault : output.faults) {
      require(fault.script == file_, "only the fuzzed script fails");
      require(!fault.fault.message.empty(), "a fault has a message");
      rolled_back_ |= fault.consequence == FaultRecord::Consequence::rolled_back;
    }
  }

  void look_at_machines() {
    const std::size_t most_memory = static_cast<std::size_t>(limits_.max_memory) * 1024 + kMemorySlack;
    host_.read_status(statuses_);
    host_.read_costs(costs_);
    require(statuses_.size() == costs_.size(), "every machine has its costs");
    for (const MachineStatus& machine : statuses_) require_state(machine.machine, machine.state);
    for (const MachineCost& machine : costs_) {
      require(machine.memory <= most_memory, "memory stays below its cap");
      require(machine.instructions <= limits_.instructions_per_frame + kInstructionSlack,
              "instructions stay within the budget");
    }
  }

  void look_at_definitions() const {
    for (const MachineDefinition* definition : host_.definitions()) {
      require(!to_mermaid({definition, 1}).empty() && !to_dot({definition, 1}).empty(), "a machine can be drawn");
      (void)machine_warnings(*definition);
      for (const TransitionDefinition& transition : definition->transitions) {
        require(transition.to > 0 && transition.to < static_cast<int>(definition->states.size()),
                "a transition leads to a state");
      }
    }
  }

  ScriptLimits limits_ = low_limits();
  ParameterRegistry parameters_;
  std::string file_;
  ScriptHost host_;
  Worlds worlds_;
  std::vector<double> values_;
  std::vector<MachineStatus> statuses_;
  std::vector<MachineCost> costs_;
  bool rolled_back_ = false;
};

struct BehaviorLanguageFirst {
  BehaviorLanguage language_of_behaviors;
};

class BehaviorTrial : private BehaviorLanguageFirst, public Trial {
 public:
  BehaviorTrial(std::uint64_t seed, ScriptTexts texts)
      : Trial(seed, language_of_behaviors, "behaviors", std::move(texts)) {}

 private:
  void append_values(const World& world, const std::optional<GroundTruth>&,
                     std::vector<double>& values) const override {
    append_world(world, values);
  }

  void look_at_actions() const override {
    const BehaviorOutput& wanted = language_of_behaviors.output();
    std::map<NameId, std::size_t> commanded;
    for (const ReorientationRequest& request : wanted.commands)
      require(++commanded[request.issuer.machine] <= ScriptActions::kMostPerFrame, "commands are bounded");
    // Commands that a version issued before it was rolled back are from its own states, which no longer exist.
    for (const ReorientationRequest& request : wanted.commands) {
      if (!rolled_back()) require_state(request.issuer.machine, request.issuer.state);
    }
    std::vector<Lease> leases;
    host().append_leases(leases);
    for (const Lease& lease : leases) require_state(lease.issuer.machine, lease.issuer.state);
    const Request& request = wanted.request;
    require(std::isfinite(request.walk.forward) && std::isfinite(request.walk.left) && std::isfinite(request.walk.turn),
            "a walk request is finite");
    require(!request.head || (std::isfinite(request.head->angles.yaw) && std::isfinite(request.head->angles.pitch) &&
                              request.head->speed > 0.0),
            "a head request is finite");
  }
};

struct ScenarioLanguageFirst {
  ScenarioLanguage language_of_scenarios;
};

class ScenarioTrial : private ScenarioLanguageFirst, public Trial {
 public:
  ScenarioTrial(std::uint64_t seed, ScriptTexts texts)
      : Trial(seed, language_of_scenarios, "scenarios", std::move(texts)) {}

 private:
  void append_values(const World& world, const std::optional<GroundTruth>& truth,
                     std::vector<double>& values) const override {
    append_scenario_world(world, truth, std::nullopt, values);
  }

  void look_at_actions() const override {
    const ScenarioActions& actions = language_of_scenarios.actions();
    require(actions.actions().size() <= ScriptActions::kMostPerFrame * host().definitions().size(),
            "actions are bounded");
    for (const OperatorAction& action : actions.actions()) {
      require(action.pose.position.allFinite() && std::isfinite(action.pose.rotation) && std::isfinite(action.stops),
              "an action is finite");
    }
  }
};

std::string with_another_number(std::string text) {
  const std::size_t digit = text.find_first_of("0123456789");
  if (digit == std::string::npos) return text + " ";
  text[digit] = text[digit] == '9' ? '0' : static_cast<char>(text[digit] + 1);
  return text;
}

const std::string& library() {
  static const std::string text = [] {
    std::ifstream in(std::filesystem::path(kSourceFolder) / "scripts" / "lib" / "walk.lua");
    std::ostringstream all;
    all << in.rdbuf();
    if (!in) std::abort();
    return std::move(all).str();
  }();
  return text;
}

ScriptTexts texts_with_honest_one(const std::string& folder, const std::string& kind) {
  std::string honest = kHonest;
  honest.replace(honest.find("KIND"), 4, kind);
  ScriptTexts texts;
  texts.apply({folder + "/honest_one.lua", ScriptText{honest, ""}});
  texts.apply({"lib/walk.lua", ScriptText{library(), ""}});
  texts.apply({"behaviors/called.lua", ScriptText{kCalled, ""}});
  texts.apply({"behaviors/inner.lua", ScriptText{kInner, ""}});
  return texts;
}

/// Like `reorient check`: it accepts any text, and its findings are positions in it.
void check_without_running(const std::string& text) {
  static const SymbolTable known = symbol_table(ScriptRole::behavior, DeclaredNames{});
  const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
  TextPosition before;
  for (const Finding& finding : check_text(text, known).findings) {
    require(finding.position.line >= 1 && finding.position.line <= lines && finding.position.column >= 1,
            "the position of a finding is in the text");
    require(!is_before(finding.position, before), "findings are in the order of their positions");
    before = finding.position;
  }
}

void try_script(std::string_view input) {
  const std::size_t separator = input.find('\xFF');
  const std::string first(input.substr(0, separator));
  const std::string second =
      separator == std::string_view::npos ? with_another_number(first) : std::string(input.substr(separator + 1));
  check_without_running(first);
  const bool is_scenario = first.find("scenario") != std::string::npos && first.find("behavior ") == std::string::npos;
  const std::uint64_t seed = content_hash(input);
  std::unique_ptr<Trial> trial;
  if (is_scenario) {
    trial = std::make_unique<ScenarioTrial>(seed, texts_with_honest_one("scenarios", "scenario"));
  } else {
    trial = std::make_unique<BehaviorTrial>(seed, texts_with_honest_one("behaviors", "behavior"));
  }
  if (!trial->load(first) && !trial->load(second)) return;
  trial->run();
  trial->edit(second);
  trial->run();
  trial->edit(first);
  trial->run();
}

}  // namespace
}  // namespace reorient

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_script({reinterpret_cast<const char*>(data), size});
  return 0;
}
