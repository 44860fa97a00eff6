// SPDX-License-Identifier: MIT
#include "workbench/script_tools/reference/vocabulary.h"

#include "engine/world/arbiter.h"
#include "engine/world/commands.h"
#include "workbench/scenario/scenario_language.h"

namespace reorient {
namespace {

constexpr ScriptWord kLanguage[] = {
    {"param(declarations: table<string, table>): table<string, any> values",
     "local p = param { lead = { 0.5, range = { 0, 1 }, unit = \"\", doc = \"what it is\" } }",
     "Declares parameters with default, range, unit and description. `{ true, doc = ... }` is a switch, `{ \"slow\", "
     "choices = { \"slow\", \"fast\" }, doc = ... }` is a choice, and `integer = true` permits only whole numbers. "
     "Returns a read-only table of the current values. The full name of a parameter is the name of the file, a dot, "
     "and its name.",
     {}},
    {"args(declarations: table<string, table>): table<string, any> values",
     "local a = args { x = { 0.0, range = { -10, 10 }, unit = \"m\", doc = \"where to walk\" } }",
     "Declares what a behavior that runs this one may give it, as `param` declares parameters; each argument has a "
     "default. Returns a read-only table of the values in this frame. A dwell time may be the name of an argument.",
     {}},
    {"keep(defaults: table): table memory", "local memory = keep { flips = 0 }",
     "Declares a table of numbers, texts and booleans that survives a reload of the script. Removed values stay "
     "removed, and values that a new version adds start as declared. Local variables do not survive.",
     "---@generic T: table\n---@param defaults T\n---@return T memory\nfunction keep(defaults) end"},
    {"behavior(name: string): fun(body: reorient.State)",
     "behavior \"name\" { priority = 50, initial = \"watching\", common = { ... }, state \"watching\" { ... } }",
     "Declares a state machine. `priority`: if requests conflict, the behavior with the greater priority wins; with "
     "equal priorities, the one that was loaded first. `priority = { 50, head = 60 }`: another one for a part of the "
     "body. `initial`: the first state. `common`: transitions from any state, not taken while their target is "
     "active; if the conditions of two of them hold at the same time, the states alternate in each frame.",
     {}},
    {"state(name: string): fun(body: reorient.State): table",
     "state \"watching\" { enter = f, update = f, exit = f, { \"target\", when = f, lasting = 0.5 } }",
     "Declares a state. `enter`, `update` and `exit`: functions that run when the state is entered, in every frame, "
     "and when it is left. It contains transitions and inner states. A state with inner states may also have "
     "`initial`, `common`, and `history = true`, which resumes the inner state that was active last. `publishes = "
     "\"name\"`: a flag that other scripts read as `published.name`. `ends = \"done\"` or `ends = \"failed\"`: the "
     "state "
     "ends the behavior for the one that runs it.",
     {}},
    {"run(behavior: string): fun(arguments: table): table",
     "state \"going\" { run \"walk_to\" { x = 1.0, y = function() return input.ball.position.y end }, ... }",
     "In a state of a behavior: runs another behavior while the state is active, with values for its `args`. A "
     "function is evaluated in every frame, and its result is limited to the range of the argument. The behavior "
     "starts when the state is entered, runs in each frame after its caller, with the priority of its caller, and "
     "stops "
     "when the state is left. A state may run several behaviors. The machine is named after its callers: "
     "`striker/walk_to`.",
     {}},
    {"done(behavior: string): fun(): boolean",
     "{ \"kicking\", when = done \"walk_to\", because = \"the robot stands behind the ball\" }",
     "A condition: a behavior that the state runs has ended in a state with `ends = \"done\"`.",
     {}},
    {"failed(behavior: string): fun(): boolean",
     "{ \"searching\", when = failed \"walk_to\", because = \"the robot did not arrive\" }",
     "The same for a state with `ends = \"failed\"`, and for a behavior that was stopped after errors.",
     {}},
    {"called", "called.walk_to.outcome == \"failed\"",
     "The behaviors that the active states run, read-only: `outcome` (`running`, `done` or `failed`), `reason` (of the "
     "last transition), `state` (path) and `time_in_state` (s). After the state was left, outcome and reason of a "
     "behavior "
     "that had ended remain until it runs again; the others are nil and 0.",
     "---@class reorient.Called\n---@field outcome \"running\"|\"done\"|\"failed\"|nil\n---@field reason string?\n"
     "---@field state string?\n---@field time_in_state number s\n\n---@type table<string, reorient.Called>\ncalled = "
     "{}"},
    {"scenario(name: string): fun(body: reorient.State)",
     "scenario \"name\" { behaviors = { \"orientation\" }, initial = \"placing\", state \"placing\" { ... } }",
     "Declares a scenario for the simulator: a state machine like a behavior, which plays the operator beside the "
     "field and runs after each frame. `behaviors`: scripts to load. `room = \"rooms/lab.hdr\"` or `hall_seed = 3`, "
     "and `field`: the setting, unless the command line sets it. `room` is the path of a panorama from the scripts' "
     "root, or the name of one in assets/rooms; `field` likewise. Other files need `--room` and `--field`. Only "
     "scenarios have `truth`, `operator` and "
     "`verdict`. They cannot move the robot.",
     {}},
    {"require(module: string): any",
     "local walking = require \"lib.walk\"",
     "Returns the value that the file lib/walk.lua below the scripts' root returns. Allowed only at the top level of a "
     "script.",
     {}},
    {"behaviors", "behaviors.orientation.state == \"watching\"",
     "The other machines at the start of the frame, read-only: `state` (path) and `time_in_state` (s). Of a machine "
     "that "
     "does not run they are nil and 0; `reorient check` reports unknown names.",
     "---@class reorient.Machine\n---@field state string? path of the innermost active state\n---@field time_in_state "
     "number s\n\n---@type table<string, reorient.Machine>\nbehaviors = {}"},
    {"published", "published.pose_is_searched",
     "Whether a state with `publishes = \"pose_is_searched\"` of any machine was active at the start of the frame; "
     "false if no script publishes it.",
     "---@type table<string, boolean>\npublished = {}"},
    {"input", "if input.valid.ball.x and input.ball.x > 0 then action.kick { foot = \"left\" } end",
     "The values of the application, read-only: `input.NAME` has always a value of its type, `input.age.NAME` is the "
     "time since it was set (s; infinite if never), `input.valid.NAME` tells whether it is not too old and fits its "
     "declaration. An interface declares them (docs/applications.md).",
     "---@class reorient.InputAge: table<string, any>\n\n---@class reorient.InputValid: table<string, any>\n\n"
     "---@class reorient.Input: table<string, any>\n---@field age reorient.InputAge\n---@field valid "
     "reorient.InputValid"
     "\n\n---@type reorient.Input\ninput = {}"},
    {"action", "action.kick { foot = \"left\", direction = 0.3 }",
     "The actions of the application. `action.NAME { ... }` requests one in `enter`, `update` or `exit`; repeated with "
     "the same arguments, it continues. `action.NAME.state` is `idle`, `requested`, `running`, `done` or `failed`, "
     "`.reason` tells why it failed, and `.time_in_state` for how long (s).",
     "---@class reorient.Action\n---@field state \"idle\"|\"requested\"|\"running\"|\"done\"|\"failed\"\n---@field "
     "reason "
     "string\n---@field time_in_state number s\n---@operator call(table): nil\n\n---@class reorient.Actions: "
     "table<string, "
     "reorient.Action>\n\n---@type reorient.Actions\naction = {}"},
    {"print(...: any)",
     "print(\"flips\", memory.flips)",
     "Writes a line to the run's log; in a test, a line below its result.",
     {}},
};

constexpr ScriptWord kTest[] = {
    {"test(name: string, run: fun())",
     "test(\"flips when the opposite pose wins\", function() ... end)",
     "Declares a test. The file runs again for each test in a new sandbox, with its own world, clock and scripts. A "
     "test is limited to 60 s (`--timeout`) and to 36 000 s of the robot's time, all tests of a file together to ten "
     "times that.",
     {}},
    {"load_behavior(behavior: reorient.BehaviorScript, arguments?: table<string, any>)",
     "load_behavior(\"walk_to\", { x = 1.0 })",
     "Loads a behavior and the behaviors that it runs. `arguments`: values for its `args`, as a behavior gives them "
     "that "
     "runs it; they do not change.",
     {}},
    {"load_scenario(scenario: reorient.ScenarioScript)",
     "load_scenario \"mirrored_placement\"",
     "Loads a scenario and its behaviors.",
     {}},
    {"set_world(world: reorient.World)",
     "set_world { confidence = { opposite = 0.9 }, robot = { posture = \"lying\" } }",
     "Changes what the robot senses in the fake world from the next frame. Derived values (times since a disturbance, "
     "age and status of the confidences, whether training and evaluation are active) follow the engine's own rules "
     "until the test sets it itself. A granted command changes the pose and the confidences as it does in the engine: "
     "after a flip, the evidence has the other sign. The clock cannot be set: `advance` lets time pass.",
     {}},
    {"load_interface(interface: string)",
     "load_interface \"soccer\"",
     "Declares the values and actions of an application: a name in assets/interfaces, or a path from the scripts' "
     "root. "
     "Call it before `load_behavior`.",
     {}},
    {"set_input(values: reorient.InputValues)",
     "set_input { ball = { x = 1.0, seen = true } }",
     "Sets values of the application in the next frame. They stay until they are set again; their age grows.",
     {}},
    {"report_action(action: reorient.ApplicationAction, state: string, reason?: string)",
     "report_action(\"kick\", \"failed\", \"no ball\")",
     "Reports in the next frame that the latest start of an action is running, done or failed.",
     {}},
    {"set_param(name: reorient.ParameterName, value: string)",
     "set_param(\"decision.false_flips\", \"1\")",
     "Changes a parameter as a user does during a run. The parameter of a script that is loaded later is set when the "
     "script is loaded. The test fails if none of its scripts declares the parameter.",
     {}},
    {"hear(sender: integer, text: string)",
     "hear(2, \"I am sure of my pose\")",
     "Adds a message of a teammate to the next frame.",
     {}},
    {"advance(seconds: number)",
     "advance(1.0)",
     "Runs the frames of this time, in seconds, at 30 frames per second; at least one frame.",
     {}},
    {"reload(edit: { from: string, to: string, file: string? })",
     "reload { from = \"0.5\", to = \"0.3\", file = \"lib/walk.lua\" }",
     "Replaces a text in a script and reloads it. Without `file`, edits the script that was loaded last.",
     {}},
    {"simulate(run: { scenario: reorient.ScenarioScript, with: string[]?, seed: integer?, width: integer?, seconds: "
     "number?, room_awareness: boolean?, room: string?, hall_seed: integer?, field: string?, params: table<string, "
     "any>? }): boolean is_correct",
     "simulate { scenario = \"mirrored_placement\", seed = 1, params = { [\"decision.false_flips\"] = 1 } }",
     "Runs a whole scenario on the simulator and returns whether the belief is correct at its end. Later expectations "
     "apply to the whole run. Optional: `with` (a list of additional behaviors), `width` of the image (160, 320, 544 "
     "or 640 pixels), `seconds` (the longest run), `room_awareness`, and `room`, `hall_seed` and `field` as in a "
     "scenario. The test is skipped without `reorient test --simulator`.",
     {}},
    {"replay(file: string)",
     "replay \"recordings/flip.mcap\"",
     "Loads a recording (path from the tests' folder, below the scripts' root) instead of a fake world and runs its "
     "first frame with the "
     "current scripts instead of the recorded ones. `advance` and `advance_to` continue it; `set_param`, `reload` and "
     "`hear` affect its next frame. The recorded views do not change, so the result is only an estimate once the robot "
     "acts differently.",
     {}},
    {"advance_to(time: number)",
     "advance_to(43.5)",
     "Continues a recording up to the frame at this time (s of the robot).",
     {}},
    {"world_value(name: string): number|string|boolean value",
     "expect.near(world_value(\"pose.x\"), 1.2, 0.1)",
     "Returns a value of the world as behaviors read it in this frame.",
     {}},
    {"expect.started(action: reorient.ApplicationAction, arguments?: table)",
     "expect.started(\"kick\", { foot = \"left\" })",
     "A behavior started the action during the last `advance`, with these arguments if they are given, numbers to "
     "1e-6; "
     "arguments that are left out have their defaults.",
     {}},
    {"expect.not_started(action: reorient.ApplicationAction)",
     "expect.not_started \"kick\"",
     "No behavior started the action during the last `advance`.",
     {}},
    {"expect.as_recorded()",
     "expect.as_recorded()",
     "In all frames of the replay so far, the robot did what was recorded: commands, head, walking, messages.",
     {}},
    {"expect.state(machine: reorient.MachineName, path: reorient.StatePath)",
     "expect.state(\"orientation\", \"watching\")",
     "The machine is in this state (path).",
     {}},
    {"expect.reason(machine: reorient.MachineName, text: string)",
     "expect.reason(\"orientation\", \"the robot fell\")",
     "The machine's last transition had this reason.",
     {}},
    {"expect.command(name: reorient.CommandName, verdict?: reorient.Verdict)",
     "expect.command(\"flip_pose\", \"granted\")",
     "The command was issued during the last `advance`, with this verdict if it is given (granted, outranked, "
     "too_soon, not_allowed).",
     {}},
    {"expect.no_command(name?: reorient.CommandName)",
     "expect.no_command()",
     "The command, or without a name any reorientation, was not issued during the last `advance`.",
     {}},
    {"expect.lease(name: reorient.PauseName)",
     "expect.lease(\"pause_training\")",
     "A state holds a lease on this pause now.",
     {}},
    {"expect.no_lease(name: reorient.PauseName)",
     "expect.no_lease(\"pause_training\")",
     "No state holds a lease on this pause now.",
     {}},
    {"expect.head(yaw: number, pitch: number)",
     "expect.head(1.1, -0.1)",
     "The requested angles of the head (yaw, pitch in rad).",
     {}},
    {"expect.walk(forward: number, left: number, turn: number)",
     "expect.walk(0.2, 0, 0)",
     "The requested walking velocity (m/s, m/s, rad/s).",
     {}},
    {"expect.get_up(requested: boolean)",
     "expect.get_up(true)",
     "Whether a behavior requests that the robot gets up.",
     {}},
    {"expect.log(text: string)", "expect.log(\"lifted\")", "A log line of the last `advance` contains this text.", {}},
    {"expect.message(text: string)",
     "expect.message(\"turned\")",
     "A message to the teammates in the last `advance` contains this text.",
     {}},
    {"expect.action(name: reorient.ActionName)",
     "expect.action(\"put_down\")",
     "The operator of the scenario performed this action during the last `advance`.",
     {}},
    {"expect.verdict(succeeded: boolean, text: string)",
     "expect.verdict(true, \"right mark\")",
     "The scenario ended with this verdict, whose text contains `text`.",
     {}},
    {"expect.error(text: string)",
     "expect.error(\"nil value\")",
     "A script failed with an error that contains this text. Without this expectation, a failing script fails the "
     "test.",
     {}},
    {"expect.refused(text: string)",
     "expect.refused(\"did you mean\")",
     "The last reload was rejected with an error that contains this text. Without this expectation, a rejected reload "
     "fails the test.",
     {}},
    {"expect.equal(actual: any, expected: any)",
     "expect.equal(count, 3)",
     "Two values are equal. Tables are compared field by field. The first value is the actual one.",
     {}},
    {"expect.near(actual: number, expected: number, tolerance: number)",
     "expect.near(x, 1.5, 0.1)",
     "The difference of the first two numbers is at most the third.",
     {}},
};

// Types as in Lua's manual, except that a text is not accepted as a number.
constexpr std::string_view kBase[] = {
    "assert(value: any, message?: any, ...: any): any, ...",
    "error(message?: any, level?: integer)",
    "getmetatable(object: any): any",
    "ipairs(list: table): function, table, integer",
    "next(table: table, after?: any): any, any",
    "pairs(table: table): function, any, any",
    "pcall(run: any, ...: any): boolean, ...",
    "rawequal(left: any, right: any): boolean",
    "rawget(table: table, key: any): any",
    "rawlen(list: table|string): integer",
    "rawset(table: table, key: any, value: any): table",
    "select(first: integer|string, ...: any): any, ...",
    "setmetatable(table: table, metatable: table|nil): any",
    "tonumber(value: any, base?: integer): number|nil",
    "tostring(value: any): string",
    "type(value: any): string",
    "xpcall(run: any, handler: function, ...: any): boolean, ...",
};
constexpr std::string_view kMath[] = {
    "math.abs(x: number): number",
    "math.acos(x: number): number",
    "math.asin(x: number): number",
    "math.atan(y: number, x?: number): number",
    "math.ceil(x: number): number",
    "math.cos(x: number): number",
    "math.deg(x: number): number",
    "math.exp(x: number): number",
    "math.floor(x: number): number",
    "math.fmod(x: number, y: number): number",
    "math.huge: number",
    "math.log(x: number, base?: number): number",
    "math.max(x: number, ...: number): number",
    "math.maxinteger: integer",
    "math.min(x: number, ...: number): number",
    "math.mininteger: integer",
    "math.modf(x: number): number, number",
    "math.pi: number",
    "math.rad(x: number): number",
    "math.random(low?: integer, high?: integer): number",
    "math.sin(x: number): number",
    "math.sqrt(x: number): number",
    "math.tan(x: number): number",
    "math.tointeger(x: any): integer|nil",
    "math.type(x: any): string|nil",
    "math.ult(left: integer, right: integer): boolean",
};
constexpr std::string_view kString[] = {
    "string.byte(text: string, first?: integer, last?: integer): integer, ...",
    "string.char(...: integer): string",
    "string.find(text: string, pattern: string, first?: integer, plain?: any): integer|nil, ...",
    "string.format(format: string, ...: any): string",
    "string.gmatch(text: string, pattern: string, first?: integer): function",
    "string.gsub(text: string, pattern: string, replacement: string|table|function, most?: integer): string, integer",
    "string.len(text: string): integer",
    "string.lower(text: string): string",
    "string.match(text: string, pattern: string, first?: integer): any, ...",
    "string.rep(text: string, count: integer, separator?: string): string",
    "string.reverse(text: string): string",
    "string.sub(text: string, first: integer, last?: integer): string",
    "string.upper(text: string): string",
};
constexpr std::string_view kTable[] = {
    "table.concat(list: table, separator?: string, first?: integer, last?: integer): string",
    "table.insert(list: table, position_or_value: any, value?: any)",
    "table.move(from: table, first: integer, last: integer, position: integer, to?: table): table",
    "table.pack(...: any): table",
    "table.remove(list: table, position?: integer): any",
    "table.sort(list: table, is_before?: function)",
    "table.unpack(list: table, first?: integer, last?: integer): any, ...",
};
constexpr LibraryRow kLibrary[] = {{"", kBase}, {"math", kMath}, {"string", kString}, {"table", kTable}};

template <typename... Enums>
std::vector<std::string> names_of() {
  std::vector<std::string> names;
  const auto list = [&names](auto first) {
    for (int i = 0; i < enum_count(first); ++i) names.emplace_back(to_string(static_cast<decltype(first)>(i)));
  };
  (list(Enums{}), ...);
  return names;
}

}  // namespace

std::span<const ScriptWord> language_words() { return kLanguage; }
std::span<const ScriptWord> test_words() { return kTest; }
std::span<const LibraryRow> library_rows() { return kLibrary; }

std::vector<NameType> name_types() {
  return {{"reorient.CommandName", names_of<Reorientation, Pause>()},
          {"reorient.Verdict", names_of<Verdict>()},
          {"reorient.PauseName", names_of<Pause>()},
          {"reorient.ApplicationAction", {}},
          {"reorient.ActionName", names_of<OperatorAction::Kind>()},
          {"reorient.MachineName", {}},
          {"reorient.StatePath", {}},
          {"reorient.BehaviorScript", {}},
          {"reorient.ScenarioScript", {}},
          {"reorient.ParameterName", {}}};
}

}  // namespace reorient
