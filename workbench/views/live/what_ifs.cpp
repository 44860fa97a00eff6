// SPDX-License-Identifier: MIT
#include "workbench/views/live/what_ifs.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "engine/parameters/utf8.h"
#include "workbench/run/batch_thread.h"
#include "workbench/views/live/protocol/foxglove_protocol.h"

namespace reorient::live {

WhatIfs::WhatIfs(Viewers& viewers, WhatIf* what_if) : viewers_(viewers), what_if_(what_if) {}

WhatIfs::~WhatIfs() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
    is_stopped_ = true;
  }
  wake_.notify_one();
  if (thread_.joinable()) thread_.join();
}

void WhatIfs::fail(const AnswerAddress& to, const std::string& why) {
  viewers_.send(to.viewer, service_failure(to.service, to.call, as_line(why)));
}

void WhatIfs::ask(const AnswerAddress& to, std::string payload) {
  if (what_if_ == nullptr) return fail(to, "what_if: this run keeps no frames");
  std::deque<Question> replaced;
  {
    const std::lock_guard lock(mutex_);
    if (ends_) return;
    for (Question& one : waiting_)
      if (one.to.viewer == to.viewer) replaced.push_back(std::move(one));
    std::erase_if(waiting_, [&](const Question& one) { return one.to.viewer == to.viewer; });
    if (asker_ == to.viewer) is_stopped_ = true;
    waiting_.push_back({to, std::move(payload)});
    if (!thread_.joinable()) thread_ = std::thread([this] { answer_all(); });
  }
  wake_.notify_one();
  for (const Question& one : replaced) fail(one.to, "what_if: replaced by a newer question");
}

void WhatIfs::forget(ViewerId viewer) {
  const std::lock_guard lock(mutex_);
  std::erase_if(waiting_, [&](const Question& one) { return one.to.viewer == viewer; });
  if (asker_ == viewer) is_stopped_ = true;
}

/// Runs in the thread.
void WhatIfs::answer_all() {
  become_batch_thread(kLiveNiceness);
  std::unique_lock lock(mutex_);
  while (true) {
    wake_.wait(lock, [this] { return ends_ || !waiting_.empty(); });
    if (ends_) return;
    const Question question = std::move(waiting_.front());
    waiting_.pop_front();
    asker_ = question.to.viewer;
    is_stopped_ = false;
    lock.unlock();
    try {
      const std::string json = what_if_->answer(question.payload, [this] { return is_stopped_.load(); });
      viewers_.send(question.to.viewer, service_response(question.to.service, question.to.call, json));
    } catch (const std::exception& error) {
      fail(question.to, error.what());
    }
    lock.lock();
    asker_ = 0;
  }
}

}  // namespace reorient::live
