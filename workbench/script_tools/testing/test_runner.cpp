// SPDX-License-Identifier: MIT
#include "workbench/script_tools/testing/test_runner.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <ostream>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "engine/parameters/utf8.h"
#include "engine/script/sandbox/sandbox.h"
#include "workbench/files/input_file.h"
#include "workbench/files/script_files.h"
#include "workbench/script_tools/testing/behavior_words.h"

namespace reorient {
namespace {

/// Tests get larger limits than behaviors, but an endless loop must not block the run.
ScriptLimits test_limits() {
  ScriptLimits limits;
  limits.max_memory = 64 * 1024;
  limits.string_length = 1024 * 1024;
  return limits;
}

constexpr std::size_t kMostTests = 2000;  // in a file, which runs again for each test
constexpr std::size_t kLongestName = 200;

/// A file of tests, run from its top in its own sandbox. Each test gets a new one, so that no test sees the changes of
/// another test to globals, to library tables or to the locals of the file.
class TestFile {
 public:
  TestFile(const std::string& name, const std::string& text, std::int64_t instructions)
      : name_(name), sandbox_(test_limits()) {
    lua_State* const L = sandbox_.state();
    lua_pushlightuserdata(L, this);
    lua_pushcclosure(L, &TestFile::declare, 1);
    lua_setglobal(L, "test");
    lua_pushcfunction(L, [](lua_State* state) {
      return luaL_error(state, "print: expected a call in a test, because the file runs again for each test");
    });
    lua_setglobal(L, "print");
    refuse_words_of_behaviors(L);
    sandbox_.grant(instructions);
    fault_ = sandbox_.compile(text, name_);
    if (!fault_) fault_ = sandbox_.call(0, 0);
    is_declaring_ = false;
  }
  TestFile(const TestFile&) = delete;
  TestFile& operator=(const TestFile&) = delete;

  /// The error of running the file from top to bottom.
  const std::optional<ScriptFault>& fault() const { return fault_; }
  std::vector<std::string> names() const {
    std::vector<std::string> names;
    for (const auto& [name, function] : tests_) names.push_back(name);
    return names;
  }

  TestFailure as_failure(const ScriptFault& fault) const {
    return {fault.file.empty() ? name_ : fault.file, fault.line,
            shortened(as_line(fault.message) + "\n" + fault.traceback)};
  }

  TestCase run(std::size_t which, const TestRun& run, const ScriptTexts& texts, TestBudget& file,
               CoverageTrace& trace) {
    const auto& [name, function] = tests_.at(which);
    TestBudget budget(file);
    TestBench bench(run.scripts_root, texts, run.simulate, run.play_recording, run.load_interface, budget, trace);
    bench.add_to(sandbox_.state());
    sandbox_.grant(run.instructions);
    lua_rawgeti(sandbox_.state(), LUA_REGISTRYINDEX, function);
    const std::optional<ScriptFault> fault = sandbox_.call(0, 0);
    if (bench.needs_simulator()) return {name_, name, {}, true};
    TestCase result{name_, name, bench.finish(), false, bench.warnings()};
    result.printed = bench.printed();
    if (fault && !bench.exceeded_budget()) result.failures.push_back(as_failure(*fault));
    return result;
  }

 private:
  static int declare(lua_State* L) {
    auto& self = *static_cast<TestFile*>(lua_touserdata(L, lua_upvalueindex(1)));
    if (!self.is_declaring_)
      return luaL_error(L,
                        "test: unexpected declaration in a running test (declare tests at the top level of the file)");
    std::size_t length = 0;
    const char* const name = luaL_checklstring(L, 1, &length);
    luaL_checktype(L, 2, LUA_TFUNCTION);
    lua_settop(L, 2);
    if (length > kLongestName)
      return luaL_error(L, "test: expected a name of at most %d characters", static_cast<int>(kLongestName));
    if (self.tests_.size() >= kMostTests)
      return luaL_error(L, "test: expected at most %d tests in a file", static_cast<int>(kMostTests));
    self.tests_.emplace_back(std::string(name, length), luaL_ref(L, LUA_REGISTRYINDEX));
    return 0;
  }

  std::string name_;
  Sandbox sandbox_;
  std::optional<ScriptFault> fault_;
  bool is_declaring_ = true;
  std::vector<std::pair<std::string, int>> tests_;  ///< name, reference to the function
};

/// All tests of one file.
class FileRun {
 public:
  FileRun(const std::string& name, const std::string& text, const TestRun& run, const ScriptTexts& texts)
      : name_(name), text_(text), run_(run), texts_(texts), budget_(run.timeout, run.stop) {}

