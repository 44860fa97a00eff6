// SPDX-License-Identifier: MIT
#include "program/program_output.h"

#include <algorithm>
#include <cstdlib>

#include <sys/ioctl.h>
#include <unistd.h>

#include "engine/parameters/utf8.h"

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

std::optional<int> terminal_columns(int descriptor) {
  constexpr int kMost = 2000;
  winsize size{};
  if (ioctl(descriptor, TIOCGWINSZ, &size) != 0 || size.ws_col == 0) return 80;
  if (size.ws_col > kMost || size.ws_row > kMost) return std::nullopt;
  return size.ws_col;
}

void show_status(std::ostream& err, bool is_terminal, const std::string& text) {
  if (!is_terminal) {
    err << text << '\n' << std::flush;
    return;
  }
  // A terminal may begin the next row as soon as a row is full.
  std::string line =
      text.substr(0, static_cast<std::size_t>(std::max(1, terminal_columns(STDERR_FILENO).value_or(80) - 1)));
  while (!is_utf8(line)) line.pop_back();
  clear_terminal_line(err);
  err << line << std::flush;
}

/// NO_COLOR: https://no-color.org
bool are_colors_printed(std::string_view asked, int descriptor) {
  if (asked != "auto") return asked == "always";
  const char* const no_color = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  return (no_color == nullptr || *no_color == '\0') && isatty(descriptor) == 1 && terminal != nullptr &&
         std::string_view(terminal) != "dumb";
}

}  // namespace reorient
