// SPDX-License-Identifier: MIT
// One write to a disk at a time, beside a run that does not wait for it.
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
  /// `write` runs in a thread of its own. Its exception becomes a warning in the log, once it is over. Waits where it
  /// is_busy().
  void start(std::function<void()> write);
  /// Waits for what was started.
  void end();

 private:
  std::future<std::string> mistake_;  // or nothing
};

}  // namespace reorient
