// SPDX-License-Identifier: MIT
// Starts the program of the test in another process.
#pragma once

#include <filesystem>
#include <string>

namespace reorient {

/// The command for a shell. An emulator runs a program for another type of processor (cmake/targets.cmake).
inline std::string this_program() {
  std::string command;
#ifdef REORIENT_EMULATOR
  command = REORIENT_EMULATOR " ";
#endif
  return command + "'" + std::filesystem::read_symlink("/proc/self/exe").string() + "'";
}

}  // namespace reorient
