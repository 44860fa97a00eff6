// SPDX-License-Identifier: MIT
// How a test calls its own program once more.
#pragma once

#include <filesystem>
#include <string>

namespace reorient {

/// For a shell. A program for another kind of processor is run by an emulator (cmake/targets.cmake).
inline std::string this_program() {
  std::string command;
#ifdef REORIENT_EMULATOR
  command = REORIENT_EMULATOR " ";
#endif
  return command + "'" + std::filesystem::read_symlink("/proc/self/exe").string() + "'";
}

}  // namespace reorient
