// Arbitrary texts as a behaviour and as an edit of it: loaded, ticked, reloaded, ticked. Whatever the texts say, the
// engine keeps its promises; a broken one aborts. The input is the behaviour, a byte 0xFF, the edit; without that byte
// the edit is the behaviour with its first digit changed.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <map>
#include <random>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <sys/inotify.h>

#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_error.h"
#include "engine/script/script_folder.h"
#include "engine/script/script_host.h"
#include "workbench/script_tools/check/machine_warnings.h"
#include "workbench/script_tools/check/name_check.h"
#include "workbench/script_tools/graph/machine_graph.h"

/// A host is made for every input, and a kernel's watch for each would be most of the work: there is none here.
extern "C" int inotify_init1(int) { return -1; }

namespace reorient {
namespace {

constexpr const char* kFile = "behaviors/fuzzed.lua";
constexpr const char* kScenarioFile = "scenarios/fuzzed.lua";
constexpr const char* kHonest = R"(behavior "honest_one" { update = function() log.info("alive") end })";
constexpr int kFrames = 12;                 // between two edits
constexpr std::size_t kMostPerFrame = 100;  // script_actions.cpp
constexpr std::size_t kMemorySlack = 64 * 1024;
constexpr std::int64_t kInstructionSlack = 10'000;  // exits and what C functions did before they were charged
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

void require(bool promise, const char* what) {
  if (promise) return;
  std::fprintf(stderr, "broken promise: %s\n", what);
  std::abort();
}

double processor_seconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// An empty folder that all inputs share; the files are in memory.
const std::filesystem::path& empty_folder() {
  static const std::filesystem::path folder = [] {
    std::string pattern = (std::filesystem::temp_directory_path() / "reorient-fuzz-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) std::abort();
    std::atexit([] {
      std::error_code ignored;
      std::filesystem::remove(empty_folder(), ignored);
    });
    return std::filesystem::path(pattern);
  }();
  return folder;
}

/// Worlds that differ in all that behaviours ask about, the same ones for the same input.
class Worlds {
 public:
  explicit Worlds(std::uint64_t seed) : bits_(seed) {}

  const World& next() {
    constexpr std::array<double, 4> kSteps = {1.0 / 30.0, 1.0 / 30.0, 0.4, 12.0};  // s
    world_.time_step = kSteps[draw(4)];
    world_.time += world_.time_step;
    ++world_.frame;
    world_.fallen = draw(4) == 0;
    world_.carried = draw(4) == 0;
    world_.penalized = draw(8) == 0;
    world_.head = {fraction() - 0.5, 0.2 * fraction()};
    world_.pose.pose = Pose2(6.0 * fraction() - 3.0, 4.0 * fraction() - 2.0, 6.0 * fraction() - 3.0);
    world_.pose.reflected_weight = fraction();
    world_.pose_known = draw(2) == 0;
    world_.confidence.current = fraction();
    world_.confidence.opposite = fraction();
    world_.confidence.coverage = fraction();
    world_.confidence.distinctiveness = fraction();
    world_.trained_seconds = 60.0 * fraction();
    world_.truth.reset();
    if (draw(2) == 0) world_.truth = GroundTruth{world_.pose.pose, world_.fallen, world_.carried};
    return world_;
  }
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
  std::uint64_t bits_;
};

/// One engine with an honest behaviour beside the fuzzed one.
class Trial {
 public:
  explicit Trial(std::uint64_t seed, std::string_view library) : worlds_(seed | 1) {
    host_.replace_file("behaviors/honest_one.lua", kHonest);
    host_.replace_file("lib/walk.lua", std::string(library));
    host_.load_behavior("honest_one");
  }

  /// False: the text is no script.
  bool load(const std::string& text) {
    const bool is_scenario = text.find("scenario") != std::string::npos && text.find("behavior ") == std::string::npos;
    file_ = is_scenario ? kScenarioFile : kFile;
    host_.replace_file(file_, text);
    const double start = processor_seconds();
    bool loaded = true;
    try {
      if (is_scenario) {
        host_.load_scenario("fuzzed");
      } else {
        host_.load_behavior("fuzzed");
      }
    } catch (const ScriptError& error) {
      require(!error.fault.message.empty(), "a refusal says why");
      loaded = false;
    }
    require(processor_seconds() - start < kLongestLoad, "loading takes a bounded time");
    look_at_definitions();
    return loaded;
  }

  void edit(const std::string& text) {
    host_.replace_file(file_, text);
    const double start = processor_seconds();
    const std::vector<ReloadReport> reports = host_.reload_changed(worlds_.time());
    require(processor_seconds() - start < kLongestLoad, "reloading takes a bounded time");
    require(reports.size() <= 1, "one edit, one report");
    for (const ReloadReport& report : reports) {
      require(report.script == file_, "the report names the file");
      require(report.accepted || !report.fault.message.empty(), "a refusal says why");
    }
    look_at_definitions();
  }

  void run() {
    for (int frame = 0; frame < kFrames; ++frame) {
      const World& world = worlds_.next();
      const double start = processor_seconds();
      const ScriptOutput& output = host_.tick(world);
      require(processor_seconds() - start < kLongestTick, "a tick takes a bounded time");
      look_at(output);
      look_at_machines();
    }
  }

 private:
  void look_at(const ScriptOutput& output) const {
    require(!output.logs.empty() && output.logs.front().text == "alive", "the honest behaviour goes on");
    require(output.commands.size() <= kMostPerFrame, "commands are bounded");
    require(output.logs.size() <= kMostPerFrame, "log lines are bounded");
    require(output.actions.size() <= kMostPerFrame, "actions are bounded");
    std::map<std::string, int> transitions;
    for (const TransitionRecord& record : output.transitions) {
      require(++transitions[record.machine] == 1, "at most one transition for a machine in a frame");
      require(!record.reason.empty(), "a transition has a reason");
    }
    bool rolled_back = false;
    for (const FaultRecord& fault : output.faults) {
      require(fault.script == file_, "only the fuzzed script fails");
      require(!fault.fault.message.empty(), "a fault says what");
      rolled_back |= fault.consequence == FaultRecord::Consequence::rolled_back;
    }
    // What a version issued before it was rolled back is from its own states, which are gone.
    for (const CommandRequest& command : output.commands) {
      if (!rolled_back) require_state(command.issuer, command.state);
    }
    for (const Lease& lease : output.leases) require_state(lease.issuer, lease.state);
    const Request& request = output.request;
    require(std::isfinite(request.walk.forward) && std::isfinite(request.walk.left) && std::isfinite(request.walk.turn),
            "a walk request is finite");
    require(!request.head || (std::isfinite(request.head->angles.yaw) && std::isfinite(request.head->angles.pitch) &&
                              request.head->speed > 0.0),
            "a head request is finite");
  }

  void look_at_machines() const {
    const std::size_t most_memory = static_cast<std::size_t>(limits_.max_memory) * 1024 + kMemorySlack;
    for (const MachineStatus& machine : host_.machines()) {
      require_state(machine.name, machine.state);
      require(machine.memory <= most_memory, "memory stays below its cap");
      require(machine.instructions <= limits_.instructions_per_frame + kInstructionSlack,
              "instructions stay within the budget");
    }
  }

  void require_state(const std::string& machine, const std::string& path) const {
    for (const MachineDefinition* definition : host_.definitions()) {
      if (definition->name == machine && definition->find(path) >= 0) return;
    }
    require(false, "a state is one of the definition's");
  }

  void look_at_definitions() const {
    for (const MachineDefinition* definition : host_.definitions()) {
      require(!to_mermaid(*definition).empty() && !to_dot(*definition).empty(), "a machine can be drawn");
      (void)machine_warnings(*definition);
      for (const TransitionDefinition& transition : definition->transitions) {
        require(transition.to > 0 && transition.to < static_cast<int>(definition->states.size()),
                "a transition leads to a state");
      }
    }
  }

  ScriptLimits limits_ = low_limits();
  ParameterRegistry parameters_;
  ScriptHost host_{empty_folder(), parameters_, limits_};
  Worlds worlds_;
  std::string file_;
};

std::string with_another_number(std::string text) {
  const std::size_t digit = text.find_first_of("0123456789");
  if (digit == std::string::npos) return text + " ";
  text[digit] = text[digit] == '9' ? '0' : static_cast<char>(text[digit] + 1);
  return text;
}

const std::string& library() {
  static const std::string text =
      ScriptFolder(std::filesystem::path(REORIENT_SOURCE_DIR) / "scripts").read("lib/walk.lua").value();
  return text;
}

/// What `reorient check` does: it takes any text, and points into it.
void check_without_running(const std::string& text) {
  static const SymbolTable known = symbol_table(ScriptRole::behavior);
  const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
  TextPosition before;
  for (const DeclarationError& error : check_names(text, known)) {
    require(error.position.line >= 1 && error.position.line <= lines && error.position.column >= 1,
            "a mistake stands in the text");
    require(!is_before(error.position, before), "mistakes are told in their order");
    before = error.position;
  }
}

void try_script(std::string_view input) {
  const std::size_t separator = input.find('\xFF');
  const std::string first(input.substr(0, separator));
  const std::string second =
      separator == std::string_view::npos ? with_another_number(first) : std::string(input.substr(separator + 1));
  check_without_running(first);
  Trial trial(content_hash(input), library());
  if (!trial.load(first) && !trial.load(second)) return;
  trial.run();
  trial.edit(second);
  trial.run();
  trial.edit(first);
  trial.run();
}

}  // namespace
}  // namespace reorient

extern "C" std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t longest);

/// Half of the time whole lines are taken out, doubled or exchanged: what is still a script reaches further than what
/// the parser refuses.
extern "C" std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data, std::size_t size, std::size_t longest,
                                               unsigned int seed) {
  std::minstd_rand random(seed);
  if (random() % 2 == 0) return LLVMFuzzerMutate(data, size, longest);
  std::vector<std::string> lines;
  std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
  for (std::string line; std::getline(text, line);) lines.push_back(line + "\n");
  if (lines.size() < 2) return LLVMFuzzerMutate(data, size, longest);
  const std::size_t one = random() % lines.size();
  const std::size_t other = random() % lines.size();
  const auto place = [&lines](std::size_t index) { return lines.begin() + static_cast<std::ptrdiff_t>(index); };
  switch (random() % 3) {
    case 0:
      lines.erase(place(one));
      break;
    case 1:
      lines.insert(place(one), std::string(lines[other]));
      break;
    default:
      std::swap(lines[one], lines[other]);
  }
  std::string result;
  for (const std::string& line : lines) result += line;
  result.resize(std::min(result.size(), longest));
  std::copy(result.begin(), result.end(), data);
  return result.size();
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  reorient::try_script({reinterpret_cast<const char*>(data), size});
  return 0;
}
