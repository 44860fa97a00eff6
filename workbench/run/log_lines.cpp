// SPDX-License-Identifier: MIT
#include "workbench/run/log_lines.h"

#include <utility>

#include "engine/script/language/script_actions.h"

namespace reorient {
namespace {

using Level = LogLine::Level;

LogLine fault_line(std::string source, const std::string& text, const ScriptFault& fault) {
  return {Level::error, std::move(source), text, fault.file, fault.line};
}

void append_reloads(const std::vector<ReloadRecord>& reloads, std::vector<LogLine>& lines) {
  for (const ReloadRecord& reload : reloads) {
    if (reload.accepted) {
      lines.push_back({Level::info, reload.script, "the edit is running"});
    } else {
      lines.push_back(fault_line(reload.script, "edit rejected; keeping the previous version: " + reload.fault.text(),
                                 reload.fault));
    }
    for (const std::string& warning : reload.warnings) lines.push_back({Level::warning, reload.script, warning});
  }
}

void append_scripts(const NameTable& names, const std::vector<LogRecord>& logs, const std::vector<FaultRecord>& faults,
                    std::vector<LogLine>& lines) {
  for (const LogRecord& record : logs) {
    const std::string& machine = names[record.machine];
    lines.push_back({Level::info, machine, (record.is_note ? "note: " : "") + record.text, {}, 0, names[record.state]});
    if (record.dropped > 0)
      lines.push_back({Level::warning, machine,
                       std::to_string(record.dropped) +
                           " more lines in this frame were dropped; a machine can log at most " +
                           std::to_string(ScriptActions::kMostPerFrame)});
  }
  for (const FaultRecord& fault : faults) {
    using Consequence = FaultRecord::Consequence;
    const char* consequence = fault.consequence == Consequence::rolled_back ? "; the previous version runs again"
                              : fault.consequence == Consequence::stopped   ? "; it stays stopped until it is edited"
                                                                            : "";
    lines.push_back(fault_line("", fault.fault.text() + consequence, fault.fault));
  }
}

}  // namespace

std::vector<LogLine> log_lines(const FrameRecord& frame, const SceneTruth& scene) {
  std::vector<LogLine> lines;
  append_reloads(frame.reloads, lines);
  append_reloads(scene.scenario.reloads, lines);
  append_scripts(*frame.names, frame.logs, frame.faults, lines);
  for (const std::string& message : frame.answer.messages)
    lines.push_back({Level::info, "", "to the team: " + message});
  append_scripts(*scene.scenario.names, scene.scenario.logs, scene.scenario.faults, lines);
  return lines;
}

}  // namespace reorient
