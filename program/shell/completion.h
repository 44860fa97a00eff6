// SPDX-License-Identifier: MIT
// What can follow on a command line, for the completion of shells (assets/completion).
#pragma once

#include <span>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace reorient {

struct Completion {
  struct Candidate {
    std::string word;
    std::string text;  ///< what it is; may be empty
  };
  std::vector<Candidate> candidates;  ///< those that begin with the last word
  bool files = false;                 ///< the word may also be a file
  bool folders = false;               ///< the word may also be a folder
};

/// `words`: those behind the program's name; the last one is to be completed and may be empty. Never throws for what
/// the user has typed so far: unknown words are skipped.
Completion completion_of(const CLI::App& program, std::span<const std::string> words);

}  // namespace reorient
