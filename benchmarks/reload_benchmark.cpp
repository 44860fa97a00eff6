// SPDX-License-Identifier: MIT
// Measures the time from saving a script to its first frame, and the memory of many edits.
// `reload_benchmark [SAVES [RELOADS]]`: saves with each method while frames run at 30 Hz in wall-clock time (default
// 250: about two minutes), then reloads in memory (default 10000). Prints Markdown tables.
#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <unistd.h>

#include "engine/parameters/parameter_registry.h"
#include "engine/script/behaviors.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

using Clock = std::chrono::steady_clock;
using Seconds = std::chrono::duration<double>;

constexpr double kFrame = 1.0 / 30.0;  // s
constexpr const char* kFile = "behaviors/orientation.lua";
constexpr std::array kBehaviors = {"orientation", "background_training", "head_scan", "get_up", "penalty_marks"};

/// A copy of the shipped scripts, removed at the end.
class CopiedScripts {
 public:
  CopiedScripts() {
    std::string pattern = (std::filesystem::temp_directory_path() / "reorient-reload-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot create a temporary folder");
    root_ = pattern;
    std::filesystem::copy(std::filesystem::path(REORIENT_SOURCE_DIR) / "scripts", root_,
                          std::filesystem::copy_options::recursive);
  }
  ~CopiedScripts() {
    std::error_code ignored;
    std::filesystem::remove_all(root_, ignored);
  }
  CopiedScripts(const CopiedScripts&) = delete;
  CopiedScripts& operator=(const CopiedScripts&) = delete;

  const std::filesystem::path& root() const { return root_; }

 private:
  std::filesystem::path root_;
};

/// The script with a machine that logs the number of the edit in each frame.
std::string edited(const std::string& text, int edit) {
  return text + "\nbehavior \"probe\" { update = function() log.info(\"edit " + std::to_string(edit) + "\") end }\n";
}

enum class Save { in_place, by_rename };

void save(const std::filesystem::path& file, const std::string& text, Save kind) {
  std::filesystem::path written = file;
  if (kind == Save::by_rename) written += ".new";
  std::ofstream(written, std::ios::trunc) << text;
  if (kind == Save::by_rename) std::filesystem::rename(written, file);
}

/// Frames as in `reorient run --realtime`: check for edits, tick, wait for the time of the next frame.
class Engine {
 public:
  explicit Engine(const std::filesystem::path& root) : files_(root), behaviors_(files_.texts(), parameters_) {
    for (const char* name : kBehaviors) behaviors_.host().load(name);
  }

  void run(const std::stop_token& stop) {
    const Clock::time_point start = Clock::now();
    World world;
    world.pose_known = true;
    while (!stop.stop_requested()) {
      const std::vector<ScriptEdit> edits = files_.poll(Seconds(Clock::now() - start).count());
      if (!edits.empty()) behaviors_.host().apply(edits);
      world.time += kFrame;
      ++world.frame;
      behaviors_.tick(world);
      for (const LogRecord& record : behaviors_.said().logs) {
        if (behaviors_.host().names()[record.machine] == "probe") note(std::atoi(record.text.c_str() + 5));
      }
      std::this_thread::sleep_until(start + std::chrono::duration_cast<Clock::duration>(Seconds(world.time)));
    }
  }

