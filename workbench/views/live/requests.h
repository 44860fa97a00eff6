// SPDX-License-Identifier: MIT
// Requests of viewers to the thread of the frames, and its answers: values in bounded mailboxes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/parameters/parameter.h"
#include "engine/record/frame_record.h"
#include "engine/script/machine/machine_definition.h"
#include "engine/script/script_output.h"
#include "engine/script/script_texts.h"
#include "workbench/run/observer.h"
#include "workbench/run/run_controls.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"

namespace reorient::live {

using ViewerId = std::uint64_t;

/// An answer of the prompt, as whole lines: called after each frame, beginning with the frame of the request. Nothing:
/// wait for a later frame.
using PromptReply = std::function<std::optional<std::string>(const FrameRecord& frame, const SceneTruth& scene)>;

// What the thread of the frames does for a viewer.
struct ListParameters {};
struct ChangeParameters {
  std::vector<ParameterText> changes;
};
struct UndoChange {};
struct AddNote {
  std::string text;
};
struct ReloadScripts {
  std::vector<ScriptEdit> edits;
};
/// A command of the prompt that changes nothing.
struct AskPrompt {
  std::vector<std::string> words;
};
/// The definition of a machine of a behavior or of the scenario, as it runs.
struct DescribeMachine {
  std::string name;
};
/// What the operator can do, and the pace of the run.
struct ShowRun {};
struct ActAsOperator {
  OperatorRequest request;
};
struct ChangePace {
  enum class Change { pause, resume, frame, speed };
  Change change = Change::pause;
  int frames = 1;      ///< of `frame`
  double speed = 1.0;  ///< of `speed`
};
using FrameTask = std::variant<ListParameters, ChangeParameters, UndoChange, AddNote, ReloadScripts, AskPrompt,
                               DescribeMachine, ShowRun, ActAsOperator, ChangePace>;

/// A machine, and the texts of the scripts that declare it.
struct RunningMachine {
  MachineDefinition definition;
  ScriptTexts texts;
};

/// Where the answer goes: a message with parameters, or the response of a service.
struct AnswerAddress {
  ViewerId viewer = 0;  ///< 0: no viewer asked; the parameters have changed
  std::optional<std::string> request{};
  std::vector<std::string> names{};  ///< parameters to send; empty: all
  std::uint32_t service = 0, call = 0;
  std::size_t row = 0;  ///< of kServices, if service is not 0
  std::string file{};   ///< to be written with the answer; empty: none
};

struct FrameRequest {
  AnswerAddress to;
  FrameTask task;
};

struct RunState {
  bool has_operator = false, sets_pace = false;  ///< as of RunControls; both false in a replay
  bool is_paused = false;
  double speed = 1.0;
};

struct FrameAnswer {
  AnswerAddress to;
  double time = 0.0;                                           ///< s, of the frame
  std::shared_ptr<const std::vector<Parameter>> parameters{};  ///< now; nullptr: not read
  std::vector<ParameterChange> kept{};                         ///< of scripts that are not loaded
  std::vector<ParameterOutcome> outcomes{};
  std::vector<ReloadRecord> reloads{};
  std::shared_ptr<const RunningMachine> machine{};  ///< nullptr: not requested
  RunState run{};
  std::string text{};       ///< of the prompt
  std::string backup{};     ///< of the file that was replaced; empty: none
  std::string failure{};    ///< one line; empty: it succeeded
  bool is_delayed = false;  ///< no answer yet: the change waits for the next frame of a paused run
};

/// A bounded queue between two threads.
template <typename Value>
class BoundedQueue {
 public:
  explicit BoundedQueue(std::size_t most) : most_(most) {}

  /// False: it is full.
  bool add(Value value) {
    const std::lock_guard lock(mutex_);
    if (values_.size() >= most_) return false;
    values_.push_back(std::move(value));
    return true;
  }
  std::optional<Value> take() {
    const std::lock_guard lock(mutex_);
    if (values_.empty()) return std::nullopt;
    std::optional<Value> value = std::move(values_.front());
    values_.pop_front();
    return value;
  }

 private:
  const std::size_t most_;
  std::mutex mutex_;
  std::deque<Value> values_;
};

}  // namespace reorient::live
