// SPDX-License-Identifier: MIT
// Runs tasks in several processes: a crash ends one task, and the others continue.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace reorient {

/// What became of a task.
struct TaskEnd {
  int number = 0;
  std::string mistake;  ///< one line; empty: it is done
  int signal = 0;       ///< that ended its process; 0: none did
  bool is_done() const { return mistake.empty() && signal == 0; }
};

/// `work` is called in one of `jobs` processes, each of which takes one task after the other; what it throws is told.
/// `tell` and `stop` are called here; once `stop` says so, or `tell` that it has seen enough (false), what is running
/// is ended at once. Throws std::system_error where there are no processes to be had.
void run_in_processes(const std::vector<int>& tasks, int jobs, const std::function<void(int task)>& work,
                      const std::function<bool(const TaskEnd& end)>& tell, const std::function<bool()>& stop);

}  // namespace reorient
