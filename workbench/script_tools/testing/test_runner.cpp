#include "workbench/script_tools/testing/test_runner.h"

#include <algorithm>
#include <map>
#include <ostream>
#include <sstream>
#include <stdexcept>

#include "engine/script/sandbox/sandbox.h"
#include "workbench/files/atomic_file.h"
#include "workbench/files/script_files.h"

namespace reorient {
namespace {

/// Tests are trusted more than behaviours, but an endless loop in one shall not hang the run either.
ScriptLimits test_limits() {
  ScriptLimits limits;
  limits.max_memory = 64 * 1024;
  limits.string_length = 1024 * 1024;
  return limits;
}

constexpr std::int64_t kInstructionsPerTest = 50'000'000;

/// One file of tests: its Lua, and the tests that it declares.
class TestFile {
 public:
  TestFile(std::string name, const TestRun& run, const ScriptTexts& texts)
      : name_(std::move(name)), run_(run), texts_(texts), sandbox_(test_limits()) {}

  void run(const std::string& text, CoverageTrace& trace, std::vector<TestCase>& cases) {
    lua_State* const L = sandbox_.state();
    lua_pushlightuserdata(L, this);
    lua_pushcclosure(L, &TestFile::declare, 1);
    lua_setglobal(L, "test");
    sandbox_.grant(kInstructionsPerTest);
    std::optional<ScriptFault> fault = sandbox_.compile(text, name_);
    if (!fault) fault = sandbox_.call(0, 0);
    if (fault) {
      cases.push_back({name_, "can be run", {as_failure(*fault)}, false});
      return;
    }
    for (const auto& [name, function] : tests_) cases.push_back(run_test(name, function, trace));
  }

 private:
  static int declare(lua_State* L) {
    auto& self = *static_cast<TestFile*>(lua_touserdata(L, lua_upvalueindex(1)));
    const char* const name = luaL_checkstring(L, 1);
    luaL_checktype(L, 2, LUA_TFUNCTION);
    lua_settop(L, 2);
    self.tests_.emplace_back(name, luaL_ref(L, LUA_REGISTRYINDEX));
    return 0;
  }

  TestFailure as_failure(const ScriptFault& fault) const {
    return {fault.file.empty() ? name_ : fault.file, fault.line, fault.message + "\n" + fault.traceback};
  }

  TestCase run_test(const std::string& name, int function, CoverageTrace& trace) {
    TestBench bench(run_.scripts_root, texts_, run_.simulate, trace);
    bench.add_to(sandbox_.state());
    sandbox_.grant(kInstructionsPerTest);
    lua_rawgeti(sandbox_.state(), LUA_REGISTRYINDEX, function);
    const std::optional<ScriptFault> fault = sandbox_.call(0, 0);
    if (bench.needs_simulator()) return {name_, name, {}, true};
    TestCase result{name_, name, bench.finish(), false};
    if (fault) result.failures.push_back(as_failure(*fault));
    return result;
  }

  std::string name_;
  const TestRun& run_;
  const ScriptTexts& texts_;
  Sandbox sandbox_;
  std::vector<std::pair<std::string, int>> tests_;
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
      if (files.size() == before) throw std::runtime_error(path.string() + ": no file *_test.lua in this folder");
    } else if (std::filesystem::is_regular_file(path, error)) {
      files.push_back(path);
    } else {
      throw std::runtime_error(path.string() + ": there is no such test");
    }
  }
  return files;
}

std::string read(const std::filesystem::path& file) {
  std::optional<std::string> text = read_whole_file(file);
  if (!text) throw std::runtime_error(file.string() + ": the test cannot be read");
  return std::move(*text);
}

/// Every line of the text, set in.
std::string indented(const std::string& text, const std::string& margin) {
  std::istringstream lines(text);
  std::string out;
  for (std::string line; std::getline(lines, line);) out += margin + line + "\n";
  return out;
}

void report(const TestCase& test, std::ostream& out) {
  const char* const result = test.skipped ? "skipped " : test.failures.empty() ? "ok      " : "FAILED  ";
  out << result << test.file << ": " << test.name << "\n";
  for (const TestFailure& failure : test.failures) {
    out << "    " << failure.file << ":" << failure.line << ":\n" << indented(failure.text, "      ");
  }
}

}  // namespace

TestSummary run_script_tests(const TestRun& run, std::ostream& out, CoverageTrace& trace) {
  const std::filesystem::path all[] = {run.scripts_root / "tests"};
  TestSummary summary;
  const ScriptTexts texts = read_scripts(run.scripts_root);
  for (const std::filesystem::path& file : find_tests(run.paths.empty() ? all : std::span(run.paths))) {
    const std::size_t first = summary.cases.size();
    TestFile(path_below(run.scripts_root, file).value_or(file.string()), run, texts)
        .run(read(file), trace, summary.cases);
    for (std::size_t i = first; i < summary.cases.size(); ++i) {
      const TestCase& test = summary.cases[i];
      report(test, out);
      ++(test.skipped ? summary.skipped : test.failures.empty() ? summary.passed : summary.failed);
    }
  }
  out << summary.passed << " passed, " << summary.failed << " failed";
  if (summary.skipped > 0) out << ", " << summary.skipped << " skipped that want the simulator (--simulator)";
  out << "\n";
  return summary;
}

}  // namespace reorient
