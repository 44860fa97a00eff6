// SPDX-License-Identifier: MIT
// Output that a run never waits for: a terminal may be stopped (Ctrl-S), and the reader of a pipe may be slow.
#pragma once

#include <cstddef>
#include <memory>
#include <ostream>

namespace reorient {

/// While it exists, a thread writes what the run prints to its streams and logs. With more than kMost bytes in the
/// queue, further output is dropped, and a line says how much.
class OutputMailbox {
 public:
  static constexpr std::size_t kMost = std::size_t{1} << 20;

  /// Both streams must outlive it.
  OutputMailbox(std::ostream& out, std::ostream& err);
  /// Waits until everything is written, as a program that ends does.
  ~OutputMailbox();
  OutputMailbox(const OutputMailbox&) = delete;
  OutputMailbox& operator=(const OutputMailbox&) = delete;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace reorient
