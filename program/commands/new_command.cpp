// `reorient new behavior NAME`: a small script that works, with a test that passes, to start from.
#include <memory>
#include <ostream>
#include <stdexcept>

#include <CLI/CLI.hpp>

#include "program/options.h"
#include "program/program.h"
#include "program/script_names.h"
#include "program/subcommand.h"
#include "workbench/files/atomic_file.h"

namespace reorient {
namespace {

struct NewOptions {
  std::string kind;
  std::string name;
  std::filesystem::path scripts;
};

constexpr const char* kBehavior =
    R"(--- Says what this behaviour is for, in a sentence or two. As it stands: it looks around while the robot is not sure of
--- its pose.

local p = param {
  sure  = { 0.5, range = { 0, 1 },                doc = "how far the believed pose must be ahead for the robot to be sure" },
  dwell = { 1.0, range = { 0.1, 10 }, unit = "s", doc = "how long to look to one side" },
  angle = { 0.8, range = { 0, 2 }, unit = "rad",  doc = "how far to turn the head to each side" },
}

local memory = keep { looks = 0 }   -- survives a reload; local variables do not

local function is_sure() return confidence.current - confidence.opposite > p.sure end

behavior "NAME" {
  priority = 22,                    -- greater than that of head_scan: while this one looks, that one waits
  initial = "sure",

  state "sure" {
    { "looking", when = function() return not is_sure() end, lasting = 0.5, because = "the robot is not sure of its pose" },
  },

  state "looking" {
    initial = "left",
    enter = function()
      memory.looks = memory.looks + 1
      log.info("not sure where I am, for the " .. memory.looks .. ". time")
    end,
    { "sure", when = is_sure, because = "the robot is sure of its pose" },

    state "left" {
      update = function() head.look(p.angle, 0) end,
      { "right", after = "dwell" },
    },
    state "right" {
      update = function() head.look(-p.angle, 0) end,
      { "left", after = "dwell" },
    },
  },
}
)";

constexpr const char* kBehaviorTest =
    R"(--- Tests of the behaviour NAME, in a fake world with a fake clock: reorient test scripts/tests/NAME_test.lua

test("rests while the robot is sure of its pose", function()
  set_world { confidence = { current = 0.9, opposite = 0.0 } }
  load_behavior "NAME"
  advance(5.0)
  expect.state("NAME", "sure")
end)

test("looks to both sides while it is not", function()
  set_world { confidence = { current = 0.4, opposite = 0.4 } }
  load_behavior "NAME"
  advance(1.0)
  expect.state("NAME", "looking/left")
  expect.reason("NAME", "the robot is not sure of its pose")
  expect.head(0.8, 0)
  advance(1.0)
  expect.state("NAME", "looking/right")
  expect.head(-0.8, 0)
  advance(1.0)
  expect.state("NAME", "looking/left")
end)

test("rests again as soon as it is sure", function()
  load_behavior "NAME"
  advance(1.0)
  set_world { confidence = { current = 0.9, opposite = 0.0 } }
  advance(0.1)
  expect.state("NAME", "sure")
end)

test("keeps its state when the script is edited", function()
  load_behavior "NAME"
  advance(1.0)
  reload { from = "0.8, range", to = "0.5, range" }
  expect.state("NAME", "looking/left")
  advance(0.1)
  expect.head(0.5, 0)
end)
)";

constexpr const char* kScenario =
    R"(--- Says which situation this scenario makes. As it stands: the robot is told where it is, looks about, and is judged by
--- how well it still knows its place after some time.

local p = param {
  time  = { 20.0, range = { 1, 600 }, unit = "s",  doc = "how long to wait" },
  error = { 0.5,  range = { 0.01, 5 }, unit = "m", doc = "how far the believed pose may be off" },
}

local function is_right()
  local dx, dy = pose.x - truth.x, pose.y - truth.y
  return dx * dx + dy * dy < p.error * p.error
end

scenario "NAME" {
  behaviors = { "orientation", "head_scan" },
  initial = "placing",

  state "placing" {
    enter = function()
      experimenter.put_down(-1.0, 0.5, 0)
      experimenter.set_initial_pose(-1.0, 0.5, 0)
    end,
    { "waiting", after = 0.1, because = "the robot was told where it stands" },
  },

  state "waiting" {
    { "right", when = is_right, after = "time", because = "the time is over" },
    { "wrong", after = "time", because = "the time is over" },
  },

  state "right" { enter = function() verdict.succeed("the robot knows its place") end },
  state "wrong" { enter = function() verdict.fail("the robot has lost its place") end },
}
)";

constexpr const char* kScenarioTest = R"(--- Tests of the scenario NAME.

test("judges by the pose", function()
  load_scenario "NAME"
  set_world { pose = { x = -1.0, y = 0.5 }, truth = { x = -1.0, y = 0.5 } }
  advance(21.0)
  expect.verdict(true, "knows its place")
end)

test("fails a robot that is elsewhere", function()
  load_scenario "NAME"
  set_world { pose = { x = -1.0, y = 0.5 }, truth = { x = 1.0, y = -0.5 } }
  advance(21.0)
  expect.verdict(false, "lost its place")
end)

test("ends right on the simulator", function()
  simulate { scenario = "NAME", seed = 1, width = 160 }
  expect.verdict(true, "knows its place")
end)
)";

std::string named(std::string text, const std::string& name) {
  const std::string blank = "NAME";
  for (std::size_t at = text.find(blank); at != std::string::npos; at = text.find(blank, at + name.size()))
    text.replace(at, blank.size(), name);
  return text;
}

int make(const NewOptions& options, std::ostream& out) {
  require_script_name(options.name);
  const bool is_behavior = options.kind == "behavior";
  const std::filesystem::path root = scripts_root(options.scripts, Scripts::may_come);
  const std::filesystem::path script = root / (is_behavior ? "behaviors" : "scenarios") / (options.name + ".lua");
  const std::filesystem::path test = root / "tests" / (options.name + "_test.lua");
  for (const std::filesystem::path& file : {script, test}) {
    if (std::filesystem::exists(file))
      throw std::runtime_error(file.string() + " is there already; choose another name");
  }
  for (const std::filesystem::path& file : {script, test}) {
    std::error_code error;
    std::filesystem::create_directories(file.parent_path(), error);
    if (error)
      throw std::runtime_error("cannot make the folder " + file.parent_path().string() + ": " + error.message());
  }
  const std::string where = options.scripts.empty() ? "" : " --scripts " + options.scripts.string();
  write_whole_file(script, named(is_behavior ? kBehavior : kScenario, options.name));
  write_whole_file(test, named(is_behavior ? kBehaviorTest : kScenarioTest, options.name));
  out << script.string() << "\n"
      << test.string() << "\nNext: reorient check" << where << ", then reorient test " << test.string() << where
      << "\n";
  return kSuccess;
}

}  // namespace

Subcommand add_new(CLI::App& program) {
  const auto options = std::make_shared<NewOptions>();
  CLI::App* const parser =
      program.add_subcommand("new", "write a small working script with its test, to start from")->fallthrough();
  parser->add_option("kind", options->kind, "behavior or scenario")
      ->check(CLI::IsMember({"behavior", "scenario"}))
      ->required();
  parser->add_option("name", options->name, "small letters, digits and _")->required();
  add_scripts_option(*parser, options->scripts);
  return {parser, [options](std::ostream& out, std::ostream&) { return make(*options, out); }};
}

}  // namespace reorient
