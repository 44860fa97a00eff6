// SPDX-License-Identifier: MIT
// Questions of viewers about what the robot would have done: answered one after the other by a thread, never delaying a
// frame or other messages of the viewer.
#pragma once

#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

#include "workbench/run/observer.h"
#include "workbench/views/live/requests.h"
#include "workbench/views/live/viewers.h"

namespace reorient::live {

/// The memory of a run, and what answers from it.
class WhatIf {
 public:
  virtual ~WhatIf() = default;
  /// It is shown the frames while a viewer is connected, in the thread of the frames.
  virtual Observer& memory() = 0;
  /// JSON in and out. Called in another thread. Throws std::runtime_error with one line, also soon after `stop` has
  /// begun to return true.
  virtual std::string answer(const std::string& payload, const std::function<bool()>& stop) = 0;
};

class WhatIfs {
 public:
  /// Both must outlive it; without `what_if` (nullptr) each question is refused.
  WhatIfs(Viewers& viewers, WhatIf* what_if);
  ~WhatIfs();

  /// Replaces an earlier question of the same viewer, which is answered with a failure. Any thread may call it.
  void ask(const AnswerAddress& to, std::string payload);
  /// The viewer is gone.
  void forget(ViewerId viewer);

 private:
  struct Question {
    AnswerAddress to;
    std::string payload;
  };
  void fail(const AnswerAddress& to, const std::string& why);
  void answer_all();

  Viewers& viewers_;
  WhatIf* const what_if_;
  std::atomic<bool> is_stopped_ = false;  // the question that is being answered

  std::mutex mutex_;  // protects all members below
  std::condition_variable wake_;
  std::deque<Question> waiting_;  // at most one of each viewer
  ViewerId asker_ = 0;            // of the question that is being answered
  bool ends_ = false;
  std::thread thread_;  // begins with the first question
};

}  // namespace reorient::live
