// SPDX-License-Identifier: MIT
#include "program/run/live/live_what_if.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include <nlohmann/json.hpp>

#include "engine/parameters/utf8.h"
#include "workbench/views/live/protocol/client_json.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"

namespace reorient {
namespace {

using WhatIfJson = nlohmann::ordered_json;

constexpr std::size_t kMostTriedParameters = 200, kMostTriedScripts = 20;
constexpr std::size_t kMostWhatIfEvents = 1000, kMostWhatIfStates = 2000;
constexpr double kTriedSeconds = 30.0, kMostTriedSeconds = 600.0;

[[noreturn]] void refuse_count(const char* what, std::size_t most, std::size_t found) {
  throw live::BadClientMessage("what_if: " + std::string(what) + ": expected at most " + std::to_string(most) +
                               ", found " + std::to_string(found));
}

std::vector<ParameterChange> parameters_of(const live::ClientObject& request, const std::string& payload) {
  std::vector<ParameterChange> changes;
  if (!request.json().contains("parameters")) return changes;
  const std::vector<live::ParameterText> texts = live::read_parameter_texts(payload);
  if (texts.size() > kMostTriedParameters) refuse_count("parameters", kMostTriedParameters, texts.size());
  for (const live::ParameterText& one : texts) {
    if (!one.value)
      throw live::BadClientMessage("what_if: " + as_line(one.name.substr(0, 100)) + ": expected a value, found none");
    changes.push_back({one.name, *one.value, ParameterOrigin::live, ""});
  }
  return changes;
}

std::vector<ScriptEdit> scripts_of(const live::ClientObject& request) {
  std::vector<ScriptEdit> edits;
  if (!request.json().contains("scripts")) return edits;
  const std::vector<live::ClientObject> scripts = request.objects("scripts");
  if (scripts.size() > kMostTriedScripts) refuse_count("scripts", kMostTriedScripts, scripts.size());
  edits.reserve(scripts.size());
  for (const live::ClientObject& one : scripts) edits.push_back({one.text("file"), ScriptText{one.text("text"), ""}});
  return edits;
}

/// Few digits, because a page draws it.
double rounded(double value) {
  constexpr double kSteps = 1e4;
  return std::isfinite(value) ? std::round(value * kSteps) / kSteps : 0.0;
}

WhatIfJson curves(const std::vector<WhatIfAnswer::Frame>& frames, WhatIfMoment WhatIfAnswer::Frame::*run) {
  WhatIfJson evidence = WhatIfJson::array(), current = evidence, opposite = evidence, status = evidence;
  for (const WhatIfAnswer::Frame& frame : frames) {
    const WhatIfMoment& moment = frame.*run;
    evidence.push_back(rounded(moment.evidence));
    current.push_back(rounded(moment.current));
    opposite.push_back(rounded(moment.opposite));
    status.push_back(to_string(moment.status));
  }
  return {{"evidence", std::move(evidence)},
          {"current", std::move(current)},
          {"opposite", std::move(opposite)},
          {"status", std::move(status)}};
}

WhatIfJson event_json(const ReplayComparison::Event& event) {
  return {{"time", event.time}, {"text", as_utf8(event.text)}, {"recorded", event.recorded}, {"tried", event.replayed}};
}

/// The changes of state in both runs, or in one.
WhatIfJson states_json(const std::vector<WhatIfAnswer::Frame>& frames) {
  WhatIfJson all = WhatIfJson::array();
  const auto add = [&](double time, const std::pair<std::string, std::string>& change, bool recorded, bool tried) {
    if (all.size() == kMostWhatIfStates) return;
    all.push_back({{"time", time},
                   {"machine", as_utf8(change.first)},
                   {"state", as_utf8(change.second)},
                   {"recorded", recorded},
                   {"tried", tried}});
  };
  for (const WhatIfAnswer::Frame& frame : frames) {
    for (const auto& change : frame.recorded.states) {
      const auto& tried = frame.tried.states;
      add(frame.time, change, true, std::find(tried.begin(), tried.end(), change) != tried.end());
    }
    for (const auto& change : frame.tried.states) {
      const auto& recorded = frame.recorded.states;
      if (std::find(recorded.begin(), recorded.end(), change) == recorded.end()) add(frame.time, change, false, true);
    }
  }
  return all;
}

}  // namespace

std::shared_ptr<live::WhatIf> make_what_if(const LiveOptions& options, LiveLoad load) {
  const std::size_t most = live_memory(options, load);
  return most > 0 ? std::make_shared<LiveWhatIf>(most) : nullptr;
}

WhatIfQuestion read_what_if(const std::string& payload, double end) {
  const live::ClientObject request("what_if", payload.empty() ? "{}" : payload);
  WhatIfQuestion question{{parameters_of(request, payload), scripts_of(request)}, 0.0, end};
  if (question.changes.parameters.empty() && question.changes.scripts.empty())
    throw live::BadClientMessage("what_if: expected parameters or scripts to try, found none");
  if (const auto to = request.optional_real("to")) question.to = std::min(*to, end);
  const double seconds = request.optional_real("seconds").value_or(kTriedSeconds);
  if (seconds <= 0.0 || seconds > kMostTriedSeconds)
    throw live::BadClientMessage("what_if: seconds: expected a number above 0, up to 600");
  question.from = question.to - seconds;
  return question;
}

std::string what_if_json(const WhatIfAnswer& answer, double seconds) {
  WhatIfJson time = WhatIfJson::array(), events = WhatIfJson::array();
  for (const WhatIfAnswer::Frame& frame : answer.frames) time.push_back(rounded(frame.time));
  for (const ReplayComparison::Event& event : answer.events)
    if (events.size() < kMostWhatIfEvents) events.push_back(event_json(event));
  WhatIfJson json{{"from", answer.frames.front().time},
                  {"to", answer.frames.back().time},
                  {"frames", answer.frames.size()},
                  {"gap", answer.has_gap},
                  {"seconds", rounded(seconds)}};
  json["first_decision"] = nullptr;
  json["guess_from"] = nullptr;
  json["first_action"] = nullptr;
  if (answer.first_decision) json["first_decision"] = event_json(*answer.first_decision);
  if (answer.first_action) {
    const Difference& action = *answer.first_action;
    json["guess_from"] = action.time;
    json["first_action"] = {{"time", action.time},
                            {"what", as_utf8(action.what)},
                            {"recorded", as_utf8(action.recorded)},
                            {"tried", as_utf8(action.replayed)}};
  }
  json["time"] = std::move(time);
  json["recorded"] = curves(answer.frames, &WhatIfAnswer::Frame::recorded);
  json["tried"] = curves(answer.frames, &WhatIfAnswer::Frame::tried);
  json["states"] = states_json(answer.frames);
  json["events"] = std::move(events);
  return json.dump(-1, ' ', false, WhatIfJson::error_handler_t::replace);
}

std::string LiveWhatIf::answer(const std::string& payload, const std::function<bool()>& stop) {
  const auto begin = std::chrono::steady_clock::now();
  const WhatIfQuestion question = read_what_if(payload, frames_.counts().end);
  const WhatIfAnswer answer = what_if(*frames_.frames(), question, stop);
  return what_if_json(answer, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
}

}  // namespace reorient
