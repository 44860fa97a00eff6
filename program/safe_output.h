// SPDX-License-Identifier: MIT
// The program's output to a terminal or a log: foreign text in it cannot control the terminal.
#pragma once

#include <ostream>
#include <string>
#include <string_view>

#include "program/program_output.h"

namespace reorient {

/// Passes text on to another stream, with control characters escaped as by as_line(); only line ends and tabs stay.
/// Foreign text that could forge lines must be made a line by as_line() where it is printed, because a stream cannot
/// distinguish line ends.
class SafeOutput : public ProgramOutput {
 public:
  /// `out` must outlive this object.
  explicit SafeOutput(std::ostream& out) : out_(*out.rdbuf()) {}
  ~SafeOutput() override { SafeOutput::sync(); }
  SafeOutput(const SafeOutput&) = delete;
  SafeOutput& operator=(const SafeOutput&) = delete;

  bool writes_to(const std::ostream& stream) const { return stream.rdbuf() == &out_; }
  void put_control(std::string_view sequence) override;

 protected:
  int_type overflow(int_type letter) override;
  std::streamsize xsputn(const char* text, std::streamsize size) override;
  int sync() override;

 private:
  bool put(std::string_view text);

  std::streambuf& out_;
  std::string begun_;  ///< an incomplete letter, to be completed by the next bytes
};

/// Prints "reorient: " and the text as one line, at once.
void print_error(std::ostream& err, std::string_view text);

}  // namespace reorient
