// SPDX-License-Identifier: MIT
// Runs the program as a user would, and returns what it printed.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include "program/program.h"
#include "tests/paths.h"

namespace reorient {

struct ProgramRun {
  int code = 0;
  std::string out;
  std::string err;
};

inline const std::filesystem::path kProjectFolder = kSourceFolder;

/// `words`: the command line without the program's name.
inline ProgramRun run_reorient(const std::vector<std::string>& words) {
  setenv("REORIENT_HOME", kSourceFolder, 1);
  std::vector<const char*> argv{"reorient"};
  for (const std::string& word : words) argv.push_back(word.c_str());
  std::ostringstream out, err;
  const int code = run_program(static_cast<int>(argv.size()), argv.data(), out, err);
  return {code, out.str(), err.str()};
}

/// `words` of `reorient test`, with the time that scripted tests take under an emulator: there a minute each is not
/// enough.
inline std::vector<std::string> patiently(std::vector<std::string> words) {
#ifdef REORIENT_EMULATOR
  words.insert(words.end(), {"--timeout", "3600"});
#endif
  return words;
}

/// A short run with small images that writes nothing, with more options at the end.
inline ProgramRun run_shortly(const std::vector<std::string>& more) {
  std::vector<std::string> words{"run", "--seconds", "3", "--width", "160", "--no-pictures", "--log", "off"};
  words.insert(words.end(), more.begin(), more.end());
  return run_reorient(words);
}

/// The printed digest; empty without one.
inline std::string digest_of(const ProgramRun& run) {
  const std::size_t place = run.out.rfind("digest: ");
  return place == std::string::npos ? std::string() : run.out.substr(place, 24);
}

/// A copy of the shipped scripts, which a test may break.
inline std::filesystem::path copy_scripts(const std::filesystem::path& folder) {
  std::filesystem::path copy = folder / "scripts";
  std::filesystem::copy(kProjectFolder / "scripts", copy, std::filesystem::copy_options::recursive);
  return copy;
}

}  // namespace reorient
