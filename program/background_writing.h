// SPDX-License-Identifier: MIT
// Writes to a disk, one at a time, while the run continues.
#pragma once

#include <functional>
#include <future>
#include <string>

namespace reorient {

class BackgroundWriting {
 public:
  BackgroundWriting() = default;
  ~BackgroundWriting() { end(); }
  BackgroundWriting(const BackgroundWriting&) = delete;
  BackgroundWriting& operator=(const BackgroundWriting&) = delete;

  bool is_busy() const;
  /// Runs `write` in its own thread. Its exception becomes a warning in the log when it ends, unless mistake() is
  /// called. Waits if is_busy().
  void start(std::function<void()> write);
  /// Waits for the running write, and returns its error. Empty: success, or nothing was started.
  std::string mistake();
  /// Waits for the running write.
  void end();

 private:
  std::future<std::string> writing_;  // its error; empty: success
};

}  // namespace reorient
