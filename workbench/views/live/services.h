// SPDX-License-Identifier: MIT
// The services of the live view, one row for each: JSON in and out. The server, its docs and their tests use this
// table.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "workbench/views/live/requests.h"

namespace reorient::live {

enum class Service {
  parameter_list,
  set_parameters,
  undo,
  diff,
  save,
  note,
  scripts,
  script,
  check_script,
  save_script,
  reload,
  states,
  why,
  machine,
  world,
  what_if,
  file_parameters,
  run_state,
  operate,
  pace
};
inline constexpr std::size_t kServiceCount = 20;

struct ServiceRow {
  Service service;
  std::string_view name;
  bool changes;  ///< changes the run or writes a file, so it needs the token
  std::string_view description;
  std::string_view request;   ///< an example; its members are those of the request
  std::string_view response;  ///< an example
};

inline constexpr std::array<ServiceRow, kServiceCount> kServices{{
    {Service::parameter_list, "parameter_list", false, "all parameters", "{}",
     R"({"parameters":[{"name":"orientation.lingering","value":0.5,"default":0.5,"min":0.0,"max":30.0,"unit":"s","description":"...","origin":"default"}]})"},
    {Service::set_parameters, "set_parameters", true,
     "changes parameters from the next frame on; the response has the values in force, and why a value was refused",
     R"({"parameters":[{"name":"orientation.lingering","value":0.4}]})",
     R"({"parameters":[{"name":"orientation.lingering","value":0.4}],"refused":[{"name":"orientation.hold_time","reason":"..."}]})"},
    {Service::undo, "undo", true,
     "undoes the change of a parameter that a viewer requested last, also in a paused run; again: the one before", "{}",
     R"({"parameters":[{"name":"orientation.lingering","value":0.5}],"refused":[{"name":"orientation.lingering","reason":"..."}]})"},
    {Service::diff, "diff", false, "parameters that differ from their defaults, as the prompt prints them", "{}",
     R"({"text":"orientation.lingering = 0.4"})"},
    {Service::save, "save", true,
     "saves the parameters that differ from their defaults, in the folder in which the run was started; `backup`: the "
     "copy of the file that was replaced, or empty",
     R"({"file":"tuned.toml"})", R"({"file":"tuned.toml","backup":"tuned.toml.bak"})"},
    {Service::note, "note", true, "records a note at this time", R"({"text":"the referee moved it"})",
     R"({"time":12.5})"},
    {Service::scripts, "scripts", false, "the scripts and scripted tests below the folder of the scripts", "{}",
     R"({"files":["behaviors/orientation.lua"]})"},
    {Service::script, "script", false, "the text of one of these files", R"({"file":"behaviors/orientation.lua"})",
     R"({"file":"behaviors/orientation.lua","text":"..."})"},
    {Service::check_script, "check_script", false,
     "what `reorient check` finds in one of these files if its text is replaced by this one; at most 200 findings",
     R"({"file":"behaviors/orientation.lua","text":"..."})",
     R"({"findings":[{"file":"behaviors/orientation.lua","line":1,"column":1,"severity":"error","message":"..."}]})"},
    {Service::save_script, "save_script", true,
     "writes one of these files, if its text on the disk is still `expected`; else the file stays unchanged, and "
     "`saved` is false; the response has the text on the disk",
     R"({"file":"behaviors/orientation.lua","text":"...","expected":"..."})",
     R"({"file":"behaviors/orientation.lua","saved":true,"text":"..."})"},
    {Service::reload, "reload", true, "reloads a script, or all without the member, even if unchanged",
     R"({"script":"orientation"})",
     R"({"scripts":[{"script":"behaviors/orientation.lua","accepted":true,"problem":""}]})"},
    {Service::states, "states", false, "state and cost of each behavior, as the prompt prints them", "{}",
     R"({"text":"..."})"},
    {Service::why, "why", false, "transitions of a behavior's state, and what their conditions lack",
     R"({"machine":"orientation"})", R"({"text":"..."})"},
    {Service::machine, "machine", false,
     "definition of a running behavior or of the scenario: its states, and its transitions with the world fields that "
     "their conditions "
     "read; `time` is that of the frame",
     R"({"machine":"orientation"})",
     R"({"time":12.5,"machine":{"name":"orientation","file":"behaviors/orientation.lua","line":52,"scenario":false,"states":[{"path":"watching","name":"watching","outer":0,"initial":3,"history":false,"publishes":"","file":"behaviors/orientation.lua","line":61}],"transitions":[{"from":2,"to":4,"reason":"...","common":false,"when":true,"lasting":"hold_time","after":"","file":"behaviors/orientation.lua","line":63,"maker":"","reads":["confidence.status"]}]}})"},
    {Service::world, "world", false, "world fields and their values now", R"({"pattern":"pose.*"})",
     R"({"text":"..."})"},
    {Service::what_if, "what_if", true,
     "replays the last seconds with other parameters and scripts, without changing the run; a newer question of the "
     "same viewer replaces it",
     R"({"parameters":[{"name":"orientation.hold_time","value":2.0}],"scripts":[{"file":"behaviors/orientation.lua","text":"..."}],"seconds":30.0})",
     R"({"from":13.4,"to":43.4,"frames":900,"gap":false,"seconds":0.7,"first_decision":{"time":43.4,"text":"...","recorded":true,"tried":false},"guess_from":43.4,"first_action":{"time":43.4,"what":"reorientation","recorded":"flip_pose","tried":"nothing"},"time":[13.4],"recorded":{"evidence":[0.0],"current":[0.0],"opposite":[0.0],"status":["resting"]},"tried":{"evidence":[0.0],"current":[0.0],"opposite":[0.0],"status":["resting"]},"states":[{"time":13.4,"machine":"orientation","state":"watching/unconfirmed","recorded":true,"tried":true}],"events":[{"time":43.4,"text":"...","recorded":true,"tried":false}]})"},
    {Service::file_parameters, "file_parameters", false,
     "the parameters of a file that `save` wrote, with their values as text", R"({"file":"tuned.toml"})",
     R"({"file":"tuned.toml","parameters":[{"name":"orientation.lingering","value":"0.4"}]})"},
    {Service::run_state, "run_state", false,
     "whether this run has an operator, whether its pace can be set, and the pace", "{}",
     R"({"operator":true,"pace":true,"paused":false,"speed":1.0,"time":12.5})"},
    {Service::operate, "operator", true, "an action of the operator, before the next frame",
     R"({"action":"put_down","x":-3.0,"y":1.5,"degrees":90.0})", R"({"time":12.5})"},
    {Service::pace, "pace", true, "pauses or resumes the run, runs single frames, or sets the speed",
     R"({"action":"speed","factor":2.0})", R"({"operator":true,"pace":true,"paused":false,"speed":2.0,"time":12.5})"},
}};

/// The ids of services begin at 1.
constexpr std::uint32_t id_of(Service service) { return static_cast<std::uint32_t>(service) + 1; }
/// The rows as messages of the protocol describe them.
std::string advertise_live_services();

/// The service with this id; nullptr: unknown.
const ServiceRow* find_service(std::uint32_t id);

/// The request as a task of the thread of the frames. `to.file` is set for `save`. Throws BadClientMessage with one
/// line. Not for the services of script_services.h.
FrameTask read_service_request(const ServiceRow& row, const std::string& payload, AnswerAddress& to);

/// The response of `file_parameters`. It takes as long as the disk takes, so never call it in the thread of the frames.
/// Throws std::runtime_error or BadClientMessage with one line.
std::string file_parameters(const std::string& payload);

/// The JSON of the response. The answer has no failure.
std::string service_answer(const ServiceRow& row, const FrameAnswer& answer);

}  // namespace reorient::live
