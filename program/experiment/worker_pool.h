// SPDX-License-Identifier: MIT
// Runs tasks in several processes: a crash ends one task, and the others continue.
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace reorient {

/// The outcome of a task.
struct TaskEnd {
  int number = 0;
  std::string mistake;  ///< one line; empty: success
  int signal = 0;       ///< that ended its process; 0: none
  bool is_done() const { return mistake.empty() && signal == 0; }
};

/// Calls `work` in one of `jobs` processes, each of which runs one task after the other; reports its exceptions as
/// mistakes. Calls `tell` and `stop` in this process. If `stop` returns true or `tell` returns false, the running tasks
/// are ended at once. Throws std::system_error if a process cannot be created.
void run_in_processes(const std::vector<int>& tasks, int jobs, const std::function<void(int task)>& work,
                      const std::function<bool(const TaskEnd& end)>& tell, const std::function<bool()>& stop);

}  // namespace reorient
