// SPDX-License-Identifier: MIT
#include "program/program_output.h"

#include <cstdlib>

#include <unistd.h>

namespace reorient {

std::string_view sequence_of(Color color) {
  switch (color) {
    case Color::green:
      return "\x1B[32m";
    case Color::yellow:
      return "\x1B[33m\x1B[1m";
    case Color::red:
      return "\x1B[31m\x1B[1m";
    case Color::cyan:
      return "\x1B[36m";
  }
  return "";
}

void print_control(std::ostream& out, std::string_view sequence) {
  if (auto* const output = dynamic_cast<ProgramOutput*>(out.rdbuf()); output != nullptr)
    output->put_control(sequence);
  else
    out << sequence << std::flush;
}

void print_colored(std::ostream& out, Color color, std::string_view text) {
  auto* const output = dynamic_cast<ProgramOutput*>(out.rdbuf());
  const bool is_colored = output != nullptr && output->is_colored;
  if (is_colored) output->put_control(sequence_of(color));
  out << text;
  if (is_colored) output->put_control(kColorEnd);
}

void clear_terminal_line(std::ostream& out) { print_control(out, "\r\x1B[K"); }

/// NO_COLOR: https://no-color.org
bool are_colors_printed(std::string_view asked, int descriptor) {
  if (asked != "auto") return asked == "always";
  const char* const no_color = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return (no_color == nullptr || *no_color == '\0') && isatty(descriptor) == 1 && terminal != nullptr &&
         std::string_view(terminal) != "dumb";
}

}  // namespace reorient
