// SPDX-License-Identifier: MIT
// The part of the live view in the thread of the frames: requests of viewers become inputs of the next frame, and the
// frame's record answers them, as for the prompt.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "engine/frame.h"
#include "engine/frame_inputs.h"
#include "workbench/scenario/parameter_edits.h"
#include "workbench/scenario/scenario_host.h"
#include "workbench/views/live/requests.h"
#include "workbench/views/live/what_ifs.h"

namespace reorient::live {

/// The objects that viewers see and change. The functions are called in the thread of the frames.
struct LiveSubject {
  ScenarioHost* scenario = nullptr;                               ///< may be nullptr
  std::function<std::vector<Parameter>()> parameters;             ///< all existing parameters
  std::function<std::vector<ParameterChange>()> kept_parameters;  ///< of scripts that are not loaded; may be empty
  std::filesystem::path scripts;                                  ///< their root
  /// Executes a command of the prompt that changes nothing. Throws std::runtime_error with one line. May be empty.
  std::function<PromptReply(const std::vector<std::string>& words)> ask;
  RunControls* controls = nullptr;           ///< nullptr: a replay
  std::function<const FrameLoop*()> engine;  ///< that of the running behaviors; nullptr: no robot; may be empty
  std::shared_ptr<WhatIf> what_if{};         ///< nullptr: the run keeps no frames
};

class FrameTasks {
 public:
  explicit FrameTasks(LiveSubject subject) : subject_(std::move(subject)) {}

  const LiveSubject& subject() const { return subject_; }

  /// Adds the request to the inputs of the next frame.
  void begin(FrameRequest request, FrameInputs& inputs);
  /// After the frame: appends the answers that are ready.
  void answer(const FrameRecord& frame, const SceneTruth& scene, std::vector<FrameAnswer>& answers);
  /// The same between two frames of a paused run: appends the answers that do not need the next frame. `last`,
  /// `scene`: the last frame.
  void answer_while_paused(const FrameRecord& last, const SceneTruth& scene, std::vector<FrameAnswer>& answers);
  /// Answers the request without a frame: only parameters, machines and the state of the run can be read, because
  /// `reason`.
  FrameAnswer refuse(const FrameRequest& request, const std::string& reason) const;

  std::size_t pending() const { return pending_.size(); }
  /// The topics that pending answers read.
  Topics wanted() const;

 private:
  struct PendingChange {
    RequestedChange change;
    std::optional<std::uint64_t> number;  // with which it can be undone; nothing: it undoes another one
  };
  struct Pending {
    AnswerAddress to;
    std::vector<ParameterOutcome> refused;  // without a frame
    std::vector<PendingChange> changed;
    bool reads_parameters = true, reloads = false;
    bool needs_frame = false;  // the answer is in the next frame
    bool is_told = false;      // the viewer knows that it waits
    PromptReply reply;
    std::optional<std::string> machine;  // to be described
    std::string failure;
  };

  void start(ListParameters&& task, Pending& pending, FrameInputs& inputs);
  void start(ChangeParameters&& task, Pending& pending, FrameInputs& inputs);
  void start(UndoChange&& task, Pending& pending, FrameInputs& inputs);
  void start(AddNote&& task, Pending& pending, FrameInputs& inputs);
  void start(ReloadScripts&& task, Pending& pending, FrameInputs& inputs);
  void start(AskPrompt&& task, Pending& pending, FrameInputs& inputs);
  void start(DescribeMachine&& task, Pending& pending, FrameInputs& inputs);
  /// Adds the machine, or why it is missing.
  void describe_machine(const std::string& name, FrameAnswer& answer) const;
  void start(ShowRun&& task, Pending& pending, FrameInputs& inputs);
  void start(ActAsOperator&& task, Pending& pending, FrameInputs& inputs);
  void start(ChangePace&& task, Pending& pending, FrameInputs& inputs);
  RunControls& controls() const;
  RunState run_state() const;
  bool append_answer(Pending& pending, const FrameRecord& frame, const SceneTruth& scene,
                     std::vector<FrameAnswer>& answers);
  bool complete(Pending& pending, const FrameRecord& frame, const SceneTruth& scene, FrameAnswer& answer);

  LiveSubject subject_;
  std::vector<Pending> pending_;
  UndoableChanges before_;  // of all viewers
};

}  // namespace reorient::live