  /// Time at which the first frame with this edit or a later one ended. Throws after ten seconds.
  Clock::time_point wait_for(int edit) const {
    const Clock::time_point patience = Clock::now() + std::chrono::seconds(10);
    while (running_edit_.load(std::memory_order_acquire) < edit) {
      if (Clock::now() > patience) throw std::runtime_error("an edit did not run within 10 s");
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    return since_;
  }

 private:
  void note(int edit) {
    if (edit == running_edit_.load(std::memory_order_relaxed)) return;
    since_ = Clock::now();
    running_edit_.store(edit, std::memory_order_release);
  }

  ParameterRegistry parameters_;
  ScriptFiles files_;
  Behaviors behaviors_;
  std::atomic<int> running_edit_ = -1;
  Clock::time_point since_;  // written before running_edit_
};

double quantile(const std::vector<double>& sorted, double share) {
  return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
}

void print_row(const char* kind, std::vector<double> seconds) {
  std::sort(seconds.begin(), seconds.end());
  const double bar = FileWatcher::kPatience + kFrame;
  const auto late = std::count_if(seconds.begin(), seconds.end(), [bar](double one) { return one > bar; });
  std::printf("| %s | %zu | %.1f ms | %.1f ms | %.1f ms | %.1f ms | %td |\n", kind, seconds.size(),
              1e3 * quantile(seconds, 0.5), 1e3 * quantile(seconds, 0.99), 1e3 * seconds.back(), 1e3 * bar, late);
}

void measure_saves(int saves) {
  const CopiedScripts scripts;
  const std::filesystem::path file = scripts.root() / kFile;
  Engine engine(scripts.root());
  std::string text;
  {
    std::ifstream in(file);
    text.assign(std::istreambuf_iterator<char>(in), {});
  }
  std::jthread frames([&engine](const std::stop_token& stop) { engine.run(stop); });
  std::mt19937 random(20130624);
  std::uniform_real_distribution<double> pause(0.06, 0.06 + 4 * kFrame);
  std::printf("| how it is saved | saves | median | 99th percentile | longest | bar | over it |\n");
  std::printf("|---|---|---|---|---|---|---|\n");
  int edit = 0;
  for (const auto& [kind, name] : {std::pair(Save::in_place, "in place"), std::pair(Save::by_rename, "by rename")}) {
    std::vector<double> seconds;
    for (int i = 0; i < saves; ++i) {
      std::this_thread::sleep_for(Seconds(pause(random)));
      save(file, edited(text, ++edit), kind);
      const Clock::time_point saved = Clock::now();
      seconds.push_back(Seconds(engine.wait_for(edit) - saved).count());
    }
    print_row(name, std::move(seconds));
    std::fflush(stdout);
  }
}

/// Resident memory of this process, KiB.
long resident() {
  std::ifstream statm("/proc/self/statm");
  long all = 0, pages = 0;
  statm >> all >> pages;
  return pages * (sysconf(_SC_PAGESIZE) / 1024);
}

void measure_memory(int reloads) {
  ParameterRegistry parameters;
  Behaviors behaviors(read_scripts(std::filesystem::path(REORIENT_SOURCE_DIR) / "scripts"), parameters);
  for (const char* name : kBehaviors) behaviors.host().load(name);
  const std::string text = behaviors.host().texts().find(kFile)->text;
  World world = world_of(FieldDimensions(), RobotBody());
  std::vector<ScriptEdit> edits(1);
  std::vector<MachineCost> costs;
  std::printf("\n| reloads | resident memory | the script's Lua memory |\n|---|---|---|\n");
  for (int edit = 1; edit <= reloads; ++edit) {
    edits[0] = {kFile, ScriptText{edited(text, edit), ""}};
    const std::vector<ReloadRecord> records = behaviors.host().apply(edits);
    if (records.size() != 1 || !records[0].accepted) throw std::runtime_error("an edit was rejected");
    world.time += kFrame;
    ++world.frame;
    behaviors.tick(world);
    if (edit % std::max(1, reloads / 10) != 0) continue;
    behaviors.host().read_costs(costs);
    std::printf("| %d | %ld KiB | %llu KiB |\n", edit, resident(),
                static_cast<unsigned long long>(costs.front().memory / 1024));
  }
}

}  // namespace
}  // namespace reorient

int main(int argc, char** argv) {
  try {
    reorient::measure_saves(argc > 1 ? std::max(1, std::atoi(argv[1])) : 250);
    reorient::measure_memory(argc > 2 ? std::max(1, std::atoi(argv[2])) : 10'000);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "reload_benchmark: %s\n", error.what());
    return 2;
  }
  return 0;
}