  void run(CoverageTrace& trace, const std::function<void(TestCase)>& take) {
    std::unique_ptr<TestFile> file = run_again();
    if (file->fault()) {
      take(TestCase{name_, "can be run", {file->as_failure(*file->fault())}, false, {}, false});
      return;
    }
    const std::vector<std::string> names = file->names();
    if (names.empty())
      take(failed("declares a test", "declares no test (expected test(\"behavior\", function() ... end))"));
    for (std::size_t i = 0; i < names.size() && !budget_.is_interrupted(); ++i) {
      if (budget_.exceeded()) {
        take(failed(names[i], "not run: " + budget_.reason()));
        continue;
      }
      if (run_.begin) run_.begin(name_, names[i]);
      if (file == nullptr) file = run_again();
      take(file->names() == names
               ? file->run(i, run_, texts_, budget_, trace)
               : failed(names[i], "expected the same tests each time the file runs, found different tests"));
      file.reset();
    }
  }

 private:
  std::unique_ptr<TestFile> run_again() const { return std::make_unique<TestFile>(name_, text_, run_.instructions); }
  TestCase failed(const std::string& name, const std::string& why) const {
    return {name_, name, {{name_, 0, why}}, false, {}, false};
  }

  const std::string& name_;
  const std::string& text_;
  const TestRun& run_;
  const ScriptTexts& texts_;
  TestBudget budget_;
};

bool is_test(const std::filesystem::path& file) { return file.filename().string().ends_with("_test.lua"); }

std::vector<std::filesystem::path> find_tests(std::span<const std::filesystem::path> paths) {
  std::vector<std::filesystem::path> files;
  for (const std::filesystem::path& path : paths) {
    std::error_code error;
    const std::size_t before = files.size();
    if (std::filesystem::is_directory(path, error)) {
      for (std::filesystem::recursive_directory_iterator entry(path, error), end; !error && entry != end;
           entry.increment(error)) {
        if (is_test(entry->path())) files.push_back(entry->path());
      }
      std::sort(files.begin() + static_cast<std::ptrdiff_t>(before), files.end());
      if (files.size() == before)
        throw std::runtime_error(path.string() + ": expected a file *_test.lua in this folder, found none");
    } else if (std::filesystem::is_regular_file(path, error)) {
      files.push_back(path);
    } else {
      throw std::runtime_error(path.string() + ": expected a file or folder, found none");
    }
  }
  return files;
}

/// The text with each line indented.
std::string indented(const std::string& text, const std::string& margin) {
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) out += margin + line + "\n";
  return out;
}

void report(const TestCase& test, std::ostream& out) {
  const char* const result = test.skipped ? "skipped " : test.failures.empty() ? "ok      " : "FAILED  ";
  out << result << as_line(test.file + ": " + test.name) << "\n";
  for (const std::string& text : test.printed) out << "    printed: " << as_line(text) << "\n";
  for (const TestFailure& failure : test.failures) {
    out << "    " << as_line(place_text(failure.file, failure.line, 0)) << ":\n" << indented(failure.text, "      ");
  }
}

}  // namespace

void run_test_text(const std::string& name, const std::string& text, const TestRun& run, const ScriptTexts& scripts,
                   CoverageTrace& trace, const std::function<void(TestCase)>& take) {
  FileRun(name, text, run, scripts).run(trace, take);
}

TestSummary run_script_tests(const TestRun& run, std::ostream& out, CoverageTrace& trace) {
  const std::filesystem::path all[] = {run.scripts_root / "tests"};
  TestSummary summary;
  const ScriptTexts texts = read_scripts(run.scripts_root);
  auto began = std::chrono::steady_clock::now();
  for (const std::filesystem::path& file : find_tests(run.paths.empty() ? all : std::span(run.paths))) {
    const std::string name = path_below(run.scripts_root, file).value_or(file.string());
    run_test_text(name, read_named_input(file, "a scripted test"), run, texts, trace, [&](TestCase test) {
      const auto ended = std::chrono::steady_clock::now();
      test.seconds = std::chrono::duration<double>(ended - std::exchange(began, ended)).count();
      if (run.end) run.end();
      report(test, out);
      out.flush();  // shows each test as it ends
      ++(test.skipped ? summary.skipped : test.failures.empty() ? summary.passed : summary.failed);
      summary.cases.push_back(std::move(test));
    });
    summary.interrupted = run.stop && run.stop();
    if (summary.interrupted) break;
  }
  out << summary.passed << " passed, " << summary.failed << " failed";
  if (summary.interrupted) out << ", interrupted before the remaining tests";
  if (summary.skipped > 0) out << ", " << summary.skipped << " skipped because they need the simulator (--simulator)";
  out << "\n";
  return summary;
}

}  // namespace reorient
