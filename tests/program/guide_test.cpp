// SPDX-License-Identifier: MIT
// Runs the guides: writes their files, applies their edits, calls their commands, and compares the output with the
// shown output.
#include <algorithm>
#include <fstream>
#include <ostream>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>

#include "tests/program/child_program.h"
#include "tests/program/program_run.h"
#include "tests/temporary_folder.h"
#include "workbench/files/input_file.h"

namespace reorient {
namespace {

/// A fenced code block.
struct Block {
  std::string kind;  ///< "lua", "console", ...
  std::string file;  ///< the file that it writes or edits; may be empty
  int line = 0;
  std::vector<std::string> lines;
};

std::vector<Block> blocks_of(const std::filesystem::path& guide) {
  std::ifstream in(guide);
  std::vector<Block> blocks;
  bool inside = false;
  int number = 0;
  for (std::string line; std::getline(in, line);) {
    ++number;
    if (!line.starts_with("```")) {
      if (inside) blocks.back().lines.push_back(line);
      continue;
    }
    inside = !inside;
    if (!inside) continue;
    std::istringstream words(line.substr(3));
    Block block;
    words >> block.kind >> block.file;
    block.line = number;
    blocks.push_back(std::move(block));
  }
  return blocks;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(in, line);) lines.push_back(line);
  return lines;
}

/// "..." at the start or end of a line matches any text.
bool fits(std::string_view shown, std::string_view seen) {
  constexpr std::string_view kAny = "...";
  if (shown.starts_with(kAny)) return seen.ends_with(shown.substr(kAny.size()));
  if (shown.ends_with(kAny)) return seen.starts_with(shown.substr(0, shown.size() - kAny.size()));
  return shown == seen;
}

/// A line "..." matches any lines.
bool matches(const std::vector<std::string>& shown, std::size_t i, const std::vector<std::string>& seen,
             std::size_t j) {
  if (i == shown.size()) return j == seen.size();
  if (shown[i] == "...") return matches(shown, i + 1, seen, j) || (j < seen.size() && matches(shown, i, seen, j + 1));
  if (j == seen.size()) return false;
  return fits(shown[i], seen[j]) && matches(shown, i + 1, seen, j + 1);
}

struct Page {
  const char* file;
  int least_commands;  ///< commands that it calls, or lines of a dialogue
};
std::ostream& operator<<(std::ostream& out, const Page& page) { return out << page.file; }

class Guide : public ::testing::TestWithParam<Page> {
 protected:
  Guide() { copy_scripts(folder_.path()); }

  void write(const Block& block) const {
    std::string text;
    for (const std::string& line : block.lines) text += line + "\n";
    folder_.write(block.file, text);
  }

  void edit(const Block& block) const {
    std::string from, to;
    for (const std::string& line : block.lines) (line.starts_with('-') ? from : to) += line.substr(1);
    std::string text = read_input(folder_.path() / block.file, "a file");
    const std::size_t at = text.find(from);
    ASSERT_NE(at, std::string::npos) << "line " << block.line << ": " << block.file << " has no '" << from << "'";
    folder_.write(block.file, text.replace(at, from.size(), to));
  }

  void call(const Block& block) const {
    const std::string prompt = "$ ./reorient ";
    ASSERT_FALSE(block.lines.empty());
    ASSERT_TRUE(block.lines[0].starts_with(prompt)) << "line " << block.line;
    std::vector<std::string> words;
    std::istringstream in(block.lines[0].substr(prompt.size()));
    for (std::string word; in >> word;) words.push_back(word);
    if (words.at(0) == "test") words = patiently(words);
    words.insert(words.begin(), {"--log", "off"});
    const bool reads_scripts = std::none_of(words.begin(), words.end(), [](const std::string& word) {
      return word == "compare" || word == "replay" || word == "recording";
    });
    if (reads_scripts) words.insert(words.end(), {"--scripts", (folder_.path() / "scripts").string()});
    ChildProgram run(folder_.path(), words, [&] {
      if (chdir(folder_.path().c_str()) != 0) _exit(127);
    });
    run.wait();
    const std::vector<std::string> shown(block.lines.begin() + 1, block.lines.end());
    EXPECT_TRUE(matches(shown, 0, lines_of(run.out()), 0))
        << "line " << block.line << ": " << block.lines[0] << " printed\n"
        << run.out() << run.err();
  }

  /// A run with its prompt, which gets the lines after "> " and must answer with the others.
  void talk(const Block& block) const {
    const std::string prompt = "$ ./reorient ";
    ASSERT_TRUE(block.lines.at(0).starts_with(prompt)) << "line " << block.line;
    std::vector<std::string> words{"--log", "off"};
    std::istringstream in(block.lines[0].substr(prompt.size()));
    for (std::string word; in >> word;) words.push_back(word);
    words.insert(words.end(), {"--no-pictures", "--seconds", "60"});
    std::string typed = "\n", shown;
    for (std::size_t i = 1; i < block.lines.size(); ++i) {
      if (block.lines[i].starts_with("> ")) typed += block.lines[i].substr(2) + "\n";
      shown += block.lines[i] + "\n";
    }
    const std::filesystem::path input = folder_.write("typed.txt", typed);
    ChildProgram run(folder_.path(), words, [&] { dup2(open(input.c_str(), O_RDONLY), STDIN_FILENO); });
    run.wait();
    EXPECT_EQ(run.out().substr(0, shown.size()), shown) << "line " << block.line << run.err();
  }

  TemporaryFolder folder_;
};

TEST_P(Guide, ShowsTheRealOutput) {
  int commands = 0;
  for (const Block& block : blocks_of(kProjectFolder / GetParam().file)) {
    if (block.kind == "console") {
      call(block);
      ++commands;
    } else if (block.kind == "dialogue") {
      talk(block);
      commands += static_cast<int>(block.lines.size());
    } else if (block.kind == "diff") {
      edit(block);
    } else if ((block.kind == "lua" || block.kind == "toml") && !block.file.empty()) {
      write(block);
    }
  }
  EXPECT_GE(commands, GetParam().least_commands);
}

INSTANTIATE_TEST_SUITE_P(Docs, Guide,
                         ::testing::Values(Page{"README.md", 1}, Page{"docs/first-behavior.md", 5},
                                           Page{"docs/prompt.md", 5}, Page{"docs/experiments.md", 5},
                                           Page{"docs/recordings.md", 5}),
                         [](const auto& page) {
                           std::string name = std::filesystem::path(page.param.file).stem().string();
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace reorient
