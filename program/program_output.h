// SPDX-License-Identifier: MIT
// The streams of the program: text, and the program's own control sequences, which only it may send to a terminal.
#pragma once

#include <optional>
#include <ostream>
#include <streambuf>
#include <string>
#include <string_view>

namespace reorient {

/// A buffer whose text cannot control the terminal.
class ProgramOutput : public std::streambuf {
 public:
  /// Writes a control sequence behind the text so far, and flushes.
  virtual void put_control(std::string_view sequence) = 0;

  bool is_colored = false;  ///< whether to print colors
};

enum class Color { green, yellow, red, cyan };

/// The control sequences that begin and end a color.
std::string_view sequence_of(Color color);
inline constexpr std::string_view kColorEnd = "\x1B[0m";

/// Writes one of the program's own control sequences. A stream without ProgramOutput takes it as text.
void print_control(std::ostream& out, std::string_view sequence);

/// Prints the text in a color, if the stream is a ProgramOutput that prints colors.
void print_colored(std::ostream& out, Color color, std::string_view text);

/// Clears the line of the terminal, behind everything that the stream contains so far.
void clear_terminal_line(std::ostream& out);

/// Columns of a terminal: 80 if it does not know, nothing for a size that no terminal has.
std::optional<int> terminal_columns(int descriptor);

/// Shows a status on `err`, the standard error: on a terminal in the place of the last one, cut to one row because more
/// could not be overwritten; elsewhere as a line.
void show_status(std::ostream& err, bool is_terminal, const std::string& text);

/// Whether to print colors to a descriptor. `asked`: always, never or auto (on a terminal, unless NO_COLOR is set).
bool are_colors_printed(std::string_view asked, int descriptor);

}  // namespace reorient
