#include "workbench/script_tools/reference/vocabulary.h"

namespace reorient {
namespace {

constexpr ScriptWord kLanguage[] = {
    {"param", "local p = param { lead = { 0.5, range = { 0, 1 }, unit = \"\", doc = \"what it is\" } }",
     "Declares numbers that can be tuned: default, range, unit, sentence. `{ true, doc = ... }` is a switch, "
     "`{ \"slow\", choices = { \"slow\", \"fast\" }, doc = ... }` a choice, `integer = true` asks for whole numbers. "
     "The "
     "result is a "
     "read-only table of the present values. Their full name is the file's name, a dot, and the name.",
     "---@param declarations table<string, table>\n---@return table<string, any> values\nfunction param(declarations) "
     "end"},
    {"keep", "local memory = keep { flips = 0 }",
     "A table of plain values that survives a reload. Local variables do not.",
     "---@generic T: table\n---@param defaults T\n---@return T memory\nfunction keep(defaults) end"},
    {"behavior",
     "behavior \"name\" { priority = 50, initial = \"watching\", common = { ... }, state \"watching\" { ... } }",
     "Declares a state machine. `priority`: the greater wins where two want the same. `initial`: the first state. "
     "`common`: "
     "transitions out of whichever state, not taken while their target is active.",
     "---@param name string\n---@return fun(body: reorient.State)\nfunction behavior(name) end"},
    {"state", "state \"watching\" { enter = f, update = f, exit = f, { \"target\", when = f, lasting = 0.5 } }",
     "Declares a state: what to do on entering it, in every frame, and on leaving it; its transitions; states within "
     "it, then also "
     "`initial`, `common`, and `history = true` to resume the inner state that was active last. `publishes = "
     "\"name\"`: what others may ask for as `published.name`.",
     "---@param name string\n---@return fun(body: reorient.State): table\nfunction state(name) end"},
    {"scenario",
     "scenario \"name\" { behaviors = { \"orientation\" }, initial = \"placing\", state \"placing\" { ... } }",
     "Declares a situation for the simulator: a state machine as a behaviour is, which plays the person beside the "
     "field. "
     "`behaviors`: which to load. `room = \"rooms/lab.hdr\"` (a panorama, from the scripts' root, or the name of one "
     "in "
     "assets/rooms) or `hall_seed = 3`, and `field` likewise: where it takes place, unless the command line says it. "
     "It "
     "alone has `truth`, `experimenter` and `verdict`; it cannot move the robot. It "
     "runs after each frame.",
     "---@param name string\n---@return fun(body: reorient.State)\nfunction scenario(name) end"},
    {"require", "local walking = require \"lib.walk\"",
     "What the file lib/walk.lua below the scripts' root returns. Stands at the top of a script.",
     "---@param module string\n---@return any\nfunction require(module) end"},
    {"behaviors", "behaviors.orientation.state == \"watching\"",
     "The other machines as they stood when the frame began, read-only: `state` (path) and `time_in_state` (s).",
     "---@class reorient.Machine\n---@field state string path of the innermost active state\n"
     "---@field time_in_state number s\n\n---@type table<string, reorient.Machine>\nbehaviors = {}"},
    {"published", "published.pose_is_searched",
     "Whether a state with `publishes = \"pose_is_searched\"` was active when the frame began, in whatever machine; "
     "false where nobody publishes it.",
     "---@type table<string, boolean>\npublished = {}"},
    {"print", "print(\"flips\", memory.flips)", "Writes a line into the run's log.",
     "---@param ... any\nfunction print(...) end"},
};

constexpr ScriptWord kTest[] = {
    {"test", "test(\"flips when the opposite pose wins\", function() ... end)",
     "Declares a test. Its file is run anew for it in a fresh sandbox, with a world, a clock and scripts of its own. "
     "It may "
     "take 60 s (`--timeout`) and 36 000 s of the robot's time, the tests of a file ten times that.",
     "---@param name string\n---@param run fun()\nfunction test(name, run) end"},
    {"load_behavior", "load_behavior \"orientation\"", "Loads a behaviour.",
     "---@param behavior string\nfunction load_behavior(behavior) end"},
    {"load_scenario", "load_scenario \"turned_round\"", "Loads a scenario and its behaviours.",
     "---@param scenario string\nfunction load_scenario(scenario) end"},
    {"set_world", "set_world { confidence = { opposite = 0.9 }, robot = { posture = \"lying\" } }",
     "Changes the fake world, from the next frame on. What follows from the rest (times since a disturbance, age and "
     "status of the confidences, whether training and evaluation go on) follows until the test sets it itself.",
     "---@param world table<string, table<string, number|boolean|string>>\nfunction set_world(world) end"},
    {"set_param", "set_param(\"orientation.lead\", \"0.3\")",
     "Changes a parameter as a user does live. One of a script that is loaded later waits for it; one that nothing in "
     "the "
     "test has is a failure.",
     "---@param name string\n---@param value string\nfunction set_param(name, value) end"},
    {"advance", "advance(1.0)", "Lets this many seconds pass, 30 frames each; at least one frame.",
     "---@param seconds number\nfunction advance(seconds) end"},
    {"reload", "reload { from = \"0.5\", to = \"0.3\", file = \"lib/walk.lua\" }",
     "Edits a text of a script (the one that was loaded last, where no file is named) and reloads it.",
     "---@param edit { from: string, to: string, file: string? }\nfunction reload(edit) end"},
    {"simulate", "simulate { scenario = \"turned_round\", seed = 1, params = { [\"orientation.lead\"] = 0.4 } }",
     "Runs a whole scenario on the simulator and gives whether the belief was right at its end; what is expected "
     "behind it is expected of the whole run. Also takes `with`, a list of more behaviours, `width` of the image (160, "
     "320, 640), `seconds` at most, `room_awareness`, and `room`, `hall_seed`, `field` as a scenario does. Skipped "
     "unless `reorient test --simulator`.",
     "---@param run { scenario: string, with: string[]?, seed: integer?, width: integer?, seconds: number?, "
     "room_awareness: boolean?, room: string?, hall_seed: integer?, field: string?, "
     "params: table<string, any>? }\n---@return boolean is_correct\nfunction simulate(run) end"},
    {"expect.state", "expect.state(\"orientation\", \"watching\")", "The machine is in this state (path).",
     "---@param machine string\n---@param path string\nfunction expect.state(machine, path) end"},
    {"expect.reason", "expect.reason(\"orientation\", \"the robot fell\")",
     "The machine's last transition had this reason.",
     "---@param machine string\n---@param text string\nfunction expect.reason(machine, text) end"},
    {"expect.command", "expect.command(\"flip_pose\", \"granted\")",
     "The command was issued during the last `advance`, with this verdict if one is named (granted, outranked, "
     "too_soon, not_allowed).",
     "---@param name string\n---@param verdict? string\nfunction expect.command(name, verdict) end"},
    {"expect.no_command", "expect.no_command()",
     "The command, or any reorientation, was not issued during the last `advance`.",
     "---@param name? string\nfunction expect.no_command(name) end"},
    {"expect.lease", "expect.lease(\"pause_training\")", "Some state holds this pause now.",
     "---@param name string\nfunction expect.lease(name) end"},
    {"expect.no_lease", "expect.no_lease(\"pause_training\")", "No state holds this pause now.",
     "---@param name string\nfunction expect.no_lease(name) end"},
    {"expect.head", "expect.head(1.1, -0.1)", "The head is asked to turn there (yaw, pitch, rad).",
     "---@param yaw number\n---@param pitch number\nfunction expect.head(yaw, pitch) end"},
    {"expect.walk", "expect.walk(0.2, 0, 0)", "The robot is asked to walk so (m/s, m/s, rad/s).",
     "---@param forward number\n---@param left number\n---@param turn number\nfunction expect.walk(forward, left, "
     "turn) end"},
    {"expect.get_up", "expect.get_up(true)", "The robot is asked, or is not asked, to get up.",
     "---@param wanted boolean\nfunction expect.get_up(wanted) end"},
    {"expect.log", "expect.log(\"picked up\")", "A log line of the last `advance` contains this.",
     "---@param text string\nfunction expect.log(text) end"},
    {"expect.action", "expect.action(\"put_down\")", "The scenario did this during the last `advance`.",
     "---@param name string\nfunction expect.action(name) end"},
    {"expect.verdict", "expect.verdict(true, \"right mark\")", "The scenario's verdict, and a part of its text.",
     "---@param succeeded boolean\n---@param text string\nfunction expect.verdict(succeeded, text) end"},
    {"expect.error", "expect.error(\"nil value\")",
     "A script failed so; without this, a failing script fails the test.",
     "---@param text string\nfunction expect.error(text) end"},
    {"expect.refused", "expect.refused(\"did you mean\")",
     "The reload was refused so; without this, that fails the test.",
     "---@param text string\nfunction expect.refused(text) end"},
    {"expect.equal", "expect.equal(count, 3)",
     "Two values are the same, tables field by field; the first is what was seen.",
     "---@param actual any\n---@param expected any\nfunction expect.equal(actual, expected) end"},
    {"expect.near", "expect.near(x, 1.5, 0.1)", "Two numbers differ by no more than the third.",
     "---@param actual number\n---@param expected number\n---@param tolerance number\nfunction expect.near(actual, "
     "expected, tolerance) end"},
};

constexpr LibraryRow kLibrary[] = {
    {"",
     "assert error getmetatable ipairs pairs pcall rawequal rawget rawlen rawset select setmetatable tonumber tostring "
     "type xpcall"},
    {"math",
     "abs acos asin atan ceil cos deg exp floor fmod huge log max maxinteger min mininteger modf pi rad random sin "
     "sqrt tan tointeger "
     "type ult"},
    {"string", "byte char find format gmatch gsub len lower match rep reverse sub upper"},
    {"table", "concat insert move pack remove sort unpack"},
};

}  // namespace

std::span<const ScriptWord> language_words() { return kLanguage; }
std::span<const ScriptWord> test_words() { return kTest; }
std::span<const LibraryRow> library_rows() { return kLibrary; }

}  // namespace reorient
