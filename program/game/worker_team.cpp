// SPDX-License-Identifier: MIT
#include "program/game/worker_team.h"

#include <utility>

namespace reorient {

WorkerTeam::WorkerTeam(int threads) : start_(threads), end_(threads) {
  for (int i = 1; i < threads; ++i) threads_.emplace_back([this] { work(); });
}

WorkerTeam::~WorkerTeam() {
  task_ = nullptr;
  start_.arrive_and_wait();
  for (std::thread& thread : threads_) thread.join();
}

void WorkerTeam::run(std::size_t count, const std::function<void(std::size_t)>& task) {
  task_ = &task;
  count_ = count;
  next_ = 0;
  start_.arrive_and_wait();
  work_off();
  end_.arrive_and_wait();
  if (failure_) std::rethrow_exception(std::exchange(failure_, nullptr));
}

void WorkerTeam::work() {
  for (;;) {
    start_.arrive_and_wait();
    if (task_ == nullptr) return;
    work_off();
    end_.arrive_and_wait();
  }
}

void WorkerTeam::work_off() {
  for (std::size_t item = next_++; item < count_; item = next_++) {
    try {
      (*task_)(item);
    } catch (...) {
      const std::lock_guard lock(mutex_);
      failure_ = std::current_exception();
    }
  }
}

}  // namespace reorient
