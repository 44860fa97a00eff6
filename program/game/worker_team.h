// SPDX-License-Identifier: MIT
// A few threads that run the same task for many items, each item on one of them.
#pragma once

#include <atomic>
#include <barrier>
#include <cstddef>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace reorient {

class WorkerTeam {
 public:
  /// `threads`: with the one that calls run(), at least 1.
  explicit WorkerTeam(int threads);
  ~WorkerTeam();
  WorkerTeam(const WorkerTeam&) = delete;
  WorkerTeam& operator=(const WorkerTeam&) = delete;

  /// Calls task(0) to task(count - 1), and returns after the last one. No order is defined. Throws the exception of one
  /// of them.
  void run(std::size_t count, const std::function<void(std::size_t)>& task);

 private:
  void work();
  void work_off();

  std::barrier<> start_, end_;
  const std::function<void(std::size_t)>* task_ = nullptr;  // nullptr: the threads end
  std::size_t count_ = 0;
  std::atomic<std::size_t> next_ = 0;
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace reorient
